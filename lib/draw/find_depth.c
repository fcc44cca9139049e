/* SPDX-License-Identifier: MIT */
/* The depth of a face: from its corners on the screen where it is small, else from its normal. */
#include "submit.h"
#include "surface_polygon.h"

void fxl_find_depth(const fxl_model_view *model_view, const fxl_face *face,
                    const fxl_traversal *traversal, fxl_corner_planes *planes,
                    fxl_depth_plane *plane)
{
    if (planes != NULL) {
        fxl_corner_planes_depth(planes, plane);
    } else {
        fxl_find_depth_by_normal(model_view, face, traversal, plane);
    }
}

void fxl_depth_plane_find(const fxl_model_view *model_view, const fxl_face *face,
                          const fxl_traversal *traversal, fxl_depth_plane *plane)
{
    fxl_screen_corners corners;
    fxl_corner_planes planes;
    const bool is_small = model_view->indices == traversal->renderer->scene->indices &&
                          fxl_find_screen_corners(model_view, face, NULL, traversal, &corners) &&
                          fxl_corner_planes_begin(&corners, &model_view->view->lens, &planes);
    fxl_find_depth(model_view, face, traversal, is_small ? &planes : NULL, plane);
}

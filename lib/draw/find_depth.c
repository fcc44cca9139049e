/* SPDX-License-Identifier: MIT */
/* The depth of a face: from its corners on the screen where it is small, else from its normal. */
#include "submit.h"
#include "surface_polygon.h"

void fxl_find_depth(const fxl_model_view *model_view, const fxl_face *face,
                    const fxl_traversal *traversal, fxl_corner_planes *planes, bool has_words,
                    fxl_depth_plane *plane)
{
    if (planes != NULL && has_words && fxl_corner_planes_depth_words(planes, plane)) {
        return;
    }
    if (planes == NULL || planes->is_for_words) {
        fxl_find_depth_by_normal(model_view, face, traversal, plane);
    } else {
        fxl_corner_planes_depth(planes, plane);
    }
}

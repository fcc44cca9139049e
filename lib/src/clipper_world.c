/* SPDX-License-Identifier: MIT */
#include "fixel/clipper.h"
#include "fixel/cull.h"
#include "fixel/project.h"
#include "fixel/transform.h"

fxl_clip_result fxl_clip_by_world(const fxl_placed *placed, const fxl_face *face,
                                  fxl_clipper_work *work, fxl_screen_polygon *screen)
{
    fxl_view *view = placed->view;
    fxl_polygon *polygon = &work->by_world.polygons[0];
    const fxl_polygon *clipped;
    fxl_face_to_polygon(placed, face, polygon);
    fxl_clip_result result =
        fxl_clip_to_frustum(polygon, fxl_view_world_frustum(view), &work->by_world, &clipped);
    if (clipped == NULL) {
        return result;
    }
    for (uint32_t i = 0; i < clipped->count; i++) {
        fxl_view_point seen;
        fxl_transform_point(&view->camera, &clipped->vertices[i].position, &seen);
        if (fxl_project_seen(&view->projection, &seen, &screen->points[i]) != FXL_OK) {
            return FXL_CLIP_RANGE;
        }
    }
    screen->colour = clipped->colour;
    screen->count = clipped->count;
    return result;
}

const fxl_clipper fxl_clipper_world = {.clip = fxl_clip_by_world};

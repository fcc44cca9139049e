/* SPDX-License-Identifier: MIT */
#include "fixel/clipper.h"

fxl_clip_result fxl_clip_by_world(const fxl_polygon *polygon, const fxl_view *view,
                                  fxl_clipper_work *work, const fxl_view_polygon **result)
{
    const fxl_polygon *clipped;
    fxl_clip_result cut = fxl_clip_to_frustum(polygon, &view->frustum, &work->by_world, &clipped);
    *result = NULL;
    if (clipped != NULL) {
        fxl_transform_polygon(&view->camera, clipped, &work->from_world.view);
        *result = &work->from_world.view;
    }
    return cut;
}

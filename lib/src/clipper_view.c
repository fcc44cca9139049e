/* SPDX-License-Identifier: MIT */
#include "fixel/clipper.h"

fxl_clip_result fxl_clip_by_view(const fxl_polygon *polygon, const fxl_view *view,
                                 fxl_clipper_work *work, const fxl_view_polygon **result)
{
    fxl_transform_polygon(&view->camera, polygon, &work->view);
    return fxl_clip_view_to_frustum(&work->view, &view->view_frustum, &work->stage.by_view, result);
}

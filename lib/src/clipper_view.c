/* SPDX-License-Identifier: MIT */
#include "fixel/clipper.h"

_Static_assert(sizeof(fxl_polygon) <= sizeof(fxl_view_polygon),
               "a polygon at the start of work ends before by_view.polygons[1]");

fxl_clip_result fxl_clip_by_view(const fxl_polygon *polygon, const fxl_view *view,
                                 fxl_clipper_work *work, const fxl_view_polygon **result)
{
    /* Into the second: the polygon itself may lie where the first does. */
    fxl_view_polygon *seen = &work->by_view.polygons[1];
    fxl_transform_polygon(&view->camera, polygon, seen);
    return fxl_clip_view_to_frustum(seen, &view->view_frustum, &work->by_view, result);
}

/* SPDX-License-Identifier: MIT */
/* The facing test with a model view, for all faces of an instance. Internal. */
#ifndef FXL_FACING_H
#define FXL_FACING_H

#include "../math/arith.h"
#include "estimate.h"
#include "fixel/stage/model_view.h"

/* The same as fxl_face_is_front, with the first vertex relative to the eye: normal . (eye - vertex)
 * > 0. Exact. */
static inline bool fxl_model_view_face_is_front(const fxl_model_view *model_view,
                                                const fxl_face *face)
{
    fxl_point first = fxl_model_view_vertex(model_view, model_view->indices[face->first_index]);
    return fxl_dot_is_negative(&face->normal, first.x, first.y, first.z);
}

#endif

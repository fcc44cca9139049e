/* SPDX-License-Identifier: MIT */
/* Facing, for who asks it of every face of an object. Internal. */
#ifndef FXL_FACE_H
#define FXL_FACE_H

#include "arith.h"
#include "fixel/placed.h"

/* fxl_face_is_front of a placed object's face, its first vertex relative to the
 * eye: normal . (eye - vertex) > 0. Exact. */
static inline bool fxl_placed_face_is_front(const fxl_placed *placed, const fxl_face *face)
{
    fxl_point first = fxl_placed_vertex(placed, placed->corners[face->first_corner]);
    return fxl_dot(&face->normal, first.x, first.y, first.z) < 0;
}

#endif

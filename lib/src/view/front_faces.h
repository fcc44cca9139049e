/* SPDX-License-Identifier: MIT */
/* Which faces of a model face the eye, by the scene's keys: a kernel, one for each
 * family of cores. Internal. */
#ifndef FXL_FRONT_FACES_H
#define FXL_FRONT_FACES_H

#include "../math/arith.h"
#include "fixel/stage/order.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Below 2^62 for |value| < 2^31. */
static inline uint64_t fxl_square(int32_t value)
{
    return (uint64_t)fxl_multiply_s32(value, value);
}

/* The key of a face whose box and whose eye are relative to the same point: of
 * box - 2 eye. The difference of two points of the world is below 2^30, so each
 * coordinate is below 2^31; what wraps on the way cancels. */
static inline uint64_t fxl_box_distance(int32_t x, int32_t y, int32_t z, const fxl_point *eye)
{
    return fxl_square((int32_t)((uint32_t)x - 2 * (uint32_t)eye->x)) +
           fxl_square((int32_t)((uint32_t)y - 2 * (uint32_t)eye->y)) +
           fxl_square((int32_t)((uint32_t)z - 2 * (uint32_t)eye->z));
}

/* Puts down, with its distance and number, each of count faces whose normal . from exceeds its
 * key's height: both are below 2^61, and their difference is what fxl_face_is_front takes the
 * sign of. from is the eye as the model sees it, each coordinate below 2^30. Requires
 * count >= 1. Answers behind the last entry; the entries' `next` means nothing. */
fxl_order_entry *fxl_front_faces(const fxl_face *faces, const fxl_face_bounds *keys,
                                 const fxl_point *from, fxl_order_entry *entry, uint32_t count);

#ifdef __cplusplus
}
#endif

#endif

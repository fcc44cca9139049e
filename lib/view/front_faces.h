/* SPDX-License-Identifier: MIT */
/* The faces of a model that face the eye, by the scene's face bounds. It is a kernel: each family
 * of cores has its own. Internal. */
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

/* The squared distance of fxl_face_distance_squared: the squared length of box - 2 eye. Requires
 * box and eye relative to the same point. The difference of two points of the world is below 2^30,
 * so each coordinate is below 2^31, and intermediate wraps cancel. */
static inline uint64_t fxl_box_distance(int32_t x, int32_t y, int32_t z, const fxl_point *eye)
{
    return fxl_square((int32_t)((uint32_t)x - 2 * (uint32_t)eye->x)) +
           fxl_square((int32_t)((uint32_t)y - 2 * (uint32_t)eye->y)) +
           fxl_square((int32_t)((uint32_t)z - 2 * (uint32_t)eye->z));
}

/* Whether a face faces the eye: normal . eye > height. Exact. For kernels whose estimate does not
 * decide. Requires what fxl_front_faces requires. */
bool fxl_bounded_face_is_front(const fxl_face *face, const fxl_face_bounds *bounds,
                               const fxl_point *eye);

/* Whether direction . (x, y, z) is negative, from all bits, for an inline kernel: a call keeps its
 * caller's frame on the stack small. Requires what fxl_dot requires. */
bool fxl_exact_dot_is_negative(const fxl_direction *direction, int32_t x, int32_t y, int32_t z);

/* Appends an entry, with squared distance and number, for each of count faces that faces the eye.
 * Their numbers are end - count to end - 1. A face does if normal . eye > height. Both sides are
 * below 2^61; fxl_face_is_front tests the sign of their difference. Returns the address behind the
 * last entry. The entries' `next` has no meaning. Requires count >= 1, and the eye relative to the
 * model's origin, each coordinate below 2^30. */
fxl_order_entry *fxl_front_faces(const fxl_face *faces, const fxl_face_bounds *bounds,
                                 const fxl_point *eye, fxl_order_entry *entry, uint32_t count,
                                 uint32_t end);

#ifdef __cplusplus
}
#endif

#endif

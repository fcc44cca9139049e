/* SPDX-License-Identifier: MIT */
/* Planes: from a point and a normal, from three points; and the signed distance of a point.
 * Whether a normal has unit length, for the
 * checks of a scene. Internal. */
#ifndef FXL_PLANE_H
#define FXL_PLANE_H

#include <stdint.h>
#include "arith.h"
#include "fixel/types.h"

#ifdef __cplusplus
extern "C" {
#endif

/* The plane through a point, with a unit normal that points inside, moved inward by
 * inset world units.
 * Requires |point| <= FXL_COORDINATE_MAX in each coordinate, a normal of unit length to
 * within 4 units of 2^-30, 0 <= inset <= FXL_INSET_MAX. Exact: no rounding. Source: B2. */
fxl_plane fxl_plane_from_point(const fxl_point *point, const fxl_direction *normal,
                               fxl_q16_16 inset)
    FXL_REQUIRES(FXL_OBJECT(point) && FXL_OBJECT(normal) && inset >= 0 && inset <= FXL_INSET_MAX)
    FXL_REQUIRES(fxl_point_in_range(point) && FXL_DIRECTION(normal)) FXL_ASSIGNS()
    FXL_ENSURES(FXL_BELOW(FXL_RESULT.distance, ((int64_t)7 << 58) + ((int64_t)1 << 46)))
    FXL_ENSURES(FXL_RESULT.normal.x == normal->x && FXL_RESULT.normal.y == normal->y &&
                FXL_RESULT.normal.z == normal->z);

/* The distance of a point from the plane, in units of 2^-46 world unit; negative outside.
 * Requires |point| <= FXL_COORDINATE_MAX in each coordinate, and a plane made by
 * fxl_plane_from_point. Exact, and so is its sign. Source: B2. */
fxl_q18_46 fxl_plane_distance(const fxl_plane *plane, const fxl_point *point)
    FXL_REQUIRES(FXL_OBJECT(plane) && FXL_OBJECT(point) && fxl_point_in_range(point))
    FXL_REQUIRES(FXL_DIRECTION(&plane->normal) && FXL_BELOW(plane->distance, (int64_t)1 << 62))
    FXL_ASSIGNS() FXL_ENSURES(FXL_BELOW(FXL_RESULT, ((int64_t)1 << 62) + ((int64_t)7 << 58)));

/* Makes the plane through three points of the world, for fxl_plane_distance and all that takes a
 * plane. Its normal is (b - a) x (c - a) at unit length. It points towards the side from which a,
 * b, c run clockwise, as the normal of a face does.
 * FXL_E_ARGUMENT: a pointer is null.
 * FXL_E_RANGE: a coordinate is beyond FXL_COORDINATE_MAX.
 * FXL_E_DEGENERATE: the points lie on one line, exactly.
 * In all three cases *plane is untouched.
 * Error: 2.5 units of 2^-30 a component of the normal. The plane passes through a exactly, and
 * within 2^-13 world unit of b and c. */
fxl_status fxl_plane_from_points(const fxl_point *a, const fxl_point *b, const fxl_point *c,
                                 fxl_plane *plane);

/* *unit = a x b, scaled to unit length. Returns false, and leaves *unit, where the product is 0.
 * Requires components of at most 2^30. Error: 2.5 units of 2^-30 a component. */
bool fxl_unit_cross(const fxl_point *a, const fxl_point *b, fxl_direction *unit)
    FXL_REQUIRES(FXL_OBJECT(a) && FXL_OBJECT(b) && FXL_OBJECT(unit))
    FXL_REQUIRES(FXL_BELOW(a->x, 1 << 30) && FXL_BELOW(a->y, 1 << 30) && FXL_BELOW(a->z, 1 << 30))
    FXL_REQUIRES(FXL_BELOW(b->x, 1 << 30) && FXL_BELOW(b->y, 1 << 30) && FXL_BELOW(b->z, 1 << 30))
    FXL_ASSIGNS(*unit) FXL_ENSURES(!FXL_RESULT || FXL_DIRECTION(unit));

/* --- unit length --------------------------------------------------------------------------- */

/* Whether the squared length is within FXL_NORMAL_SQUARE_MAX_ERROR of 1. Components of at
 * most 2^30 + 2^2 keep every square below 2^61 and the sum below 2^63. */
static inline bool fxl_is_unit(const fxl_direction *normal)
    FXL_REQUIRES(FXL_OBJECT(normal)) FXL_ASSIGNS() FXL_ENSURES(!FXL_RESULT || FXL_DIRECTION(normal))
{
    const int64_t limit = (int64_t)FXL_Q2_30_ONE + 4;
    if (!fxl_within(normal->x, limit) || !fxl_within(normal->y, limit) ||
        !fxl_within(normal->z, limit)) {
        return false;
    }
    int64_t square = (int64_t)normal->x * normal->x + (int64_t)normal->y * normal->y +
                     (int64_t)normal->z * normal->z;
    return fxl_within(square - (int64_t)FXL_Q2_30_ONE * FXL_Q2_30_ONE, FXL_NORMAL_SQUARE_MAX_ERROR);
}

/* The integer nearest to sqrt(value), one bit a step. It is below 2^32 for
 * value < 2^64 - 2^32. At the end the remainder is value - root^2, and it is compared with
 * root because (root + 1/2)^2 is root^2 + root + 1/4. */
static inline uint32_t fxl_square_root(uint64_t value)
    FXL_REQUIRES(1) FXL_ASSIGNS()
{
    uint64_t root = 0;
    for (uint64_t bit = (uint64_t)1 << 62; bit != 0; bit >>= 2) {
        if (value >= root + bit) {
            value -= root + bit;
            root = (root >> 1) + bit;
        } else {
            root >>= 1;
        }
    }
    return (uint32_t)((value > root ? root + 1 : root) & UINT32_MAX);
}

#ifdef __cplusplus
}
#endif

#endif

/* SPDX-License-Identifier: MIT */
/* The outcode: the planes of the frustum that a point of the view lies outside of. As an inline
 * function too, for the kernels that compute it together with something else: most signs follow
 * from the upper words of the distances. Internal. */
#ifndef FXL_OUTCODE_H
#define FXL_OUTCODE_H

#include "../math/arith.h"
#include "fixel/records.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Near and far, and the sides of the screen: sets of planes, as fxl_planes is one. */
#define FXL_PLANES_DEPTH   (1u << FXL_PLANE_NEAR | 1u << FXL_PLANE_FAR)
#define FXL_PLANES_ACROSS  (1u << FXL_PLANE_LEFT | 1u << FXL_PLANE_RIGHT)
#define FXL_PLANES_UPRIGHT (1u << FXL_PLANE_BOTTOM | 1u << FXL_PLANE_TOP)
#define FXL_PLANES_SIDES   (FXL_PLANES_ACROSS | FXL_PLANES_UPRIGHT)

/* Those of the given planes that the point lies outside of.
 * Requires |x|, |y|, |z| < 2^61 units.
 * Exact: the bit of a given plane n is set if fxl_view_distance of plane n is negative.
 * Source: A10. */
fxl_planes fxl_outcode(const fxl_view_frustum *frustum, fxl_planes planes,
                       const fxl_view_point *point);

/* Those of a pair of side planes, plane and plane + 1, that a point is outside of. Exact: it uses
 * all bits of the distances. */
unsigned fxl_outside_of_pair(const fxl_view_frustum *frustum, int plane,
                             const fxl_view_point *point);

/* floor(side * floor(across / 2^32) / 2^32): the term side * across of a distance, in
 * units of 2^-12. It is too small by less than 1.25: the part of across that is cut off is
 * below 1 unit, and side is at most 2^30. */
static inline int32_t fxl_upper_term(fxl_q2_30 side, fxl_q18_46 across)
{
    const int32_t upper = fxl_signed_32((uint32_t)(fxl_bits_64(across) >> 32));
    return (int32_t)(fxl_multiply_s31(side, upper) >> 32);
}

/* Whether a distance computed from upper words does not decide the sign. */
static inline bool fxl_is_open(int32_t distance)
{
    return fxl_bits_32(distance) + 4u < 8u;
}

/* Beside the bits of planes: upper words do not decide those of a pair of side planes. */
#define FXL_OUTSIDE_IS_OPEN 0x100u

/* The outcode's bits of a pair of side planes, plane and plane + 1, or FXL_OUTSIDE_IS_OPEN. Their
 * distances are depth + across and depth - across; depth has the inset, rounded downward, subtracted
 * already. Each true term exceeds the computed one by 0 to 1.25, and the true inset exceeds
 * the rounded one by 0 to 1. So the true distance lies within -2.25..2.5 of the computed
 * one, and the two have the same sign if the computed one is not within -4..3. The sums are
 * below 2^29. */
static inline unsigned fxl_pair_outside(int plane, int32_t across, int32_t depth)
{
    int32_t first = depth + across, second = depth - across;
    if (fxl_is_open(first) || fxl_is_open(second)) {
        return FXL_OUTSIDE_IS_OPEN;
    }
    return (fxl_bits_32(first) >> 31 | fxl_bits_32(second) >> 31 << 1) << plane;
}

/* Whether slopes and upper words show that a point is inside all planes, as most are. Let m be the upper
 * word of |x|, or 1 less, and w that of z, so |x| <= 2^32 (m + 1) and 2^32 w <= z. If m < 4 k with
 * k = floor(slope w / 2^32), |x| is at most slope z / 2^30. w is below 2^29, and a slope below 2^31, so
 * 4 k is below 2^30. z is between near and far if its upper word is between theirs. */
static inline bool fxl_is_within_slopes(const fxl_view_frustum *frustum,
                                        const fxl_view_point *point)
{
    const int32_t x = (int32_t)(point->x >> 32), y = (int32_t)(point->y >> 32),
                  z = (int32_t)(point->z >> 32);
    const int32_t across = fxl_upper_term(frustum->x_slope, point->z) * 4,
                  upright = fxl_upper_term(frustum->y_slope, point->z) * 4;
    return (((x ^ x >> 31) - across) & ((y ^ y >> 31) - upright) &
            ((int32_t)(frustum->near_z >> 32) - z) & (z - (int32_t)(frustum->far_z >> 32))) < 0;
}

/* The same as fxl_outcode, or FXL_OUTSIDE_IS_OPEN and some of its bits. Exact. */
static inline unsigned fxl_outside(const fxl_view_frustum *frustum, unsigned planes,
                                   const fxl_view_point *point)
{
    unsigned outside = 0;
#if FXL_HAS_LONG_PRODUCT && !FXL_IS_SMALL && !FXL_KERNELS_ARMV7M /* which asks for others */
    if (fxl_is_within_slopes(frustum, point)) {
        return 0;
    }
#endif
    const int32_t inset = (int32_t)(frustum->inset >> 34);
    if (planes & FXL_PLANES_ACROSS) {
        outside |= fxl_pair_outside(FXL_PLANE_LEFT, fxl_upper_term(frustum->x_side, point->x),
                                    fxl_upper_term(frustum->x_depth, point->z) - inset);
    }
    if (planes & FXL_PLANES_UPRIGHT) {
        outside |= fxl_pair_outside(FXL_PLANE_BOTTOM, fxl_upper_term(frustum->y_side, point->y),
                                    fxl_upper_term(frustum->y_depth, point->z) - inset);
    }
    outside |= (unsigned)(point->z < frustum->near_z) << FXL_PLANE_NEAR;
    outside |= (unsigned)(point->z > frustum->far_z) << FXL_PLANE_FAR;
    return outside & (planes | FXL_OUTSIDE_IS_OPEN);
}

/* The result of fxl_sphere_planes for a sphere that lies outside one of the planes. */
#define FXL_SPHERE_OUTSIDE (1u << FXL_PLANE_COUNT)

/* The planes that a sphere may cross: bit 1u << FXL_PLANE_... for each; 0 if the
 * sphere lies inside all of them; FXL_SPHERE_OUTSIDE alone if it lies outside one.
 * The test takes the reach instead of the radius: the radius + 2^-9 world unit, to
 * within 2^-10 unit. The difference covers how far matrix and normals may be from unit
 * length, the differences of the planes of the view from those of the world, and the
 * rounding of every clipper. So the test is conservative. Take a model with that radius
 * about that centre. If the result is FXL_SPHERE_OUTSIDE, no clipper draws any of its
 * faces. If the bit of a plane is not set, every vertex is inside that plane.
 * Requires a camera and a frustum made by their functions, each coordinate of
 * the centre within FXL_COORDINATE_MAX, 0 <= radius <= FXL_RADIUS_MAX.
 * Error: 2^-10 unit in the reach. Source: A9. */
uint32_t fxl_sphere_planes(const fxl_camera *camera, const fxl_view_frustum *frustum,
                           const fxl_point *centre, fxl_q16_16 radius);

#ifdef __cplusplus
}
#endif

#endif

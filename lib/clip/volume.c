/* SPDX-License-Identifier: MIT */

#include "../math/arith.h"
#include "../view/view.h"
#include "volume.h"

/* floor(normal . point / 2^30), exactly: below 2^62. Requires |x| + |y| + |z| < 2^31 of the
 * normal and coordinates below 2^61. With v = 2^32 high + low the sum is 2^32 (normal . high) +
 * normal . low. The first bracket is below 2^60, the second below 2^63, and 2^32 is divisible by
 * 2^30. Components that are 0, as most are, cost no product. */
/* clippers 2.1 */
fxl_q18_46 fxl_half_space_distance(const fxl_half_space *plane, const fxl_view_point *point)
{
    int64_t high = 0, low = 0;
    if (plane->normal.x != 0) {
        high += fxl_multiply_s32(plane->normal.x, (int32_t)(point->x >> 32));
        low += fxl_multiply_su32(plane->normal.x, (uint32_t)(point->x & UINT32_MAX));
    }
    if (plane->normal.y != 0) {
        high += fxl_multiply_s32(plane->normal.y, (int32_t)(point->y >> 32));
        low += fxl_multiply_su32(plane->normal.y, (uint32_t)(point->y & UINT32_MAX));
    }
    if (plane->normal.z != 0) {
        high += fxl_multiply_s32(plane->normal.z, (int32_t)(point->z >> 32));
        low += fxl_multiply_su32(plane->normal.z, (uint32_t)(point->z & UINT32_MAX));
    }
    FXL_LEMMA(FXL_BELOW(high * 4 + (low >> 30), ((int64_t)1 << 62) - 1));
    return high * 4 + (low >> 30) + plane->offset;
}

static uint32_t larger_of(fxl_q16_16 a, fxl_q16_16 b)
{
    uint64_t first = fxl_magnitude(a), second = fxl_magnitude(b);
    return (uint32_t)(first > second ? first : second);
}

/* Makes the plane across * axis + along * depth >= 0. Both factors are shifted left until the
 * larger one has 30 bits. This is exact, and their sum stays below 2^31. The larger one must not
 * be 0. */
static fxl_half_space side_plane(bool upright, fxl_q16_16 across, fxl_q16_16 along)
{
    uint32_t larger = larger_of(across, along);
    FXL_ASSERT(larger > 0 && larger < (uint32_t)1 << 30);
    int32_t up = (int32_t)((uint32_t)1 << (30u - fxl_bit_length(larger)));
    fxl_half_space plane = {{0, 0, along * up}, 0};
    if (upright) {
        plane.normal.y = across * up;
    } else {
        plane.normal.x = across * up;
    }
    return plane;
}

/* The sum of a unit vector's components is at most sqrt(3) 2^30 < 2^31, and a plane's distance
 * is below 2^62. */
/* clippers 2.1 */
void fxl_half_space_from_plane(const fxl_plane *plane, fxl_half_space *half_space)
{
    half_space->normal = plane->normal;
    half_space->offset = -plane->distance;
}

/* Depths in 16.16 are below 2^31, so these are below 2^61. */
static void set_depths(fxl_volume *volume, fxl_q18_46 near_z, fxl_q18_46 far_z)
{
    const fxl_plane nearest = {{0, 0, FXL_Q2_30_ONE}, near_z};
    const fxl_plane farthest = {{0, 0, -FXL_Q2_30_ONE}, -far_z};
    fxl_half_space_from_plane(&nearest, &volume->planes[FXL_PLANE_NEAR]);
    fxl_half_space_from_plane(&farthest, &volume->planes[FXL_PLANE_FAR]);
}

/* clippers 2.3 */
void fxl_volume_from_sides(const fxl_view_frustum *sides, fxl_q16_16 focal, uint32_t screen,
                           fxl_volume *volume)
{
    FXL_ASSERT((screen >> FXL_PLANE_NEAR & 1u) != 0 && (screen >> FXL_PLANE_FAR & 1u) != 0);
    set_depths(volume, sides->near_z, sides->far_z);
    for (int plane = FXL_PLANE_LEFT; plane <= FXL_PLANE_TOP; plane++) {
        bool upright = plane == FXL_PLANE_BOTTOM || plane == FXL_PLANE_TOP;
        int32_t sign = plane == FXL_PLANE_LEFT || plane == FXL_PLANE_BOTTOM ? 1 : -1;
        fxl_half_space *to = &volume->planes[plane];
        if ((screen >> plane & 1u) == 0) {
            *to = side_plane(upright, sign * focal, FXL_GUARD_PIXELS * FXL_Q16_16_ONE);
        } else if (upright) {
            const fxl_half_space side = {{0, sign * sides->y_side, sides->y_depth}, -sides->inset};
            *to = side;
        } else {
            const fxl_half_space side = {{sign * sides->x_side, 0, sides->x_depth}, -sides->inset};
            *to = side;
        }
    }
}

/* clippers 2.1 */
fxl_status fxl_volume_from_window(fxl_q16_16 left, fxl_q16_16 right, fxl_q16_16 bottom,
                                  fxl_q16_16 top, fxl_q16_16 near_z, fxl_q16_16 far_z,
                                  fxl_volume *volume)
{
    if (volume == NULL) {
        return FXL_E_ARGUMENT;
    }
    const int32_t limit = FXL_COORDINATE_MAX;
    if (near_z < FXL_NEAR_MIN || near_z > limit || near_z >= far_z || far_z > FXL_FAR_MAX ||
        left >= right || bottom >= top || left < -limit || right > limit || bottom < -limit ||
        top > limit) {
        return FXL_E_RANGE;
    }
    set_depths(volume, near_z * (int64_t)FXL_Q2_30_ONE, far_z * (int64_t)FXL_Q2_30_ONE);
    volume->planes[FXL_PLANE_LEFT] = side_plane(false, near_z, -left);
    volume->planes[FXL_PLANE_RIGHT] = side_plane(false, -near_z, right);
    volume->planes[FXL_PLANE_BOTTOM] = side_plane(true, near_z, -bottom);
    volume->planes[FXL_PLANE_TOP] = side_plane(true, -near_z, top);
    return FXL_OK;
}

uint32_t fxl_volume_code(const fxl_volume *volume, const fxl_view_point *point)
{
    uint32_t code = 0;
    for (uint32_t i = 0; i < FXL_PLANE_COUNT; i++) {
        code |= (uint32_t)(fxl_half_space_distance(&volume->planes[i], point) < 0) << i;
    }
    return code;
}

/* SPDX-License-Identifier: MIT */
/* The portable text of fxl_find_depth_plane, with the bounds that the kernels share.
 *
 * With the normal n in the view, a point P of the plane, and the direction D of a pixel, the plane
 * is seen at distance z = (n . P) focal / (n . D). So the depth near_z / z is the gradient of n .
 * D, times near_z / ((n . P) focal). */
#include "depth_plane.h"

#include "../math/arith.h"
#include "../math/family.h"
#include "../view/view.h"

#if !FXL_KERNELS_ARMV7M && !(FXL_KERNELS_ARMV6M && !FXL_IS_COMPACT)

/* Products of a row and a normal, of unit length or shorter: a sum is below 2^61. */
static int64_t row_times(const fxl_direction *row, const fxl_direction *normal)
{
    return fxl_multiply_s32(row->x, normal->x) + fxl_multiply_s32(row->y, normal->y) +
           fxl_multiply_s32(row->z, normal->z);
}

/* The upper word of a sum without its sign. */
static uint32_t upper_bits(int64_t sum)
{
    return (uint32_t)((sum ^ (sum >> 63)) >> 32);
}

/* -sum 2^shift / 2^32, rounded to nearest: off by half a unit. */
static int32_t component(int64_t sum, unsigned shift)
{
    const uint32_t high = (uint32_t)((uint64_t)sum >> 32), low = (uint32_t)sum;
    return -((int32_t)(high << shift) + (int32_t)(((low >> (31 - shift)) + 1) >> 1));
}

/* axes . normal, less the sign: it points away from the eye, so that n . P > 0. Scaled so that its
 * largest component is from 2^29 to 2^30, or by 2^30 if all are below 2^32. */
static fxl_direction rotated(const fxl_axes *axes, const fxl_direction *normal)
{
    const int64_t x = row_times(&axes->right, normal), y = row_times(&axes->up, normal),
                  z = row_times(&axes->forward, normal);
    const uint32_t bits = upper_bits(x) | upper_bits(y) | upper_bits(z);
    const unsigned shift = bits == 0 ? 30 : fxl_leading_zeros(bits) - 2;
    const fxl_direction n = {component(x, shift), component(y, shift), component(z, shift)};
    return n;
}

/* n . P / 2^32, rounded down. Components of n are at most 2^30. Upper words of P are below 2^29,
 * and half of a lower one is below 2^31: their sums of three products are below 2^61 and 2^63. The
 * bit that is lost of a lower word is 2^-46 world unit. */
static int64_t height_of(const fxl_direction *n, const fxl_view_point *p)
{
    const int64_t lower = fxl_multiply_s32(n->x, (int32_t)((uint32_t)p->x >> 1)) +
                          fxl_multiply_s32(n->y, (int32_t)((uint32_t)p->y >> 1)) +
                          fxl_multiply_s32(n->z, (int32_t)((uint32_t)p->z >> 1));
    return fxl_multiply_s32(n->x, (int32_t)(p->x >> 32)) +
           fxl_multiply_s32(n->y, (int32_t)(p->y >> 32)) +
           fxl_multiply_s32(n->z, (int32_t)(p->z >> 32)) + (lower >> 31);
}

/* The gradient of n . D times factor / 2^32, each rounded down; factor is below 2^31. The focal
 * length is below 2^29 and a centre below 2^28, so sums of products are below 2^61 on all of the
 * screen, and the factor makes them smaller. Unlike fxl_gradient_of_plane this does not scale the
 * gradient to all of its bits: those of n's rounding come before. */
/* SPEC 10.2 */
static void find_gradient(const fxl_direction *n, const fxl_projection *projection,
                          fxl_q16_16 focal, uint32_t factor, fxl_gradient *gradient)
{
    const int64_t at = fxl_multiply_s32(n->z, focal) +
                       fxl_multiply_s32(n->x, 32768 - projection->centre_x) +
                       fxl_multiply_s32(n->y, projection->centre_y - 32768);
    gradient->at = fxl_multiply_s32((int32_t)(at >> 32), (int32_t)factor) +
                   (int64_t)(fxl_multiply_u32((uint32_t)at, factor) >> 32);
    gradient->along = fxl_multiply_s32(n->x, (int32_t)factor) >> 16;
    gradient->down = fxl_multiply_s32(-n->y, (int32_t)factor) >> 16;
}

/* SPEC 10.1 */
void fxl_find_depth_plane(const fxl_direction *normal, const fxl_axes *axes,
                          const fxl_view_point *point, const fxl_view *view, fxl_depth_plane *plane)
{
    fxl_gradient *gradient = &plane->gradient;
    const fxl_direction n = axes != NULL ? rotated(axes, normal) : *normal;
    const int64_t height = height_of(&n, point);
    if (height <= 0) {
        gradient->at = gradient->along = gradient->down = 0;
        plane->one = 0;
        return;
    }
    /* height is in units of 2^-14 of n's, near_z in units of 2^-16. */
    const fxl_q16_16 focal = fxl_view_drawn_focal(view);
    const fxl_real near_z = fxl_real_of((uint32_t)view->lens.near_z, 0);
    const fxl_real at_height = fxl_real_of((uint64_t)height, 0);
    const fxl_real divisor = fxl_real_of(fxl_multiply_u32(at_height.mantissa, (uint32_t)focal), 0);
    /* The ratio is at most 2^32 - 2. Half of it, rounded, is off by at most 2^-30 of it. */
    const uint32_t factor = (fxl_mantissa_ratio(&near_z, &divisor) + 1) >> 1;
    find_gradient(&n, &view->projection, focal, factor, gradient);
    plane->one = at_height.exponent + divisor.exponent - near_z.exponent;
}

#endif

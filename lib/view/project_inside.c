/* SPDX-License-Identifier: MIT */
/* Projection with one reciprocal for x and y; the remainder decides the last unit.
 *
 * The result must be the same as in project.c. For a side X and a depth Z that is q with
 *   d = round(Z 2^-s), 2^30 <= d <= 2^31;  P = floor(focal X 2^-s);
 *   q = floor(P / d + 1/2) = floor((P + h) / d) with h = floor(d / 2).
 * Let n be the number of leading zeros of Z's upper word, so s = 33 - n, and
 *   X' = X 2^(n - 3), below 2^62 if |X| <= 2 Z; its upper word is x, |x| <= 2^30;
 *   F = 4 focal < 2^28; then P = floor(F X' / 2^32), and P / d = F X' / (2^32 d).
 * With G within one unit of 2^32 F / d the estimate is e = x G / 2^32. It has two errors:
 *   truncating X' to x takes 0..F/d < 1/4 off;  G's unit is worth |x| / 2^32 <= 1/4.
 * So e lies in (P/d - 1/2, P/d + 1/4], and floor(e) is q or q - 1. The remainder
 * P + h - floor(e) d lies in 0..2 d - 1, so its lower 32 bits tell which of the two.
 * The offset found is below 2^27 units, which is within the range of screen coordinates. */
#include "../math/arith.h"
#include "../math/family.h"
#include "project.h"

#if !FXL_KERNELS_ARMV6M && !FXL_KERNELS_ARMV7M

/* Within one unit of 2^30 factor / depth, for factor < 2^30 and 2^30 <= depth <= 2^31, by
 * two divisions of 32 bits. Let d = 2^15 D + f, f < 2^15, and factor = g D + r, r < D. The
 * rest 2^15 factor - g d = 2^15 r - g f is between -2^30 and 2^31 (g <= 2^15), so it fits
 * 32 bits, and intermediate wraps cancel. It is divided by D instead of d 2^-15. That makes
 * the quotient too large by up to 2^-15 of itself, one unit at most; it is truncated
 * towards 0. */
static uint32_t scale_of(const fxl_projection *projection, uint32_t depth)
{
    uint32_t divisor = depth >> 15;
    uint32_t upper = fxl_divide_half(projection->factor_2, divisor);
    int32_t rest = (int32_t)(projection->factor_17 - upper * depth);
    uint32_t lower = fxl_divide_half(rest < 0 ? 0u - (uint32_t)rest : (uint32_t)rest, divisor);
    return (upper << 15) + (rest < 0 ? 0u - lower : lower);
}

typedef struct {
    uint32_t factor; /* F */
    uint32_t depth;  /* d */
    uint32_t scale;  /* G */
    unsigned zeros;  /* n, 3..26 */
} scaling;

/* floor((P + h) / d). */
static int32_t offset_of(const scaling *by, int64_t side)
{
    int64_t shifted = (int64_t)((uint64_t)side << (by->zeros - 3));
    int32_t upper = (int32_t)(shifted >> 32);
    /* The 32 lowest bits of P: F X' is F upper 2^32 and F times the lower word. */
    uint32_t product = (uint32_t)(fxl_multiply_u32((uint32_t)shifted, by->factor) >> 32) +
                       (uint32_t)upper * by->factor;
    /* |upper| <= 2^30, G <= 2^30. */
    int32_t quotient = (int32_t)(fxl_multiply_s32(upper, (int32_t)by->scale) >> 32);
    uint32_t rest = product + (by->depth >> 1) - (uint32_t)quotient * by->depth;
    FXL_ASSERT(rest >> 1 < by->depth);
    return rest >= by->depth ? quotient + 1 : quotient;
}

fxl_status fxl_project_inside(const fxl_projection *projection, const fxl_view_point *view,
                              fxl_screen_point *screen)
{
    FXL_ASSERT(projection->depth_min > 0); /* fxl_projection_from_lens set it */
    int32_t upper = (int32_t)(view->z >> 32);
    if (FXL_IS_SMALL || upper < projection->depth_min) {
        return fxl_project_any(projection, view, screen);
    }
    FXL_ASSERT(fxl_within(view->x, 2 * view->z) && fxl_within(view->y, 2 * view->z));
    scaling by;
    by.factor = projection->factor;
    by.zeros = fxl_leading_zeros((uint32_t)upper);
    uint32_t high = (uint32_t)upper << by.zeros | (uint32_t)view->z >> (32u - by.zeros);
    by.depth = (high >> 1) + (high & 1u);
    by.scale = scale_of(projection, by.depth);
    screen->x = projection->centre_x + offset_of(&by, view->x);
    screen->y = projection->centre_y - offset_of(&by, view->y);
    return FXL_OK;
}

#endif

/* SPDX-License-Identifier: MIT */

#include "../math/family.h"
#include "../math/arith.h"
#include "model_view.h"
#include "outcode.h"
#include "project.h"

/* The kernels' fast path requires a focal length below this: 1024 pixels. It also requires that no
 * point inside the frustum, or a few units outside, has a side (X or Y) of more than twice its
 * depth: so half the screen must be less than twice the focal length, with a margin. */
#define FAST_FOCAL_END ((uint32_t)1 << 26)

/* A scaled depth: depth = z 2^-shift, rounded, from 2^30 to 2^31. As z is below 2^61 and at
 * least 2^37, shift is within 7..30. */
typedef struct {
    uint32_t depth;
    unsigned shift;
} scaled_depth;

/* accuracy 1.1 */
static scaled_depth scale_depth(fxl_q18_46 z)
{
    scaled_depth scaled;
    /* The upper word is at least 2^5. The last of the 32 bits from the highest 1 on is rounded. */
    unsigned zeros = fxl_leading_zeros((uint32_t)((uint64_t)z >> 32));
    uint32_t high = (uint32_t)((uint64_t)z << zeros >> 32);
    scaled.shift = 33u - zeros;
    scaled.depth = (high >> 1) + (high & 1u);
    return scaled;
}

/* floor(focal side / 2^shift), 2 <= shift < 32. Returns false if its magnitude is not below 2^62.
 * focal is below 2^29 and |side| is below 2^61, so the product has three words. */
static bool scale_product(fxl_q16_16 focal, fxl_q18_46 side, unsigned shift, int64_t *product)
{
    uint64_t low = fxl_multiply_u32((uint32_t)focal, fxl_low_32(fxl_bits_64(side)));
    int64_t high = fxl_multiply_s32(focal, (int32_t)(side >> 32)) + (int64_t)(low >> 32);
    int32_t top = (int32_t)(high >> 32);
    uint32_t middle = fxl_low_32(fxl_bits_64(high));
    /* The bits of the result above the lower 62 must all equal its sign: 0 or -1. */
    if (fxl_bits_32(top >> (shift - 2)) + 1u > 1u) {
        return false;
    }
    uint32_t upper = middle >> shift | fxl_bits_32(top) << (32 - shift);
    uint32_t lower = fxl_low_32(low) >> shift | middle << (32 - shift);
    *product = fxl_signed_64((uint64_t)upper << 32 | lower);
    return true;
}

/* round(focal side / depth) + centre, halves upward. Returns false if that is outside the range of
 * screen coordinates before it is rounded; rounding never carries past the limit, which is an
 * integer. The centre is an integer, below 2^26, so it may be added before the division. The limit
 * is below 2^29. So their products with the depth are below 2^60. Errors: rounding the product
 * downward costs less than 2^-30 of a unit, rounding the depth 2^-31 of the result. */
/* SPEC 4.8 */
static bool project_side(fxl_q16_16 focal, fxl_q18_46 side, const scaled_depth *scaled,
                         int32_t centre, int32_t *coordinate)
    FXL_REQUIRES(focal > 0 && focal < 1 << 29 && FXL_BELOW(side, ((int64_t)1 << 61) - 1))
    FXL_REQUIRES(FXL_OBJECT(scaled) && FXL_OBJECT(coordinate) && scaled->depth >= 1u << 30)
    FXL_REQUIRES(scaled->depth <= 1u << 31 && scaled->shift >= 7 && scaled->shift <= 30)
    FXL_REQUIRES(FXL_BELOW(centre, 512 * 65536)) FXL_ASSIGNS(*coordinate)
    FXL_ENSURES(!FXL_RESULT || FXL_BELOW(*coordinate, 1 << 28))
{
    int64_t product;
    if (!scale_product(focal, side, scaled->shift, &product)) {
        return false;
    }
    product += fxl_multiply_su32(centre, scaled->depth);
    if (!fxl_within(product, fxl_multiply_su32(FXL_SCREEN_COORDINATE_MAX, scaled->depth))) {
        return false;
    }
    *coordinate = fxl_divide_round(product, scaled->depth);
    return true;
}

/* SPEC 4.8 */
fxl_status fxl_project_any(const fxl_projection *projection, const fxl_view_point *view,
                           fxl_screen_point *screen)
{
    if (view->z < FXL_PROJECT_DEPTH_MIN) {
        return FXL_E_RANGE;
    }
    const fxl_q16_16 focal = (fxl_q16_16)(projection->factor >> 2);
    const scaled_depth scaled = scale_depth(view->z);
    int32_t x, y;
    if (!project_side(focal, view->x, &scaled, projection->centre_x, &x) ||
        !project_side(focal, view->y, &scaled, -projection->centre_y, &y)) {
        return FXL_E_RANGE;
    }
    screen->x = x;
    /* SPEC 1.1 */
    screen->y = -y;
    return FXL_OK;
}

void fxl_projection_from_lens(const fxl_lens *lens, fxl_projection *projection)
{
    uint32_t focal = (uint32_t)lens->focal; /* below 2^29 */
    uint32_t half = (lens->width > lens->height ? lens->width : lens->height) * 32768u;
    projection->factor = focal << 2;
    projection->factor_less_1 = projection->factor - 1;
    projection->depth_min = focal < FAST_FOCAL_END && half < 2 * focal - focal / 64
                                ? (int32_t)(FXL_PROJECT_DEPTH_MIN >> 32)
                                : INT32_MAX;
    projection->factor_2 = focal << 4;
    projection->factor_17 = focal << 19;
    projection->centre_x = (int32_t)lens->width * 32768;
    projection->centre_y = (int32_t)lens->height * 32768;
}

/* The upper word of a side, or its complement if the side is negative. */
static uint32_t upper_magnitude(int64_t side)
{
    int32_t upper = (int32_t)(side >> 32);
    return (uint32_t)(upper ^ (upper >> 31));
}

fxl_status fxl_project_visible(const fxl_projection *projection, const fxl_view_point *view,
                               fxl_screen_point *screen)
{
    int32_t upper = (int32_t)(view->z >> 32);
    /* If the upper words m of |X| and z of Z have m < 2 z, then |X| <= 2^32 (m + 1) <= 2 Z. */
    if (FXL_IS_SMALL || upper < projection->depth_min ||
        (upper_magnitude(view->x) | upper_magnitude(view->y)) >= (uint32_t)upper << 1) {
        return fxl_project_any(projection, view, screen);
    }
    return fxl_project_inside(projection, view, screen);
}

fxl_status fxl_project_point(const fxl_lens *lens, const fxl_view_point *view,
                             fxl_screen_point *screen)
{
    fxl_projection projection;
    fxl_projection_from_lens(lens, &projection);
    return fxl_project_visible(&projection, view, screen);
}

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
    int32_t rest = fxl_signed_32(projection->factor_17 - upper * depth);
    uint32_t lower = fxl_divide_half(rest < 0 ? 0u - fxl_bits_32(rest) : (uint32_t)rest, divisor);
    return (upper << 15) + (rest < 0 ? 0u - lower : lower);
}

typedef struct {
    uint32_t factor; /* F */
    uint32_t depth;  /* d */
    uint32_t scale;  /* G */
    unsigned zeros;  /* n, 3..26 */
} scaling;

/* floor((P + h) / d). */
FXL_ONCE int32_t offset_of(const scaling *by, int64_t side)
{
    const unsigned shift = by->zeros - 3;
    const uint32_t low = fxl_low_32(fxl_bits_64(side));
    const int32_t upper =
        fxl_signed_32((uint32_t)(fxl_bits_64(side) >> 32) << shift | low >> 1 >> (31 - shift));
    /* The 32 lowest bits of P: F X' is F upper 2^32 and F times the lower word. */
    uint32_t product = (uint32_t)(fxl_multiply_u32(low << shift, by->factor) >> 32) +
                       fxl_bits_32(upper) * by->factor;
    /* |upper| <= 2^30, G <= 2^30. */
    int32_t quotient = (int32_t)(fxl_multiply_s32(upper, (int32_t)by->scale) >> 32);
    uint32_t rest = product + (by->depth >> 1) - fxl_bits_32(quotient) * by->depth;
    FXL_LEMMA(rest >> 1 < by->depth && FXL_BELOW(quotient, 1 << 28));
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
    uint32_t high =
        (uint32_t)upper << by.zeros | fxl_low_32(fxl_bits_64(view->z)) >> (32u - by.zeros);
    by.depth = (high >> 1) + (high & 1u);
    by.scale = scale_of(projection, by.depth);
    screen->x = projection->centre_x + offset_of(&by, view->x);
    /* SPEC 1.1 */
    screen->y = projection->centre_y - offset_of(&by, view->y);
    return FXL_OK;
}

#if FXL_TRANSFORMS_AND_PROJECTS

/* fxl_transform_and_project of a vertex that slopes do not show to be inside, or that is not deep enough for
 * fxl_project_inside. Apart, and called last: what a call leaves intact would else be saved at each vertex. */
static __attribute__((noinline)) int32_t project_other(const fxl_model_view *model_view,
                                                       uint32_t number, fxl_cached_vertex *entry)
{
    fxl_transform_vertex(model_view, number, entry);
    return entry->clip_flags != FXL_VERTEX_UNPROJECTED
               ? -1
               : (int32_t)fxl_project_inside(&model_view->view->projection, &entry->position,
                                             &entry->screen);
}

__attribute__((flatten)) int32_t fxl_transform_and_project(const fxl_model_view *model_view,
                                                           uint32_t number,
                                                           fxl_cached_vertex *entry, uint32_t tag)
{
    const fxl_view *view = model_view->view;
    fxl_view_point position;
    fxl_model_view_position(model_view, number, &position);
    if ((model_view->planes & FXL_MODEL_VIEW_SCALED) != 0 ||
        (model_view->planes != 0 && !fxl_is_within_slopes(&view->view_frustum, &position)) ||
        (int32_t)(position.z >> 32) < view->projection.depth_min) {
        return project_other(model_view, number, entry);
    }
    entry->position = position;
    (void)fxl_project_inside(&view->projection, &position, &entry->screen);
    entry->tag = tag;
    return FXL_OK;
}

#endif

#endif

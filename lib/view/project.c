/* SPDX-License-Identifier: MIT */

#include "../math/arith.h"
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
    uint64_t low = fxl_multiply_u32((uint32_t)focal, (uint32_t)side);
    int64_t high = fxl_multiply_s32(focal, (int32_t)((uint64_t)side >> 32)) + (int64_t)(low >> 32);
    int32_t top = (int32_t)((uint64_t)high >> 32);
    uint32_t middle = (uint32_t)high;
    /* The bits of the result above the lower 62 must all equal its sign: 0 or -1. */
    if ((uint32_t)(top >> (shift - 2)) + 1u > 1u) {
        return false;
    }
    uint32_t upper = middle >> shift | (uint32_t)top << (32 - shift);
    uint32_t lower = (uint32_t)low >> shift | middle << (32 - shift);
    *product = (int64_t)((uint64_t)upper << 32 | lower);
    return true;
}

/* round(focal side / depth) + centre, halves upward. Returns false if that is outside the range of
 * screen coordinates before it is rounded; rounding never carries past the limit, which is an
 * integer. The centre is an integer, below 2^26, so it may be added before the division. The limit
 * is below 2^29. So their products with the depth are below 2^60. Errors: rounding the product
 * downward costs less than 2^-30 of a unit, rounding the depth 2^-31 of the result. */
static bool project_side(fxl_q16_16 focal, fxl_q18_46 side, const scaled_depth *scaled,
                         int32_t centre, int32_t *coordinate)
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

fxl_status fxl_project_polygon(const fxl_lens *lens, const fxl_view_polygon *view,
                               fxl_screen_polygon *screen)
{
    fxl_projection projection;
    fxl_projection_from_lens(lens, &projection);
    screen->colour = view->colour;
    screen->count = 0;
    for (uint32_t i = 0; i < view->count; i++) {
        fxl_status status =
            fxl_project_visible(&projection, &view->vertices[i].position, &screen->points[i]);
        if (status != FXL_OK) {
            return status;
        }
    }
    screen->count = view->count;
    return FXL_OK;
}

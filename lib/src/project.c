/* SPDX-License-Identifier: MIT */
#include "fixel/project.h"

#include "arith.h"
#include "project_any.h"

/* Below it the kernels' short way holds: 1024 pixels. And no point that is inside the
 * frustum, or a few units outside, may have a side of more than twice its depth: so half the
 * screen is to be less than twice the focal length, with something to spare. */
#define FOCAL_SHORT ((uint32_t)1 << 26)

/* The kernels in assembly know where members lie. */
_Static_assert(offsetof(fxl_projection, depth_min) == 4 &&
                   offsetof(fxl_projection, factor_less_1) == 8 &&
                   offsetof(fxl_projection, factor_2) == 12 &&
                   offsetof(fxl_projection, factor_17) == 16 &&
                   offsetof(fxl_projection, centre_x) == 20 &&
                   offsetof(fxl_projection, centre_y) == 24 && offsetof(fxl_view_point, z) == 16,
               "lib/kernels");

/* Where a view point's depth is brought to: depth = z 2^-shift, rounded, from
 * 2^30 to 2^31. z below 2^61 and at least 2^37 keeps shift within 7..30. */
typedef struct {
    uint32_t depth;
    unsigned shift;
} scaled_depth;

static scaled_depth scale_depth(fxl_q18_46 z)
{
    scaled_depth scaled;
    scaled.shift = fxl_bit_length((uint64_t)z) - 31u; /* bug: depth-24 */
    scaled.depth = (uint32_t)fxl_round_shift(z, scaled.shift);
    return scaled;
}

/* floor(focal * side / 2^shift), 0 < shift < 32; false where it would reach
 * 2^62. focal is below 2^29 and |side| below 2^61. With side = 2^32 high + low
 * the product is 2^32 (focal high) + focal low: |focal high| <= 2^58, focal low
 * is below 2^61, and 2^32 (focal high) is divisible by 2^shift. */
static bool scale_product(fxl_q16_16 focal, fxl_q18_46 side, unsigned shift, int64_t *product)
{
    int64_t high = fxl_multiply_s32(focal, (int32_t)(side >> 32));
    int64_t low = fxl_multiply_su32(focal, (uint32_t)side);
    if (!fxl_within(high, (int64_t)1 << (29 + shift))) {
        return false;
    }
    *product = (int64_t)((uint64_t)high << (32 - shift)) + (low >> shift);
    return true;
}

/* focal * side / depth, rounded once; false where it lies outside low..high,
 * which are below 2^29, so that their products with the depth are below 2^60.
 * Rounding never carries past a whole limit. The product's own rounding down
 * costs less than 2^-30 of a unit; that of the depth 2^-31 of the result. */
static bool offset_from_centre(fxl_q16_16 focal, fxl_q18_46 side, const scaled_depth *scaled,
                               int32_t low, int32_t high, int32_t *offset)
{
    int64_t product;
    if (!scale_product(focal, side, scaled->shift, &product) ||
        product < fxl_multiply_su32(low, scaled->depth) ||
        product > fxl_multiply_su32(high, scaled->depth)) {
        return false;
    }
    *offset = fxl_divide_round(product, scaled->depth); /* bug: project-cut */
    return true;
}

fxl_status fxl_project_any(const fxl_projection *projection, const fxl_view_point *view,
                           fxl_screen_point *screen)
{
    if (view->z < FXL_PROJECT_DEPTH_MIN) {
        return FXL_E_RANGE;
    }
    const int32_t limit = FXL_SCREEN_COORDINATE_MAX;
    fxl_q16_16 focal = (fxl_q16_16)(projection->factor >> 2);
    int32_t centre_x = projection->centre_x, centre_y = projection->centre_y;
    scaled_depth scaled = scale_depth(view->z);
    int32_t x, y;
    if (!offset_from_centre(focal, view->x, &scaled, -limit - centre_x, limit - centre_x, &x) ||
        !offset_from_centre(focal, view->y, &scaled, centre_y - limit, centre_y + limit, &y)) {
        return FXL_E_RANGE;
    }
    screen->x = centre_x + x;
    screen->y = centre_y - y; /* bug: screen-y-up */
    return FXL_OK;
}

void fxl_projection_from_lens(const fxl_lens *lens, fxl_projection *projection)
{
    uint32_t focal = (uint32_t)lens->focal; /* below 2^29 */
    uint32_t half = (lens->width > lens->height ? lens->width : lens->height) * 32768u;
    projection->factor = focal << 2;
    projection->factor_less_1 = projection->factor - 1;
    projection->depth_min = focal < FOCAL_SHORT && half < 2 * focal - focal / 64
                                ? (int32_t)(FXL_PROJECT_DEPTH_MIN >> 32)
                                : INT32_MAX;
    projection->factor_2 = focal << 4;
    projection->factor_17 = focal << 19;
    projection->centre_x = (int32_t)lens->width * 32768;
    projection->centre_y = (int32_t)lens->height * 32768;
}

static uint32_t upper_magnitude(int64_t side)
{
    int32_t upper = (int32_t)(side >> 32);
    return (uint32_t)(upper ^ (upper >> 31));
}

fxl_status fxl_project_seen(const fxl_projection *projection, const fxl_view_point *view,
                            fxl_screen_point *screen)
{
    int32_t upper = (int32_t)(view->z >> 32);
    /* With m < 2 z of upper words, |X| <= 2^32 (m + 1) <= 2 Z. */
    if (upper < projection->depth_min ||
        /* bug: side-range */
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
    return fxl_project_seen(&projection, view, screen);
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
            fxl_project_seen(&projection, &view->vertices[i].position, &screen->points[i]);
        if (status != FXL_OK) {
            return status;
        }
    }
    screen->count = view->count;
    return FXL_OK;
}

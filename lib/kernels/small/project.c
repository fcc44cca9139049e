/* SPDX-License-Identifier: MIT */
/* The numbers of lib/src/project.c; every point goes the long way. */
#include "fixel/project.h"

#include "arith.h"
#include "project_any.h"

/* Where a view point's depth is brought to: depth = z 2^-shift, rounded, from
 * 2^30 to 2^31. z below 2^61 and at least 2^37 keeps shift within 7..30. */
typedef struct {
    uint32_t depth;
    unsigned shift;
    fxl_q16_16 focal;
} scaled_depth;

static scaled_depth scale_depth(fxl_q18_46 z)
{
    scaled_depth scaled;
    unsigned zeros = fxl_leading_zeros((uint32_t)((uint64_t)z >> 32));
    uint32_t high = (uint32_t)((uint64_t)z << zeros >> 32);
    scaled.shift = 33u - zeros;
    scaled.depth = (high >> 1) + (high & 1u);
    return scaled;
}

/* round(focal side / depth) + centre, half a unit downward; false where that lies beyond the
 * screen's range before it is rounded. centre is a whole number, so it may come before
 * the division. */
static bool place_of(fxl_q18_46 side, const scaled_depth *scaled, int32_t centre, int32_t *place)
{
    /* Their product in three words. focal is below 2^29, |side| below 2^61. */
    fxl_q16_16 focal = scaled->focal;
    uint64_t low = fxl_multiply_u32((uint32_t)focal, (uint32_t)side);
    int64_t high = fxl_multiply_s32(focal, (int32_t)((uint64_t)side >> 32)) + (int64_t)(low >> 32);
    int32_t top = (int32_t)((uint64_t)high >> 32);
    unsigned shift = scaled->shift, rest = 32u - shift;
    /* Shifted, beyond 2^62: the range's end times the depth is below 2^60. */
    if ((uint32_t)(top >> (shift - 2)) + 1u > 1u) {
        return false;
    }
    int64_t product = (int64_t)((uint64_t)((uint32_t)high >> shift | (uint32_t)top << rest) << 32 |
                                ((uint32_t)low >> shift | (uint32_t)high << rest)) +
                      fxl_multiply_su32(centre, scaled->depth);
    if (!fxl_within(product, fxl_multiply_su32(FXL_SCREEN_COORDINATE_MAX, scaled->depth))) {
        return false;
    }
    /* floor((product + depth / 2) / depth); of -1 - n it is -1 less that of n. */
    uint32_t none;
    product += scaled->depth >> 1;
    int64_t sign = product >> 63;
    *place =
        (int32_t)fxl_divide_u64((uint64_t)(product ^ sign), scaled->depth, &none) ^ (int32_t)sign;
    return true;
}

fxl_status fxl_project_any(const fxl_projection *projection, const fxl_view_point *view,
                           fxl_screen_point *screen)
{
    if (view->z < FXL_PROJECT_DEPTH_MIN) {
        return FXL_E_RANGE;
    }
    scaled_depth scaled = scale_depth(view->z);
    scaled.focal = (fxl_q16_16)(projection->factor >> 2);
    int32_t x, y;
    if (!place_of(view->x, &scaled, projection->centre_x, &x) ||
        !place_of(view->y, &scaled, -projection->centre_y, &y)) {
        return FXL_E_RANGE;
    }
    screen->x = x;
    screen->y = -y;
    return FXL_OK;
}

void fxl_projection_from_lens(const fxl_lens *lens, fxl_projection *projection)
{
    projection->factor = (uint32_t)lens->focal << 2; /* below 2^31 */
    projection->centre_x = (int32_t)lens->width * 32768;
    projection->centre_y = (int32_t)lens->height * 32768;
}

fxl_status fxl_project_seen(const fxl_projection *projection, const fxl_view_point *view,
                            fxl_screen_point *screen)
{
    return fxl_project_any(projection, view, screen);
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

/* SPDX-License-Identifier: MIT */
#include "fixel/project.h"

#include "arith.h"

/* focal * side / depth, rounded once, for depth > 0; false where it lies
 * outside low..high. focal is below 2^29 and a mantissa below 2^31, so the
 * product is below 2^60; low and high are below 2^29, so their products are
 * too. Rounding never carries past a whole limit. */
static bool offset_from_centre(fxl_q16_16 focal, int32_t side, int32_t depth, int32_t low,
                               int32_t high, int32_t *offset)
{
    int64_t product = (int64_t)focal * side;
    if (product < (int64_t)low * depth || product > (int64_t)high * depth) {
        return false;
    }
    *offset = (int32_t)fxl_divide_round(product, depth);
    return true;
}

fxl_status fxl_project_point(const fxl_lens *lens, const fxl_view_point *view,
                             fxl_screen_point *screen)
{
    if (view->z <= 0) {
        return FXL_E_RANGE;
    }
    int32_t centre_x = (int32_t)lens->width * 32768;
    int32_t centre_y = (int32_t)lens->height * 32768;
    const int32_t limit = FXL_SCREEN_COORDINATE_MAX;
    int32_t x, y;
    if (!offset_from_centre(lens->focal, view->x, view->z, -limit - centre_x, limit - centre_x,
                            &x) ||
        !offset_from_centre(lens->focal, view->y, view->z, centre_y - limit, centre_y + limit,
                            &y)) {
        return FXL_E_RANGE;
    }
    screen->x = centre_x + x;
    screen->y = centre_y - y;
    return FXL_OK;
}

fxl_status fxl_project_polygon(const fxl_lens *lens, const fxl_view_polygon *view,
                               fxl_screen_polygon *screen)
{
    screen->colour = view->colour;
    screen->count = 0;
    for (uint32_t i = 0; i < view->count; i++) {
        fxl_status status = fxl_project_point(lens, &view->points[i], &screen->points[i]);
        if (status != FXL_OK) {
            return status;
        }
    }
    screen->count = view->count;
    return FXL_OK;
}

/* SPDX-License-Identifier: MIT */
#include "fixel/transform.h"

#include "arith.h"

/* The coordinate as a mantissa: value * 2^-shift. A shift down rounds once; a
 * shift up is exact. */
static int32_t mantissa(int64_t value, int shift)
{
    if (shift > 0) {
        return (int32_t)fxl_round_shift(value, (unsigned)shift);
    }
    return (int32_t)(value * ((int64_t)1 << -shift));
}

static uint64_t larger(uint64_t a, uint64_t b)
{
    return a > b ? a : b;
}

void fxl_transform_point(const fxl_camera *camera, const fxl_point *point, fxl_view_point *view)
{
    FXL_ASSERT(fxl_point_in_range(point));
    /* Both within FXL_COORDINATE_MAX, so each difference is below 2^30. */
    int32_t dx = point->x - camera->position.x;
    int32_t dy = point->y - camera->position.y;
    int32_t dz = point->z - camera->position.z;
    fxl_q18_46 x = fxl_dot(&camera->right, dx, dy, dz);
    fxl_q18_46 y = fxl_dot(&camera->up, dx, dy, dz);
    fxl_q18_46 z = fxl_dot(&camera->forward, dx, dy, dz);

    /* Where rounding up would carry the largest to 2^31, adding its own highest
     * 31 bits' last unit carries it first, and the shift is one more. */
    uint64_t largest = larger(fxl_magnitude(x), larger(fxl_magnitude(y), fxl_magnitude(z)));
    unsigned bits = fxl_bit_length(largest + (largest >> 31));
    int shift = (int)bits - 31;
    if (bits == 0) {
        shift = 0; /* the eye itself */
    }
    view->x = mantissa(x, shift);
    view->y = mantissa(y, shift);
    view->z = mantissa(z, shift);
    view->exponent = (int8_t)shift;
}

void fxl_transform_polygon(const fxl_camera *camera, const fxl_polygon *polygon,
                           fxl_view_polygon *view)
{
    view->colour = polygon->colour;
    view->count = polygon->count;
    for (uint32_t i = 0; i < polygon->count; i++) {
        fxl_transform_point(camera, &polygon->vertices[i].position, &view->points[i]);
    }
}

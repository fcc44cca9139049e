/* SPDX-License-Identifier: MIT */
/* A file of its own: each target with a depth buffer would have these functions in several places.
 */
#include "scan.h"

#include "../math/arith.h"
#include "../math/pixel_centre.h"
#include "columns.h"

/* place fill-rule: the centres of a tiny triangle */
/* The first centres from three coordinates on: *first becomes the least, and the result is how many
 * there are from it to the greatest. */
static inline int32_t count_centres(fxl_q16_16 a, fxl_q16_16 b, fxl_q16_16 c, int32_t *first)
{
    const fxl_q16_16 low = a < b ? a : b, high = a < b ? b : a;
    *first = fxl_first_centre_from(c < low ? c : low);
    return fxl_first_centre_from(c > high ? c : high) - *first;
}

/* Leaves of centres from *first on those from low to end. */
static inline void limit(int32_t *first, int32_t *count, int32_t low, int32_t end)
{
    int32_t last = *first + *count;
    *first = *first < low ? low : *first;
    last = last > end ? end : last;
    *count = last - *first;
}

bool fxl_tiny_find(const fxl_screen_point *points, const fxl_band *band, fxl_tiny *tiny)
{
    tiny->rows = count_centres(points[0].y, points[1].y, points[2].y, &tiny->row);
    if (tiny->rows > FXL_TINY_SIDE) {
        return false;
    }
    tiny->columns = count_centres(points[0].x, points[1].x, points[2].x, &tiny->column);
    if (tiny->columns > FXL_TINY_SIDE) {
        return false;
    }
    limit(&tiny->row, &tiny->rows, band->first_row, band->first_row + band->rows);
    limit(&tiny->column, &tiny->columns, band->first_column, (int32_t)fxl_band_end_column(band));
    tiny->pixels = 0;
    return tiny->rows <= 0 || tiny->columns <= 0 || fxl_tiny_cover(points, tiny);
}

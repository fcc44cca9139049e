/* SPDX-License-Identifier: MIT */
#include "../raster/columns.h"
#include "scan_box.h"

#include "../math/arith.h"
#include "../math/pixel_centre.h"

static int32_t clamped(int32_t value, int32_t low, int32_t high)
{
    return value < low ? low : value > high ? high : value;
}

/* place fill-rule: the scan by bounding box */
void fxl_scan_box_begin(const fxl_screen_point *points, uint32_t count, const fxl_band *band,
                        fxl_scan_box *scan)
{
    FXL_ASSERT(count >= 3 && count <= FXL_POLYGON_CAPACITY);
    fxl_screen_point low = points[0], high = points[0];
    for (uint32_t i = 1; i < count; i++) {
        low.x = points[i].x < low.x ? points[i].x : low.x;
        low.y = points[i].y < low.y ? points[i].y : low.y;
        high.x = points[i].x > high.x ? points[i].x : high.x;
        high.y = points[i].y > high.y ? points[i].y : high.y;
    }
    int32_t top = band->first_row, bottom = top + band->rows;
    scan->points = points;
    scan->count = count;
    const int32_t left = band->first_column;
    const int32_t right = (int32_t)fxl_band_end_column(band);
    scan->left = clamped(fxl_first_centre_from(low.x), left, right);
    scan->right = clamped(fxl_first_centre_from(high.x), left, right);
    scan->row = clamped(fxl_first_centre_from(low.y), top, bottom);
    scan->bottom = clamped(fxl_first_centre_from(high.y), top, bottom);
    scan->column = scan->left;
}

/* Tells whether the winding number about a pixel's centre is not 0, edge by edge (SPEC.md,
 * section 5). An edge counts where its x at the height of the centre is not right of the centre.
 * With t the distance down from the upper end this is (x - upper.x) height >= (lower.x -
 * upper.x) t. Coordinates are below 2^28 and a centre below 2^27, so the products are below
 * 2^58. */
static bool covers(const fxl_scan_box *scan, int32_t x, int32_t y)
{
    int winding = 0;
    const fxl_screen_point *a = &scan->points[scan->count - 1];
    for (uint32_t i = 0; i < scan->count; i++) {
        const fxl_screen_point *b = &scan->points[i];
        bool down = a->y <= y && y < b->y, up = b->y <= y && y < a->y;
        if (down || up) {
            const fxl_screen_point *upper = down ? a : b, *lower = down ? b : a;
            int64_t across = (int64_t)(x - upper->x) * (lower->y - upper->y);
            int64_t along = (int64_t)(lower->x - upper->x) * (y - upper->y);
            winding += across < along ? 0 : down ? 1 : -1;
        }
        a = b;
    }
    return winding != 0;
}

bool fxl_scan_box_next(fxl_scan_box *scan, fxl_span *span)
{
    for (; scan->row < scan->bottom; scan->row++, scan->column = scan->left) {
        int32_t y = fxl_centre_of(scan->row), column = scan->column;
        while (column < scan->right && !covers(scan, fxl_centre_of(column), y)) {
            column++;
        }
        if (column == scan->right) {
            continue;
        }
        span->y = (int16_t)scan->row;
        span->x0 = (int16_t)column;
        while (column < scan->right && covers(scan, fxl_centre_of(column), y)) {
            column++;
        }
        span->x1 = (int16_t)column;
        scan->column = column;
        return true;
    }
    return false;
}

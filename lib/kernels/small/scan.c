/* SPDX-License-Identifier: MIT */
/* One way for every outline: by its crossings. */
#include "fixel/scan.h"

#include "chains.h"
#include "edge.h"
#include "scan_crossings.h"

static fxl_status check(const fxl_screen_polygon *polygon, const fxl_band *band)
{
    if (polygon->count < 3) {
        return FXL_E_DEGENERATE;
    }
    if (polygon->count > FXL_POLYGON_CAPACITY) {
        return FXL_E_CAPACITY;
    }
    if (band->width < 1 || band->width > FXL_SCREEN_MAX || band->rows < 1 ||
        band->first_row + band->rows > FXL_SCREEN_MAX) {
        return FXL_E_RANGE;
    }
    for (uint32_t i = 0; i < polygon->count; i++) {
        if (!fxl_within(polygon->points[i].x, FXL_SCREEN_COORDINATE_MAX) ||
            !fxl_within(polygon->points[i].y, FXL_SCREEN_COORDINATE_MAX)) {
            return FXL_E_RANGE;
        }
    }
    return FXL_OK;
}

void fxl_outline_rows(const fxl_screen_point *points, uint32_t count, int16_t *first, int16_t *end)
{
    int32_t top = INT16_MAX, bottom = INT16_MIN;
    for (; count != 0; count--, points++) {
        int32_t row = fxl_first_centre_from(points->y);
        top = row < top ? row : top;
        bottom = row > bottom ? row : bottom;
    }
    *first = (int16_t)top;
    *end = (int16_t)bottom;
}

void fxl_scan_outline(const fxl_screen_point *points, uint32_t count, const fxl_band *band,
                      fxl_scan *scan)
{
    FXL_ASSERT(count >= 3 && count <= FXL_POLYGON_CAPACITY);
    scan->by_chains = false;
    scan->end_row = INT16_MIN;
    fxl_outline_rows(points, count, &scan->outline_first, &scan->outline_end);
    fxl_crossings_begin(&scan->crossings, points, count, band);
}

fxl_status fxl_scan_begin(const fxl_screen_polygon *polygon, const fxl_band *band, fxl_scan *scan)
{
    if (scan == NULL) {
        return FXL_E_ARGUMENT;
    }
    fxl_status status = polygon == NULL || band == NULL ? FXL_E_ARGUMENT : check(polygon, band);
    if (status == FXL_OK) {
        fxl_scan_outline(polygon->points, polygon->count, band, scan);
    } else {
        scan->by_chains = false;
        scan->crossings.end_row = INT16_MIN;
        scan->crossings.crossing_count = 0;
        scan->crossings.next_crossing = 0;
    }
    return status;
}

static uint16_t row_held(int32_t row, uint16_t height)
{
    return row < 0 ? 0 : row > height ? height : (uint16_t)row;
}

fxl_rows fxl_scan_rows(const fxl_screen_polygon *polygon, uint16_t height)
{
    int16_t first, end;
    fxl_outline_rows(polygon->points, polygon->count, &first, &end);
    fxl_rows rows = {row_held(first, height), row_held(end, height)};
    return rows;
}

bool fxl_scan_next(fxl_scan *scan, fxl_span *span)
{
    return fxl_crossings_next(&scan->crossings, span);
}

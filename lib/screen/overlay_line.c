/* SPDX-License-Identifier: MIT */
#include "../math/arith.h"
#include "../raster/line_pixels.h"
#include "overlay_band.h"

/* A line along its major axis: from place `from` to place `to`, both included, from <= to. */
typedef struct {
    int32_t from, to; /* pixels */
    int32_t across;   /* at from */
    int32_t rise;     /* change across from `from` to `to`, no larger than to - from */
} pixel_line;

/* Draws the part of the line within low <= place < high. At place `from` + k the line is at
 * across + k rise / length, so its pixel there is floor((2 k rise + length) / (2 length)) beyond
 * across. Coordinates are below 2^29, so k, rise and length are below 2^30, and the numerator is
 * below 2^61 + 2^30. The quotient is at most |rise|. */
static void draw_part(const pixel_line *line, bool upright, int32_t low, int32_t high,
                      uint8_t colour, const fxl_band *band)
{
    const int32_t length = line->to - line->from;
    const fxl_stretch part = fxl_clip_stretch(line->from, (int64_t)length + 1, low, high);
    if (part.first == part.end) {
        return;
    }
    const int64_t pixel = length > 0 ? 2 * (int64_t)length : 2;
    const int64_t sum = 2 * fxl_multiply_s32(part.first - line->from, line->rise) + pixel / 2;
    const int32_t moved = fxl_divide_down(sum, (uint32_t)pixel);
    fxl_line_pixels pixels = {.across = line->across + moved,
                              .left = sum - moved * pixel,
                              .pixel = pixel,
                              .step = 2 * (int64_t)line->rise,
                              .upright = upright};
    fxl_draw_line_pixels(&pixels, part.first, part.end, colour, band);
}

static bool in_range(int32_t a, int32_t b)
{
    return fxl_within(a, FXL_LINE_COORDINATE_MAX) && fxl_within(b, FXL_LINE_COORDINATE_MAX);
}

fxl_status fxl_draw_line(const fxl_band *band, int32_t x0, int32_t y0, int32_t x1, int32_t y1,
                         uint8_t colour)
{
    const fxl_status status = fxl_overlay_check(band);
    if (status != FXL_OK) {
        return status;
    }
    if (!in_range(x0, y0) || !in_range(x1, y1)) {
        return FXL_E_RANGE;
    }
    const int32_t width = x1 - x0, height = y1 - y0; /* below 2^30 */
    if ((height < 0 ? -height : height) > (width < 0 ? -width : width)) {
        const pixel_line line = {height < 0 ? y1 : y0, height < 0 ? y0 : y1, height < 0 ? x1 : x0,
                                 height < 0 ? -width : width};
        draw_part(&line, true, band->first_row, band->first_row + band->rows, colour, band);
    } else {
        const pixel_line line = {width < 0 ? x1 : x0, width < 0 ? x0 : x1, width < 0 ? y1 : y0,
                                 width < 0 ? -height : height};
        draw_part(&line, false, 0, band->width, colour, band);
    }
    return FXL_OK;
}

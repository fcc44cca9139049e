/* SPDX-License-Identifier: MIT */
#include "../math/arith.h"
#include "columns.h"
#include "draw_outline.h"
#include "fill.h"

/* A line, described along its major axis. */
typedef struct {
    int32_t from, to; /* along the major axis, from < to */
    int32_t across;   /* at from */
    int32_t rise;     /* change across from `from` to `to`, no larger than to - from */
} major_line;

/* place fill-rule: the pixels of a line, with a first_centre of its own */
/* The first pixel whose centre is not before a coordinate. So the pixels with centres from a
 * (included) to b (excluded) are first_centre(a) .. first_centre(b) - 1. */
/* wire 2.2 */
static int32_t first_centre(int32_t coordinate)
{
    return (coordinate + 32767) >> 16; /* ceil(c / 2^16 - 1/2) */
}

/* Returns the pixel across the line at the centre of pixel `along`. *left is the remainder, in
 * units of 1/2^16 of 1/length; a pixel is 65536 length of them. The sum is (across + 8192 *
 * 65536) length + (centre - from) rise. The first term is below 2^30 2^30; the second, between
 * two points of the line, is below 2^29 2^30. The sum is positive, because the point lies on the
 * line and no point lies beyond -4095 pixels. */
/* wire 2.2 */
static int32_t pixel_at(const major_line *line, int32_t along, int64_t *left)
{
    const int32_t length = line->to - line->from; /* below 2^30 */
    const int32_t centre = along * 65536 + 32768;
    const int64_t sum = fxl_multiply_s32(line->across + 8192 * 65536, length) +
                        fxl_multiply_s32(centre - line->from, line->rise);
    uint32_t remainder;
    FXL_ASSERT(sum >= 0);
    const uint32_t pixel = fxl_divide_u64((uint64_t)sum >> 16, (uint32_t)length, &remainder);
    *left = (int64_t)remainder * 65536 + (sum & 0xFFFF);
    return (int32_t)pixel - 8192;
}

/* *pixels becomes the line at the first place within low <= place < high; across changes by rise /
 * length a pixel, at most one pixel. The length is below 2^30, so a pixel is below 2^46. */
/* wire 2.3, 2.4 */
static fxl_line_extent find_places(const major_line *line, int32_t low, int32_t high,
                                   fxl_line_pixels *pixels)
{
    const int32_t begin = first_centre(line->from), behind = first_centre(line->to);
    const fxl_line_extent extent = {begin, begin > low ? begin : low,
                                    behind < high ? behind : high};
    if (extent.first < extent.end) {
        pixels->across = pixel_at(line, extent.first, &pixels->left);
        pixels->pixel = (int64_t)(line->to - line->from) * 65536;
        pixels->step = (int64_t)line->rise * 65536;
    }
    return extent;
}

/* wire 2.1 */
fxl_line_extent fxl_find_line_pixels(const fxl_screen_point *start, const fxl_screen_point *end,
                                     const fxl_band *band, fxl_line_pixels *pixels)
{
    const int32_t width = end->x - start->x, height = end->y - start->y; /* below 2^30 */
    pixels->upright = (height < 0 ? -height : height) > (width < 0 ? -width : width);
    if (pixels->upright) {
        const fxl_screen_point *top = height < 0 ? end : start;
        const major_line line = {top->y, height < 0 ? start->y : end->y, top->x,
                                 height < 0 ? -width : width};
        return find_places(&line, band->first_row, band->first_row + band->rows, pixels);
    }
    const fxl_screen_point *first = width < 0 ? end : start;
    const major_line line = {first->x, width < 0 ? start->x : end->x, first->y,
                             width < 0 ? -height : height};
    return find_places(&line, 0, band->width, pixels);
}

static void set_pixel(const fxl_band *band, int32_t x, int32_t y, uint8_t colour)
{
    const int32_t row = y - band->first_row;
    if (x >= band->first_column && x < (int32_t)fxl_band_end_column(band) &&
        row >= 0 && row < band->rows) {
        fxl_set_pixel(band, (size_t)row * band->stride + (size_t)x, colour);
    }
}

/* wire 2.2, 2.3 */
void fxl_draw_line_pixels(fxl_line_pixels *line, int32_t first, int32_t end, uint8_t colour,
                          const fxl_band *band)
{
    for (int32_t along = first; along < end; along++) {
        if (line->upright) {
            set_pixel(band, line->across, along, colour);
        } else {
            set_pixel(band, along, line->across, colour);
        }
        fxl_step_line_pixels(line);
    }
}

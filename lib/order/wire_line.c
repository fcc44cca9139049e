/* SPDX-License-Identifier: MIT */
#include "../math/arith.h"
#include "fixel/wire.h"
#include "../raster/line_pixels.h"

/* A line, described along its major axis. */
typedef struct {
    int32_t from, to; /* along the major axis, from < to */
    int32_t across;   /* at from */
    int32_t rise;     /* change across from `from` to `to`, no larger than to - from */
} major_line;

/* The first pixel whose centre is not before a coordinate. So the pixels with centres from a
 * (included) to b (excluded) are first_centre(a) .. first_centre(b) - 1. */
static int32_t first_centre(int32_t coordinate)
{
    return (coordinate + 32767) >> 16; /* ceil(c / 2^16 - 1/2) */
}

/* Returns the pixel across the line at the centre of pixel `along`. *left is the remainder, in
 * units of 1/2^16 of 1/length; a pixel is 65536 length of them. The sum is (across + 8192 *
 * 65536) length + (centre - from) rise. The first term is below 2^30 2^30; the second, between
 * two points of the line, is below 2^29 2^30. The sum is positive, because the point lies on the
 * line and no point lies beyond -4095 pixels. */
static int32_t pixel_at(const major_line *line, int32_t along, int64_t *left)
{
    const int32_t length = line->to - line->from; /* below 2^30 */
    const int32_t centre = along * 65536 + 32768;
    const int64_t sum = fxl_multiply_s32(line->across + 8192 * 65536, length) +
                        fxl_multiply_s32(centre - line->from, line->rise);
    uint32_t rest;
    FXL_ASSERT(sum >= 0);
    const uint32_t pixel = fxl_divide_u64((uint64_t)sum >> 16, (uint32_t)length, &rest);
    *left = (int64_t)rest * 65536 + (sum & 0xFFFF);
    return (int32_t)pixel - 8192;
}

/* Draws from pixel to pixel: across changes by rise / length, at most one pixel. The length is
 * below 2^30, so a pixel is below 2^46. */
static void draw_pixels(const major_line *line, int32_t first, int32_t end, bool upright,
                        uint8_t colour, const fxl_band *band)
{
    fxl_line_pixels pixels;
    if (first >= end) {
        return;
    }
    pixels.across = pixel_at(line, first, &pixels.left);
    pixels.pixel = (int64_t)(line->to - line->from) * 65536;
    pixels.step = (int64_t)line->rise * 65536;
    pixels.upright = upright;
    fxl_draw_line_pixels(&pixels, first, end, colour, band);
}

static int32_t greater(int32_t a, int32_t b)
{
    return a > b ? a : b;
}

static int32_t lesser(int32_t a, int32_t b)
{
    return a < b ? a : b;
}

void fxl_wire_line(const fxl_screen_point *from, const fxl_screen_point *to, uint8_t colour,
                   const fxl_band *band)
{
    const int32_t width = to->x - from->x, height = to->y - from->y; /* below 2^30 */
    const bool upright = (height < 0 ? -height : height) > (width < 0 ? -width : width);
    if (upright) {
        const fxl_screen_point *top = height < 0 ? to : from;
        const major_line line = {top->y, height < 0 ? from->y : to->y, top->x,
                                 height < 0 ? -width : width};
        draw_pixels(&line, greater(first_centre(line.from), band->first_row),
                    lesser(first_centre(line.to), band->first_row + band->rows), true, colour,
                    band);
    } else {
        const fxl_screen_point *first = width < 0 ? to : from;
        const major_line line = {first->x, width < 0 ? from->x : to->x, first->y,
                                 width < 0 ? -height : height};
        draw_pixels(&line, greater(first_centre(line.from), 0),
                    lesser(first_centre(line.to), band->width), false, colour, band);
    }
}

/* SPDX-License-Identifier: MIT */
#include "line_paint.h"

#include "../math/arith.h"
#include "../math/pixel_centre.h"
#include "../raster/draw_outline.h"

/* --- codes ---------------------------------------------------------------------------------- */

/* The code that a face with this plane has at the centre of a pixel. */
/* lines 3.2 */
static uint32_t code_of_plane(fxl_depth_scale scale, const fxl_depth_plane *plane, int32_t x,
                              int32_t y)
{
    const int64_t depth =
        plane->gradient.at + fxl_multiply_s64_u16(plane->gradient.down, (uint32_t)y);
    if (!fxl_depth_is_in_words(plane)) {
        return fxl_depth_code_at(scale, plane, depth, x);
    }
    const uint32_t word = fxl_low_32(fxl_bits_64(depth)) +
                          fxl_low_32(fxl_bits_64(plane->gradient.along)) * (uint32_t)x;
    fxl_depth_octave octave;
    fxl_depth_octave_of_word(scale, plane, word, &octave);
    return octave.bias + fxl_depth_shifted(depth, octave.drop) + octave.step * (uint32_t)x;
}

/* The depth of a line without planes from place to place along its major axis. */
typedef struct {
    fxl_depth_plane unit; /* its `one`: what depths are counted in */
    int64_t at, step;     /* at the first place, and what a place adds */
    int64_t low, high;    /* the depths of the ends */
    fxl_depth_octave octave;
} line_depth;

/* lines 3.3 */
static uint32_t code_of_depth(fxl_depth_scale scale, line_depth *depth)
{
    const int64_t value = depth->at < depth->low    ? depth->low
                          : depth->at > depth->high ? depth->high
                                                    : depth->at;
    fxl_depth_octave *octave = &depth->octave;
    if (!fxl_depth_octave_holds(octave, value)) {
        fxl_depth_octave_of(scale, &depth->unit, value, octave);
    }
    return octave->is_constant ? octave->bias
                               : octave->bias + fxl_depth_shifted(value, octave->drop);
}

/* near_z / distance as mantissa * 2^-one, off by less than 2^-28 of it. near_z has units of 2^-16
 * and the distance of 2^-46. */
static uint32_t end_depth(fxl_q16_16 near_z, fxl_q18_46 distance, int32_t *one)
{
    const fxl_real near_real = fxl_real_of((uint32_t)near_z, 0);
    const fxl_real divisor = fxl_real_of((uint64_t)distance, 0);
    *one = divisor.exponent - near_real.exponent + 1;
    return fxl_mantissa_ratio(&near_real, &divisor);
}

/* mantissa 2^shift, rounded down. A mantissa is below 2^32, and a shift at most 29. */
static int64_t scaled(uint32_t mantissa, int32_t shift)
{
    return shift >= 0 ? (int64_t)((uint64_t)mantissa << shift)
                      : (int64_t)(shift > -32 ? mantissa >> -shift : 0);
}

/* The depths of both ends in one unit, in which the nearer one is below 2^61. */
static void find_ends(const fxl_line_canvas *canvas, const fxl_painted_line *line, int64_t ends[2],
                      line_depth *depth)
{
    int32_t first_one, second_one;
    const uint32_t first = end_depth(canvas->near_z, line->distances[0], &first_one);
    const uint32_t second = end_depth(canvas->near_z, line->distances[1], &second_one);
    const int32_t one = (first_one < second_one ? first_one : second_one) + 29;
    ends[0] = scaled(first, one - first_one);
    ends[1] = scaled(second, one - second_one);
    depth->unit.gradient.at = depth->unit.gradient.along = depth->unit.gradient.down = 0;
    depth->unit.one = one;
    depth->low = ends[0] < ends[1] ? ends[0] : ends[1];
    depth->high = ends[0] < ends[1] ? ends[1] : ends[0];
    depth->at = ends[0];
    depth->step = 0;
    depth->octave.low = depth->octave.high = 0; /* holds nothing */
}

/* whole * part / length, off by less than 2. Requires whole < 2^61 and length < 2^30, and either
 * part <= length, or part = 65536 < length: products of the quotient are at most whole, and those of
 * the remainder are below 2^60. */
static uint64_t share(uint64_t whole, uint32_t part, uint32_t length)
{
    uint32_t remainder;
    const uint32_t high = fxl_divide_u64(whole >> 32, length, &remainder);
    const uint32_t low =
        fxl_divide_u64((uint64_t)remainder << 32 | fxl_low_32(whole), length, &remainder);
    const uint32_t rest = fxl_divide_u64(fxl_multiply_u32(remainder, part), length, &remainder);
    const int64_t quotient = (int64_t)((uint64_t)high << 32 | low);
    return (uint64_t)fxl_multiply_s64(quotient, part) + rest;
}

/* Sets the depth at the first place of the extent, and its step. The first place of the whole line
 * does not depend on the band, so neither do the depths. A line of at most a pixel has one place. */
/* lines 3.3 */
static void find_depth(const fxl_painted_line *line, const fxl_line_extent *extent, bool upright,
                       const int64_t ends[2], line_depth *depth)
{
    const int32_t a = upright ? line->ends[0].y : line->ends[0].x;
    const int32_t b = upright ? line->ends[1].y : line->ends[1].x;
    const bool swapped = b < a;
    const uint32_t length = (uint32_t)(swapped ? a - b : b - a); /* below 2^30 */
    const int64_t from = ends[swapped], to = ends[!swapped];
    const uint64_t whole = (uint64_t)(from < to ? to - from : from - to);
    const uint32_t before = (uint32_t)(fxl_centre_of(extent->begin) - (swapped ? b : a));
    const int64_t rise = (int64_t)share(whole, before, length);
    const int64_t step = length > 65536 ? (int64_t)share(whole, 65536, length) : 0;
    depth->step = from < to ? step : -step;
    depth->at = (from < to ? from + rise : from - rise) +
                fxl_multiply_s64(depth->step, extent->first - extent->begin);
}

/* --- pixels --------------------------------------------------------------------------------- */

/* A pixel; code: of a line without planes. */
/* lines 3.1, 3.2 */
static void paint_pixel(const fxl_line_canvas *canvas, const fxl_painted_line *line, int32_t x,
                        int32_t y, uint32_t code)
{
    const fxl_band *band = canvas->band;
    const fxl_depth_head *head = canvas->head;
    const int32_t row = y - band->first_row;
    if (x < band->first_column || x >= (int32_t)fxl_band_end_column(band) || row < 0 ||
        row >= band->rows) {
        return;
    }
    if (head != NULL) {
        const fxl_depth_rule rule = {canvas->wide, true};
        void *cells = (uint8_t *)(uintptr_t)(head + 1) +
                      (size_t)row * band->width * (canvas->wide ? 4u : 2u);
        for (uint32_t i = 0; i < line->plane_count; i++) {
            const uint32_t other = code_of_plane(head->scale, &line->planes[i], x, y);
            code = i == 0 || other > code ? other : code;
        }
        if (!fxl_depth_passes(cells, x, code, rule)) {
            return;
        }
        fxl_depth_keep(cells, x, code, canvas->wide);
    }
    fxl_set_pixel(band, (size_t)row * band->stride + (size_t)x, line->colour);
}

/* place fill-rule: the pixels of a line with a width, and of a point */
/* The first of `width` pixels about a coordinate. */
/* lines 2.2, 2.3 */
static fxl_q16_16 first_of(fxl_q16_16 coordinate, uint32_t width)
{
    return coordinate - (int32_t)(width - 1) * 32768;
}

/* lines 2.3 */
static void paint_point(const fxl_line_canvas *canvas, const fxl_painted_line *line, uint32_t code)
{
    const int32_t left = first_of(line->ends[0].x, line->width) >> 16;
    const int32_t top = first_of(line->ends[0].y, line->width) >> 16;
    for (int32_t y = top; y < top + line->width; y++) {
        for (int32_t x = left; x < left + line->width; x++) {
            paint_pixel(canvas, line, x, y, code);
        }
    }
}

/* lines 2.2 */
static void paint_line(const fxl_line_canvas *canvas, const fxl_painted_line *line,
                       const int64_t ends[2], line_depth *depth)
{
    const fxl_screen_point *a = &line->ends[0], *b = &line->ends[1];
    const int32_t width = b->x - a->x, height = b->y - a->y; /* below 2^30 */
    const bool upright = (height < 0 ? -height : height) > (width < 0 ? -width : width);
    const bool has_depth = canvas->head != NULL && line->plane_count == 0;
    fxl_screen_point moved[2] = {*a, *b};
    fxl_line_pixels pixels;
    for (uint32_t i = 0; i < 2; i++) {
        fxl_q16_16 *across = upright ? &moved[i].x : &moved[i].y;
        *across = first_of(*across, line->width);
    }
    const fxl_line_extent extent =
        fxl_find_line_pixels(&moved[0], &moved[1], canvas->band, &pixels);
    if (has_depth && extent.first < extent.end) {
        find_depth(line, &extent, upright, ends, depth);
    }
    for (int32_t along = extent.first; along < extent.end; along++) {
        const uint32_t code = has_depth ? code_of_depth(canvas->head->scale, depth) : 0;
        for (int32_t across = pixels.across; across < pixels.across + line->width; across++) {
            paint_pixel(canvas, line, upright ? across : along, upright ? along : across, code);
        }
        depth->at += depth->step;
        fxl_step_line_pixels(&pixels);
    }
}

void fxl_paint_wide_line(const fxl_line_canvas *canvas, const fxl_painted_line *line)
{
    line_depth depth = {.at = 0, .step = 0};
    int64_t ends[2] = {0, 0};
    uint32_t code = 0;
    if (canvas->head != NULL && line->plane_count == 0) {
        find_ends(canvas, line, ends, &depth);
        code = code_of_depth(canvas->head->scale, &depth);
    }
    if (line->is_point) {
        paint_point(canvas, line, code);
    } else {
        paint_line(canvas, line, ends, &depth);
    }
}

/* A line's pixels lie less than (width + 1) / 2 from it. */
fxl_rows fxl_rows_of_line(const fxl_painted_line *line, uint16_t height)
{
    const fxl_screen_point *a = &line->ends[0], *b = line->is_point ? a : &line->ends[1];
    const int32_t reach = (line->width + 1) * 32768;
    const int32_t top = ((a->y < b->y ? a->y : b->y) - reach) >> 16;
    const int32_t end = (((a->y < b->y ? b->y : a->y) + reach) >> 16) + 1;
    const fxl_rows none = {0, 0};
    if (end <= 0 || top >= height) {
        return none;
    }
    const fxl_rows rows = {(uint16_t)(top > 0 ? top : 0), (uint16_t)(end < height ? end : height)};
    return rows;
}

/* SPDX-License-Identifier: MIT */
#include "line_paint.h"

#include "line_run.h"

/* --- pixels --------------------------------------------------------------------------------- */

#define INLINED  static inline __attribute__((always_inline))
#define OUTLINED static __attribute__((noinline))

/* Where the first place is; up: the axes of a line that does not fall. */
INLINED void find_cell(const fxl_line_canvas *canvas, const fxl_line_axes *up, fxl_line_way *way)
{
    const int32_t first = way->first, across = way->across;
    way->cell =
        (uint8_t *)(canvas->cells + (uint32_t)(first * up->cell_along + across * up->cell_across));
    if (canvas->format == FXL_LINE_NARROW) {
        way->apart = canvas->apart;
    } else {
        way->pixel = (uint8_t *)(canvas->pixels +
                                 (uint32_t)(first * up->pixel_along + across * up->pixel_across));
    }
}

/* A colour, as it is written. */
INLINED uint32_t colour_of(const fxl_line_canvas *canvas, const fxl_painted_line *line)
{
    return (canvas->format & FXL_LINE_COLOURS) != 0 ? canvas->band->palette[line->colour]
                                                    : line->colour;
}

/* A pixel of the band; code: of a line without planes. */
/* lines 3.2 */
static void paint_pixel(const fxl_line_canvas *canvas, const fxl_painted_line *line, int32_t x,
                        int32_t y, uint32_t code)
{
    const fxl_band *band = canvas->band;
    const fxl_line_axes *axes = &canvas->axes[0];
    if (canvas->head == NULL) {
        fxl_set_pixel(band, (size_t)(y - band->first_row) * band->stride + (size_t)x, line->colour);
        return;
    }
    for (uint32_t i = 0; i < line->plane_count; i++) {
        const uint32_t other = fxl_line_code_of_face(canvas->head->scale, line->planes[i], x, y);
        code = i == 0 || other > code ? other : code;
    }
    fxl_line_way way;
    way.first = x;
    way.across = y;
    find_cell(canvas, axes, &way);
    fxl_line_paint_place(way.cell, fxl_line_pixel_of(&way, canvas->format), colour_of(canvas, line),
                         code, canvas->format);
}

/* Pixels: first <= column < end, and so rows. */
typedef struct {
    int32_t first_column, end_column, first_row, end_row;
} pixel_box;

/* Those pixels of a box that the band has. */
static void paint_box(const fxl_line_canvas *canvas, const fxl_painted_line *line,
                      const pixel_box *box, uint32_t code)
{
    const fxl_line_axes *axes = &canvas->axes[0];
    const int32_t end_row = box->end_row < axes->high ? box->end_row : axes->high;
    const int32_t end_column = box->end_column < axes->end ? box->end_column : axes->end;
    for (int32_t y = box->first_row > axes->low ? box->first_row : axes->low; y < end_row; y++) {
        for (int32_t x = box->first_column > axes->first ? box->first_column : axes->first;
             x < end_column; x++) {
            paint_pixel(canvas, line, x, y, code);
        }
    }
}

/* place fill-rule: the pixels of a line with a width, and of a point */
/* The first of `width` pixels about a coordinate. */
/* lines 2.2, 2.3 */
INLINED fxl_q16_16 first_of(fxl_q16_16 coordinate, uint32_t width)
{
    return coordinate - (int32_t)(width - 1) * 32768;
}

/* lines 2.3 */
static FXL_COLD void paint_point(fxl_line_canvas *canvas, const fxl_painted_line *line)
{
    const int32_t left = first_of(line->ends[0].x, line->width) >> 16;
    const int32_t top = first_of(line->ends[0].y, line->width) >> 16;
    const pixel_box box = {left, left + line->width, top, top + line->width};
    uint32_t code = 0;
    if (canvas->head != NULL && line->plane_count == 0) {
        const fxl_line_end_depths ends = fxl_line_find_ends(canvas, line->distances);
        const fxl_line_depth depth = {ends.one, ends.first, 0};
        code = fxl_line_code_of_depth(canvas->head->scale, &depth);
    }
    paint_box(canvas, line, &box, code);
}

/* Without a depth buffer: a column or a row after the other. */
/* lines 2.2 */
static FXL_COLD void paint_plain(const fxl_line_canvas *canvas, const fxl_painted_line *line,
                                 fxl_line_way *way)
{
    const int32_t width = line->width;
    const fxl_line_axes *axes = way->axes;
    for (; way->count > 0; way->count--, way->first++) {
        const int32_t along = way->first, across = way->across;
        const pixel_box row = {across, across + width, along, along + 1};
        const pixel_box column = {along, along + 1, across, across + width};
        paint_box(canvas, line, axes->upright != 0 ? &row : &column, 0);
        way->across += fxl_line_step_behind(way) ? axes->change : 0;
    }
}

/* --- a pixel a place, with a depth buffer ---------------------------------------------------- */

/* A line on the screen, one pixel of its width. */
typedef struct {
    fxl_line_way way;   /* what the band has of it */
    fxl_line_ends ends; /* of the whole line */
    bool swapped;       /* the first end is the higher one */
} one_line;

/* With the line's own depth. */
/* lines 3.3 */
OUTLINED void paint_own(fxl_line_canvas *canvas, const fxl_painted_line *line, const one_line *of)
{
    const fxl_depth_scale scale = canvas->head->scale;
    const uint32_t format = canvas->format;
    fxl_line_depth depth;
    fxl_line_find_depth(canvas, line, &of->ends, of->swapped, of->way.first, &depth);
    if (format == FXL_LINE_NARROW) {
        fxl_line_paint_own(&of->way, scale, &depth, FXL_LINE_NARROW);
    } else {
        fxl_line_paint_own(&of->way, scale, &depth, format);
    }
}

/* By stretches in which each face has one octave. */
/* lines 3.2 */
OUTLINED void paint_stretches(const fxl_line_canvas *canvas, const fxl_painted_line *line,
                              const fxl_line_way *whole)
{
    const fxl_depth_scale scale = canvas->head->scale;
    const fxl_line_axes *axes = whole->axes;
    fxl_line_way way = *whole;
    for (;;) {
        int32_t changes;
        int32_t count = fxl_line_find_stretch(scale, line->planes[0], &way, way.count, &changes);
        if (line->plane_count > 1) {
            count = fxl_line_find_stretch(scale, line->planes[1], &way, count, &changes);
        }
        fxl_line_paint_faces(canvas->format, line, &way, count);
        way.count -= count;
        if (way.count == 0) {
            return;
        }
        way.first += count;
        way.across += changes * axes->change;
        way.behind += count * way.step - changes * way.size;
        way.cell += count * axes->cell_along + changes * axes->cell_across;
        if (canvas->format != FXL_LINE_NARROW) {
            way.pixel += count * axes->pixel_along + changes * axes->pixel_across;
        }
    }
}

/* On faces. Most octaves hold a whole line. */
/* lines 3.2 */
OUTLINED void paint_on_faces(const fxl_line_canvas *canvas, const fxl_painted_line *line,
                             const one_line *of)
{
    const fxl_depth_scale scale = canvas->head->scale;
    const uint32_t upright = of->way.axes->upright;
    if (!fxl_line_is_held(scale, line->planes[0], &of->ends, upright) ||
        (line->plane_count > 1 && !fxl_line_is_held(scale, line->planes[1], &of->ends, upright))) {
        paint_stretches(canvas, line, &of->way);
    } else {
        fxl_line_paint_faces(canvas->format, line, &of->way, of->way.count);
    }
}

/* Some of whose pixels may lie outside of the band, across. */
OUTLINED void paint_within(fxl_line_canvas *canvas, const fxl_painted_line *line,
                           const one_line *whole)
{
    one_line of = *whole;
    fxl_line_way *way = &of.way;
    const fxl_line_axes *axes = way->axes;
    while (way->across < axes->low || way->across >= axes->high) {
        if (--way->count == 0) {
            return;
        }
        way->first++;
        way->across += fxl_line_step_behind(way) ? axes->change : 0;
    }
    /* It leaves the band where the pixel across has changed so often, and once more. */
    const int32_t room = axes->change < 0 ? way->across - axes->low : axes->high - 1 - way->across;
    const uint64_t rest = fxl_multiply_u32((uint32_t)room, (uint32_t)way->size) +
                          (uint64_t)-way->behind; /* below 2^43 */
    const uint32_t step = (uint32_t)way->step;
    if (rest >> 32 < step) {
        uint32_t left;
        const uint32_t places = fxl_divide_u64(rest, step, &left) + (left != 0 ? 1u : 0u);
        way->count = places < (uint32_t)way->count ? (int32_t)places : way->count;
    }
    find_cell(canvas, &canvas->axes[axes->upright * 2u], way);
    if (line->plane_count == 0) {
        paint_own(canvas, line, &of);
    } else {
        paint_stretches(canvas, line, way);
    }
}

/* One pixel of the width; up: the axes of a line that does not fall. */
INLINED void paint_places(fxl_line_canvas *canvas, const fxl_painted_line *line,
                          const fxl_line_axes *up, one_line *of)
{
    const int32_t last = (of->ends.side + of->ends.rise) >> 16; /* or a pixel beside it */
    if ((uint32_t)(of->way.across - up->inner) >= up->inner_count ||
        (uint32_t)(last - up->inner) >= up->inner_count) {
        paint_within(canvas, line, of);
        return;
    }
    find_cell(canvas, up, &of->way);
    if (line->plane_count == 0) {
        paint_own(canvas, line, of);
    } else {
        paint_on_faces(canvas, line, of);
    }
}

/* The others of the width, in any sequence. */
OUTLINED void paint_others(fxl_line_canvas *canvas, const fxl_painted_line *line,
                           const fxl_line_axes *up, one_line *of)
{
    for (int32_t row = line->width; row > 1; row--) {
        of->way.across++;
        of->ends.side += 65536;
        paint_places(canvas, line, up, of);
    }
}

/* The pixel across at a place, for a line that does not begin in the band; *left becomes what is left
 * to the next one. As fxl_find_line_pixels finds it, from a whole pixel near the line instead of one
 * above the screen: the sum is (side + steps * 65536) length + centre rise, at least 0 since |rise| <=
 * length, and at most what 3 * 2^59 is. */
static FXL_COLD int32_t find_pixel(fxl_q16_16 side, fxl_q16_16 centre, int32_t length, int32_t rise,
                                   int32_t *left)
{
    const int32_t steps = rise < 0 ? (centre >> 16) + 1 : 0;
    const int64_t sum = fxl_multiply_s32(side & 0xFFFF, length) + fxl_multiply_s32(centre, rise) +
                        fxl_multiply_s32(steps, length) * 65536;
    uint32_t rest;
    const uint32_t pixel = fxl_divide_u64((uint64_t)sum >> 16, (uint32_t)length, &rest);
    *left = (int32_t)rest;
    return (side >> 16) - steps + (int32_t)pixel;
}

/* place fill-rule: the pixels of a line, whose places begin with the first centre that is not before it */
/* The first centre of a whole line is less than a pixel behind its end, so that the sum of find_pixel
 * is below 2^17 length. */
/* lines 2.2, wire 2.2, 2.3 */
static void paint_line(fxl_line_canvas *canvas, const fxl_painted_line *line)
{
    const fxl_screen_point *a = &line->ends[0], *b = &line->ends[1];
    one_line of;
    fxl_q16_16 from = a->x, side = a->y;
    int32_t length = b->x - from, rise = b->y - side; /* below 2^30 */
    const fxl_line_axes *up = canvas->axes;
    if ((rise < 0 ? -rise : rise) > (length < 0 ? -length : length)) {
        const int32_t width = length;
        from = a->y;
        side = a->x;
        length = rise;
        rise = width;
        up += 2;
    }
    of.swapped = length < 0;
    if (length < 0) {
        from += length;
        side += rise;
        length = -length;
        rise = -rise;
    }
    side = first_of(side, line->width);
    of.ends.from = from;
    of.ends.side = side;
    of.ends.length = length;
    of.ends.rise = rise;
    const int32_t begin = (from + 32767) >> 16, behind = (from + length + 32767) >> 16;
    int32_t first = begin, end = behind;
    if (begin < up->first || behind > up->end) {
        first = begin > up->first ? begin : up->first;
        end = behind < up->end ? behind : up->end;
    }
    if (first >= end) {
        return;
    }
    int32_t across = side >> 16, left;
    const fxl_q16_16 centre = fxl_centre_of(first) - from;
    if (first == begin) {
        const int64_t sum =
            fxl_multiply_s32(side & 0xFFFF, length) + fxl_multiply_s32(centre, rise);
        left = (int32_t)(sum >> 16);
        if (rise < 0) {
            across--;
            left += length;
        }
        if (left >= length) {
            across++;
            left -= length;
        }
    } else {
        across = find_pixel(side, centre, length, rise, &left);
    }
    of.way.first = first;
    of.way.count = end - first;
    of.way.across = across;
    of.way.size = length;
    of.way.step = rise;
    of.way.behind = left - length;
    of.way.axes = up;
    if (rise < 0) {
        of.way.axes = up + 1;
        of.way.step = -rise;
        of.way.behind = -1 - left;
    }
    of.way.colour = line->colour;
    if (canvas->format != FXL_LINE_NARROW) {
        if (canvas->format == FXL_LINE_PLAIN) {
            paint_plain(canvas, line, &of.way);
            return;
        }
        of.way.colour = colour_of(canvas, line);
    }
    paint_places(canvas, line, up, &of);
    if (line->width > 1) {
        paint_others(canvas, line, up, &of);
    }
}

/* By whether a line is upright, and whether it falls. */
static void find_axes(fxl_line_canvas *canvas, bool upright, bool falls)
{
    fxl_line_axes *axes = &canvas->axes[(upright ? 2 : 0) + (falls ? 1 : 0)];
    const fxl_band *band = canvas->band;
    const int32_t first_column = band->first_column, first_row = band->first_row;
    const int32_t end_column = (int32_t)fxl_band_end_column(band);
    const int32_t end_row = first_row + band->rows;
    const int32_t cell = (canvas->format & FXL_LINE_WIDE) != 0 ? 4 : 2;
    const int32_t pixel = (canvas->format & FXL_LINE_COLOURS) != 0 ? 2 : 1;
    const int32_t cell_row = cell * band->width, pixel_row = pixel * band->stride;
    const int32_t change = falls ? -1 : 1;
    axes->upright = upright;
    axes->change = change;
    axes->first = upright ? first_row : first_column;
    axes->end = upright ? end_row : end_column;
    axes->low = upright ? first_column : first_row;
    axes->high = upright ? end_column : end_row;
    axes->inner = axes->low + 1;
    axes->inner_count = axes->high - axes->low > 2 ? (uint32_t)(axes->high - axes->low - 2) : 0;
    axes->cell_along = upright ? cell_row : cell;
    axes->pixel_along = upright ? pixel_row : pixel;
    axes->cell_across = (upright ? cell : cell_row) * change;
    axes->pixel_across = (upright ? pixel : pixel_row) * change;
}

/* Within the face codes are from 65536 on, and what is found at a corner is less than 32768 below that.
 * What a pixel adds is below 2^31, so a code is below 2^47. */
/* lines 3.2 */
FXL_COLD void fxl_line_continue_words(fxl_depth_plane *plane, const fxl_screen_point *corner)
{
    fxl_gradient *gradient = &plane->gradient;
    const int32_t along = fxl_signed_32(fxl_low_32(fxl_bits_64(gradient->along)));
    const int32_t down = fxl_signed_32(fxl_low_32(fxl_bits_64(gradient->down)));
    const int64_t more = fxl_multiply_s32(along, corner->x - 32768) +
                         fxl_multiply_s32(down, corner->y - 32768);
    const int64_t change = more >> 16;
    const uint32_t code = fxl_low_32(fxl_bits_64(gradient->at + change)) - 32768u;
    gradient->at = ((int64_t)code + 32768 - change) * 65536;
    gradient->along = (int64_t)along * 65536;
    gradient->down = (int64_t)down * 65536;
}

/* The depth of the first pixel, which is beyond near_z on a plane before it, is counted as less than 2^46,
 * and what a pixel adds is below 2^30. So sums are below 2^63, and their upper words off by less than 2. The
 * centres of a line's pixels lie within half a pixel of the straight line between its ends, across. Of codes
 * times 2^16 the lower 20 bits are left out: a word has 12. */
void fxl_line_plane_begin(fxl_line_plane *face)
{
    const fxl_gradient *gradient = &face->plane.gradient;
    const uint64_t right = fxl_magnitude(gradient->along);
    const uint64_t down = fxl_magnitude(gradient->down);
    const uint64_t most = right > down ? right : down;
    const uint64_t first = fxl_magnitude(gradient->at);
    uint32_t added = 4;
    int32_t drop = 20;
    face->span = face->held = 0;
    if (fxl_depth_is_in_words(&face->plane)) {
        added += FXL_LINE_MARGIN_OF_WORDS;
    } else {
        const int32_t least = (int32_t)fxl_bit_length(most | first >> 16 | 1u) - 30;
        drop = least > -16 ? least : -16;
    }
    face->drop = drop;
    face->margin = fxl_low_32(most >> (drop + 17)) + added; /* at most 2^14 more */
    face->words[0] = fxl_signed_32(fxl_depth_shifted(gradient->along, drop));
    face->words[1] = fxl_signed_32(fxl_depth_shifted(gradient->down, drop));
    /* The centre of the first pixel is half a pixel behind its corner. */
    face->at = (int64_t)((drop < 16 ? fxl_bits_64(gradient->at) << (16 - drop)
                                    : fxl_bits_64(gradient->at >> (drop - 16))) -
                         fxl_bits_64(((int64_t)face->words[0] + face->words[1]) * 32768));
}

/* place pixel-format: the bytes of a pixel of lines */
void fxl_line_canvas_begin(fxl_line_canvas *canvas, const fxl_band *band,
                           const fxl_depth_head *head, fxl_q16_16 near_z, bool wide)
{
    const bool is_colour = fxl_kind_of_band(band).is_colour;
    canvas->band = band;
    canvas->head = head;
    if (head != NULL) {
        canvas->near_real = fxl_real_of((uint32_t)near_z, 0);
    }
    canvas->distance = 0;
    canvas->mantissa = 0;
    canvas->one = 0;
    canvas->format =
        (wide ? (uint32_t)FXL_LINE_WIDE : 0u) | (is_colour ? (uint32_t)FXL_LINE_COLOURS : 0u);
    for (uint32_t i = 0; i < 4; i++) {
        find_axes(canvas, i > 1, i % 2 != 0);
    }
    if (head != NULL && band->stride != band->width) {
        canvas->format |= FXL_LINE_APART;
    }
    if (head == NULL) {
        canvas->format = FXL_LINE_PLAIN;
    }
    const uint32_t row = (uint32_t)band->first_row;
    canvas->cells = (uintptr_t)head + sizeof *head - row * (uint32_t)canvas->axes[2].cell_along;
    canvas->pixels = (uintptr_t)band->pixels - row * (uint32_t)canvas->axes[2].pixel_along;
    canvas->apart = canvas->pixels - (canvas->cells >> 1);
}

void fxl_paint_wide_line(fxl_line_canvas *canvas, const fxl_painted_line *line)
{
    if (line->is_point) {
        paint_point(canvas, line);
    } else {
        paint_line(canvas, line);
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

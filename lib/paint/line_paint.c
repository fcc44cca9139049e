/* SPDX-License-Identifier: MIT */
#include "line_paint.h"

#include "line_run.h"

/* --- pixels --------------------------------------------------------------------------------- */

/* Where pixels are painted, and by what. */
typedef struct {
    fxl_line_canvas *canvas;
    const fxl_painted_line *line;
} painting;

#define INLINED static inline __attribute__((always_inline))

/* To the next place. Returns whether the pixel across changes. */
INLINED bool step_place(fxl_line_places *places)
{
    places->first++;
    places->left += places->step;
    if (places->left < places->pixel) {
        return false;
    }
    places->left -= places->pixel;
    places->across += places->change;
    return true;
}

/* At a pixel of the band. */
INLINED fxl_line_way run_at(const painting *of, int32_t x, int32_t y)
{
    const fxl_line_canvas *canvas = of->canvas;
    const fxl_band *band = canvas->band;
    const int32_t row = y - canvas->box.first_row;
    fxl_line_way run;
    run.cell = (uint8_t *)(uintptr_t)(canvas->head + 1) + row * canvas->cell_row +
               x * (int32_t)canvas->cell;
    run.pixel = band->pixels + row * canvas->pixel_row + x * (int32_t)canvas->pixel;
    run.colour = (canvas->format & FXL_LINE_COLOURS) != 0 ? band->palette[of->line->colour]
                                                          : of->line->colour;
    return run;
}

/* A pixel of the band; code: of a line without planes. */
/* lines 3.2 */
static void paint_pixel(const painting *of, int32_t x, int32_t y, uint32_t code)
{
    const fxl_line_canvas *canvas = of->canvas;
    const fxl_painted_line *line = of->line;
    const fxl_band *band = canvas->band;
    if (canvas->head == NULL) {
        fxl_set_pixel(band, (size_t)(y - band->first_row) * band->stride + (size_t)x, line->colour);
        return;
    }
    for (uint32_t i = 0; i < line->plane_count; i++) {
        const uint32_t other = fxl_line_code_of_face(canvas->head->scale, line->planes[i], x, y);
        code = i == 0 || other > code ? other : code;
    }
    const fxl_line_way run = run_at(of, x, y);
    fxl_line_paint_place(&run, code, of->canvas->format);
}

/* Those pixels of a box that the band has. */
static void paint_box(const painting *of, const fxl_pixel_box *box, uint32_t code)
{
    const fxl_pixel_box *band = &of->canvas->box;
    const int32_t end_row = box->end_row < band->end_row ? box->end_row : band->end_row;
    const int32_t end_column =
        box->end_column < band->end_column ? box->end_column : band->end_column;
    for (int32_t y = box->first_row > band->first_row ? box->first_row : band->first_row;
         y < end_row; y++) {
        for (int32_t x = box->first_column > band->first_column ? box->first_column
                                                                : band->first_column;
             x < end_column; x++) {
            paint_pixel(of, x, y, code);
        }
    }
}

/* place fill-rule: the pixels of a line with a width, and of a point */
/* The first of `width` pixels about a coordinate. */
/* lines 2.2, 2.3 */
static fxl_q16_16 first_of(fxl_q16_16 coordinate, uint32_t width)
{
    return coordinate - (int32_t)(width - 1) * 32768;
}

/* lines 2.3 */
static void paint_point(const painting *of, uint32_t code)
{
    const fxl_painted_line *line = of->line;
    const int32_t left = first_of(line->ends[0].x, line->width) >> 16;
    const int32_t top = first_of(line->ends[0].y, line->width) >> 16;
    const fxl_pixel_box box = {left, left + line->width, top, top + line->width};
    paint_box(of, &box, code);
}

/* Without a depth buffer: a column or a row after the other. */
/* lines 2.2 */
static void paint_plain(const painting *of, fxl_line_places *places)
{
    const int32_t width = of->line->width;
    while (places->first < places->end) {
        const int32_t along = places->first, across = places->across;
        const fxl_pixel_box row = {across, across + width, along, along + 1};
        const fxl_pixel_box column = {along, along + 1, across, across + width};
        paint_box(of, places->upright ? &row : &column, 0);
        (void)step_place(places);
    }
}

/* --- a pixel a place, with a depth buffer ---------------------------------------------------- */

/* A line from its first place on, whose pixel is one of the band. */
INLINED fxl_line_way run_of(const painting *of, const fxl_line_places *places)
{
    const fxl_line_canvas *canvas = of->canvas;
    const fxl_pixel_box *box = &canvas->box;
    const bool upright = places->upright, falls = places->change < 0;
    const int32_t cell = (int32_t)canvas->cell, pixel = (int32_t)canvas->pixel;
    const int32_t cell_row = canvas->cell_row, pixel_row = canvas->pixel_row;
    const int32_t cell_across = upright ? cell : cell_row;
    const int32_t pixel_across = upright ? pixel : pixel_row;
    fxl_line_way run = run_at(of, upright ? places->across : places->first,
                              upright ? places->first : places->across);
    run.cell_along = upright ? cell_row : cell;
    run.pixel_along = upright ? pixel_row : pixel;
    run.cell_across = falls ? -cell_across : cell_across;
    run.pixel_across = falls ? -pixel_across : pixel_across;
    run.count = (uint32_t)(places->end - places->first);
    run.room = (uint32_t)(falls ? places->across - (upright ? box->first_column : box->first_row)
                                : (upright ? box->end_column : box->end_row) - 1 - places->across);
    run.behind = (int32_t)places->left - (int32_t)places->pixel;
    run.step = (int32_t)places->step;
    run.size = (int32_t)places->pixel;
    return run;
}

/* With the line's own depth, which is at the first place. */
/* lines 3.3 */
static void paint_with_depth(const painting *of, const fxl_line_places *places,
                             fxl_line_depth *depth)
{
    const fxl_line_way run = run_of(of, places);
    const fxl_depth_scale scale = of->canvas->head->scale;
    const uint32_t format = of->canvas->format;
    if (format == FXL_LINE_NARROW) {
        fxl_line_paint_own(&run, scale, depth, FXL_LINE_NARROW);
    } else {
        fxl_line_paint_own(&run, scale, depth, format);
    }
}

static void paint_stretch(fxl_line_way *run, const fxl_line_codes codes[2], uint32_t places,
                          uint32_t faces, uint32_t format)
{
    if (format != FXL_LINE_NARROW || codes[0].shift != 0 || codes[faces - 1].shift != 0) {
        if (faces == 1) {
            fxl_line_paint_stretch(run, codes, places, 1, true, format);
        } else {
            fxl_line_paint_stretch(run, codes, places, 2, true, format);
        }
    } else if (faces == 1) {
        fxl_line_paint_stretch(run, codes, places, 1, false, FXL_LINE_NARROW);
    } else {
        fxl_line_paint_stretch(run, codes, places, 2, false, FXL_LINE_NARROW);
    }
}

/* lines 3.2 */
static void paint_on_faces(const painting *of, fxl_line_places *places)
{
    const uint32_t faces = of->line->plane_count, format = of->canvas->format;
    const fxl_depth_scale scale = of->canvas->head->scale;
    fxl_line_way run = run_of(of, places);
    const int32_t across = places->across, room = (int32_t)run.room;
    uint32_t rest;
    const uint32_t rate = /* 4096 at most */
        fxl_divide_u32(places->step, (places->pixel >> 12) + 1u, &rest);
    for (;;) {
        fxl_line_codes codes[2];
        uint32_t count = run.count;
        for (uint32_t i = 0; i < faces; i++) {
            count =
                fxl_line_codes_begin(scale, of->line->planes[i], places, rate, count, &codes[i]);
        }
        paint_stretch(&run, codes, count, faces, format);
        if (run.count == 0) {
            return;
        }
        places->first = places->end - (int32_t)run.count;
        places->left = (uint32_t)(run.behind + run.size);
        places->across = across + places->change * (room - (int32_t)run.room);
    }
}

/* To the first place whose pixel is one of the band. False: there is none. */
INLINED bool enter_band(const fxl_pixel_box *band, fxl_line_places *places, fxl_line_depth *depth)
{
    const bool upright = places->upright;
    const int32_t begin = upright ? band->first_column : band->first_row;
    const uint32_t size = (uint32_t)((upright ? band->end_column : band->end_row) - begin);
    while ((uint32_t)(places->across - begin) >= size) {
        depth->at += depth->step;
        (void)step_place(places);
        if (places->first >= places->end) {
            return false;
        }
    }
    return true;
}

/* One pixel of the width. */
static void paint_row(const painting *of, fxl_line_places *places, fxl_line_depth *depth)
{
    if (!enter_band(&of->canvas->box, places, depth)) {
        return;
    }
    if (of->line->plane_count == 0) {
        paint_with_depth(of, places, depth);
    } else {
        paint_on_faces(of, places);
    }
}

/* place fill-rule: the pixels of a line, whose places begin with the first centre that is not before it */
/* The places of a line within the band. Returns the first of the whole line, within the band or before
 * it. As fxl_find_line_pixels finds them, from a whole pixel near the line instead of one above the
 * screen: the sum is (across + steps * 65536) length + (centre - from) rise, at least 0 since |rise|
 * <= length, and at most what 3 * 2^59 is. */
/* lines 2.2, wire 2.2, 2.3 */
INLINED int32_t find_places(const painting *of, fxl_line_places *places)
{
    const fxl_screen_point *a = &of->line->ends[0], *b = &of->line->ends[1];
    const int32_t width = b->x - a->x, height = b->y - a->y; /* below 2^30 */
    const bool upright = (height < 0 ? -height : height) > (width < 0 ? -width : width);
    const bool swapped = (upright ? height : width) < 0;
    const fxl_screen_point *start = swapped ? b : a;
    const int32_t from = upright ? start->y : start->x;
    const int32_t across = first_of(upright ? start->x : start->y, of->line->width);
    const int32_t along = upright ? height : width, other = upright ? width : height;
    const int32_t length = swapped ? -along : along, rise = swapped ? -other : other;
    const int32_t begin = (from + 32767) >> 16, behind = (from + length + 32767) >> 16;
    const int32_t low = upright ? of->canvas->box.first_row : of->canvas->box.first_column;
    const int32_t high = upright ? of->canvas->box.end_row : of->canvas->box.end_column;
    places->first = begin > low ? begin : low;
    places->end = behind < high ? behind : high;
    if (places->first < places->end) {
        const int32_t centre = fxl_centre_of(places->first) - from;
        const int32_t steps = rise < 0 ? (centre >> 16) + 1 : 0;
        const int64_t sum = fxl_multiply_s32(across & 0xFFFF, length) +
                            fxl_multiply_s32(centre, rise) +
                            fxl_multiply_s32(steps, length) * 65536;
        uint32_t left;
        const uint32_t pixel = fxl_divide_u64((uint64_t)sum >> 16, (uint32_t)length, &left);
        places->across = (across >> 16) - steps + (int32_t)pixel;
        places->change = rise < 0 ? -1 : 1;
        places->pixel = (uint32_t)length;
        places->left = rise < 0 ? (uint32_t)length - 1 - left : left;
        places->step = (uint32_t)(rise < 0 ? -rise : rise);
        places->upright = upright;
    }
    return begin;
}

/* lines 2.2 */
static void paint_line(const painting *of)
{
    const fxl_painted_line *line = of->line;
    fxl_line_places places;
    fxl_line_depth depth;
    const int32_t begin = find_places(of, &places);
    if (places.first >= places.end) {
        return;
    }
    if (of->canvas->head == NULL) {
        paint_plain(of, &places);
        return;
    }
    if (line->plane_count == 0) {
        int64_t ends[2];
        fxl_line_find_ends(of->canvas, line, ends, &depth);
        fxl_line_find_depth(line, &places, begin, ends, &depth);
    } else {
        depth.at = depth.step = 0;
    }
    for (int32_t i = line->width - 1; i > 0; i--) { /* in any sequence */
        fxl_line_places other = places;
        fxl_line_depth other_depth = depth;
        other.across += i;
        paint_row(of, &other, &other_depth);
    }
    paint_row(of, &places, &depth);
}

/* place pixel-format: the bytes of a pixel of lines */
void fxl_line_canvas_begin(fxl_line_canvas *canvas, const fxl_band *band,
                           const fxl_depth_head *head, fxl_q16_16 near_z, bool wide)
{
    const bool is_colour = fxl_kind_of_band(band).is_colour;
    canvas->band = band;
    canvas->head = head;
    canvas->near_z = near_z;
    canvas->distance = 0;
    canvas->mantissa = 0;
    canvas->one = 0;
    canvas->box.first_column = band->first_column;
    canvas->box.end_column = (int32_t)fxl_band_end_column(band);
    canvas->box.first_row = band->first_row;
    canvas->box.end_row = band->first_row + band->rows;
    canvas->format =
        (wide ? (uint32_t)FXL_LINE_WIDE : 0u) | (is_colour ? (uint32_t)FXL_LINE_COLOURS : 0u);
    canvas->cell = 2;
    if (wide) {
        canvas->cell = 4;
    }
    canvas->pixel = 1;
    if (is_colour) {
        canvas->pixel = 2;
    }
    canvas->cell_row = (int32_t)(canvas->cell * band->width);
    canvas->pixel_row = (int32_t)(canvas->pixel * band->stride);
}

void fxl_paint_wide_line(fxl_line_canvas *canvas, const fxl_painted_line *line)
{
    const painting of = {canvas, line};
    if (!line->is_point) {
        paint_line(&of);
    } else if (canvas->head != NULL && line->plane_count == 0) {
        fxl_line_depth depth;
        int64_t ends[2];
        fxl_line_find_ends(canvas, line, ends, &depth);
        paint_point(&of, fxl_line_code_of_depth(canvas->head->scale, &depth));
    } else {
        paint_point(&of, 0);
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

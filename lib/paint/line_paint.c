/* SPDX-License-Identifier: MIT */
#include "line_paint.h"

#include "line_depth.h"

/* --- pixels --------------------------------------------------------------------------------- */

/* Pixels: first <= column < end, and so rows. */
typedef struct {
    int32_t first_column, end_column, first_row, end_row;
} pixel_box;

/* Where pixels are painted, and by what. */
typedef struct {
    fxl_line_canvas *canvas;
    const fxl_painted_line *line;
    pixel_box band;
} painting;

/* A line from place to place: the pixel across is exact, as is fxl_line_pixels, whose parts are
 * multiples of 2^16 but for the last 16 bits of what is left. These stay as they are and decide no
 * comparison: they are left out. Where the line falls, what is left is that to the pixel's other
 * edge, so that it never becomes negative. */
typedef struct {
    int32_t first, end;         /* places along */
    int32_t across;             /* at the first one */
    int32_t change;             /* of the pixel across, where it changes: -1 or 1 */
    uint32_t left, pixel, step; /* left < pixel < 2^30, step <= pixel */
    bool upright;
} line_places;

#define INLINED static inline __attribute__((always_inline))

/* To the next place. Returns whether the pixel across changes. */
INLINED bool step_place(line_places *places)
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

/* What pixels with a depth are painted into, and with: copied, so that a pixel that is written may be
 * none of it. */
typedef struct {
    void *cells;
    fxl_band band;
    fxl_depth_rule rule;
    uint8_t colour;
} depth_canvas;

INLINED depth_canvas depth_canvas_of(const painting *of)
{
    const fxl_line_canvas *canvas = of->canvas;
    const depth_canvas made = {(void *)(uintptr_t)(canvas->head + 1),
                               *canvas->band,
                               {canvas->wide, true},
                               of->line->colour};
    return made;
}

/* A pixel of the band. */
/* lines 3.1 */
INLINED void paint_cell(const depth_canvas *to, int32_t x, int32_t y, uint32_t code)
{
    const uint32_t row = (uint32_t)(y - to->band.first_row);
    const int32_t cell = (int32_t)(row * to->band.width) + x;
    if (fxl_depth_passes(to->cells, cell, code, to->rule)) {
        fxl_depth_keep(to->cells, cell, code, to->rule.wide);
        fxl_set_pixel(&to->band, (size_t)row * to->band.stride + (size_t)x, to->colour);
    }
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
    const depth_canvas to = depth_canvas_of(of);
    paint_cell(&to, x, y, code);
}

/* Those pixels of a box that the band has. */
static void paint_box(const painting *of, const pixel_box *box, uint32_t code)
{
    const pixel_box *band = &of->band;
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
    const pixel_box box = {left, left + line->width, top, top + line->width};
    paint_box(of, &box, code);
}

/* Without a depth buffer: a column or a row after the other. */
/* lines 2.2 */
static void paint_plain(const painting *of, line_places *places)
{
    const int32_t width = of->line->width;
    while (places->first < places->end) {
        const int32_t along = places->first, across = places->across;
        const pixel_box row = {across, across + width, along, along + 1};
        const pixel_box column = {along, along + 1, across, across + width};
        paint_box(of, places->upright ? &row : &column, 0);
        (void)step_place(places);
    }
}

/* --- a pixel a place, with a depth buffer ---------------------------------------------------- */

/* The pixels across that the band has: begin <= across < begin + size. */
typedef struct {
    int32_t begin;
    uint32_t size;
} band_side;

INLINED band_side side_of(const painting *of, bool upright)
{
    const pixel_box *band = &of->band;
    const int32_t begin = upright ? band->first_column : band->first_row;
    const band_side side = {begin,
                            (uint32_t)((upright ? band->end_column : band->end_row) - begin)};
    return side;
}

INLINED bool is_within(band_side side, const line_places *places)
{
    return (uint32_t)(places->across - side.begin) < side.size;
}

/* With the line's own depth, which is at the first place. */
/* lines 3.3 */
static void paint_with_depth(const painting *of, line_places *places, fxl_line_depth *depth)
{
    const band_side side = side_of(of, places->upright);
    const depth_canvas to = depth_canvas_of(of);
    const fxl_depth_scale scale = of->canvas->head->scale;
    for (;;) {
        if (is_within(side, places)) {
            paint_cell(&to, places->upright ? places->across : places->first,
                       places->upright ? places->first : places->across,
                       fxl_line_code_of_depth(scale, depth));
        }
        (void)step_place(places);
        if (places->first >= places->end) {
            return;
        }
        depth->at += depth->step;
    }
}

/* A face at a pixel of the band. */
typedef struct {
    fxl_line_plane *face;
    int64_t depth, row;    /* in column 0 of its row, and what the next row of the line adds */
    uint64_t value;        /* worded, at the pixel */
    uint64_t along, sheer; /* what a place along adds to it, and one across */
    uint32_t code;
} face_walk;

/* lines 3.2 */
INLINED void find_code(face_walk *walk, fxl_depth_scale scale, int32_t x)
{
    walk->code = fxl_line_holds(walk->face, fxl_line_word_of(walk->value))
                     ? fxl_line_code_in_octave(&walk->face->octave, walk->depth, x)
                     : fxl_line_code_in_other(scale, walk->face, walk->depth, walk->value, x);
}

INLINED void begin_walk(const line_places *places, bool upright, fxl_depth_scale scale,
                        face_walk *walk)
{
    const fxl_gradient *gradient = &walk->face->plane.gradient;
    const bool falls = places->change < 0;
    const int32_t x = upright ? places->across : places->first;
    const int32_t y = upright ? places->first : places->across;
    const int64_t down = !upright && falls ? -gradient->down : gradient->down;
    const int64_t along = upright && falls ? -gradient->along : gradient->along;
    walk->depth = gradient->at + fxl_multiply_s64_u16(gradient->down, (uint32_t)y);
    walk->value = fxl_line_worded(walk->face,
                                  walk->depth + fxl_multiply_s64_u16(gradient->along, (uint32_t)x));
    walk->row = down;
    walk->along = fxl_line_worded(walk->face, upright ? down : along);
    walk->sheer = fxl_line_worded(walk->face, upright ? along : down);
    find_code(walk, scale, x);
}

/* To the next place. changes: and to the next pixel across. */
INLINED void step_walk(const line_places *places, bool upright, bool changes, fxl_depth_scale scale,
                       face_walk *walk)
{
    walk->value += walk->along;
    if (changes) {
        walk->value += walk->sheer;
    }
    if (upright || changes) {
        walk->depth += walk->row;
        find_code(walk, scale, upright ? places->across : places->first);
    } else if (fxl_line_holds(walk->face, fxl_line_word_of(walk->value))) {
        walk->code += walk->face->octave.step;
    } else {
        walk->code =
            fxl_line_code_in_other(scale, walk->face, walk->depth, walk->value, places->first);
    }
}

/* upright, count: of faces; constant where this function is called. The places whose pixel the band
 * has come one after the other. */
INLINED void paint_on(const painting *of, line_places *places, bool upright, uint32_t count)
{
    const fxl_depth_scale scale = of->canvas->head->scale;
    const band_side side = side_of(of, upright);
    const depth_canvas to = depth_canvas_of(of);
    face_walk walks[2];
    while (!is_within(side, places)) {
        (void)step_place(places);
        if (places->first >= places->end) {
            return;
        }
    }
    for (uint32_t i = 0; i < count; i++) {
        walks[i].face = of->line->planes[i];
        begin_walk(places, upright, scale, &walks[i]);
    }
    for (;;) {
        const bool is_first = count == 1 || walks[0].code > walks[1].code;
        paint_cell(&to, upright ? places->across : places->first,
                   upright ? places->first : places->across, walks[is_first ? 0 : 1].code);
        const bool changes = step_place(places);
        if (places->first >= places->end || (changes && !is_within(side, places))) {
            return;
        }
        for (uint32_t i = 0; i < count; i++) {
            step_walk(places, upright, changes, scale, &walks[i]);
        }
    }
}

static void paint_on_faces(const painting *of, line_places *places)
{
    if (of->line->plane_count == 1) {
        if (places->upright) {
            paint_on(of, places, true, 1);
        } else {
            paint_on(of, places, false, 1);
        }
    } else if (places->upright) {
        paint_on(of, places, true, 2);
    } else {
        paint_on(of, places, false, 2);
    }
}

/* To the first place that is a column of the band, which places then end with. False: there is none. */
static bool enter_columns(const pixel_box *band, line_places *places, fxl_line_depth *depth)
{
    places->end = places->end < band->end_column ? places->end : band->end_column;
    while (places->first < places->end && places->first < band->first_column) {
        depth->at += depth->step;
        (void)step_place(places);
    }
    return places->first < places->end;
}

/* lines 2.2 */
static void paint_line(const painting *of)
{
    const fxl_painted_line *line = of->line;
    const fxl_screen_point *a = &line->ends[0], *b = &line->ends[1];
    const int32_t width = b->x - a->x, height = b->y - a->y; /* below 2^30 */
    const bool upright = (height < 0 ? -height : height) > (width < 0 ? -width : width);
    fxl_screen_point moved[2] = {*a, *b};
    fxl_line_pixels pixels;
    fxl_line_depth depth;
    depth.at = depth.step = 0;
    for (uint32_t i = 0; i < 2; i++) {
        fxl_q16_16 *across = upright ? &moved[i].x : &moved[i].y;
        *across = first_of(*across, line->width);
    }
    const fxl_line_extent extent =
        fxl_find_line_pixels(&moved[0], &moved[1], of->canvas->band, &pixels);
    if (extent.first >= extent.end) {
        return;
    }
    line_places places;
    const int32_t left = (int32_t)(pixels.left >> 16), step = (int32_t)(pixels.step >> 16);
    places.first = extent.first;
    places.end = extent.end;
    places.across = pixels.across;
    places.change = step < 0 ? -1 : 1;
    places.pixel = (uint32_t)(pixels.pixel >> 16);
    places.left = step < 0 ? places.pixel - 1 - (uint32_t)left : (uint32_t)left;
    places.step = (uint32_t)(step < 0 ? -step : step);
    places.upright = upright;
    if (of->canvas->head == NULL) {
        paint_plain(of, &places);
        return;
    }
    if (line->plane_count == 0) {
        int64_t ends[2];
        fxl_line_find_ends(of->canvas, line, ends, &depth);
        fxl_line_find_depth(line, &extent, upright, ends, &depth);
    }
    if (!upright && !enter_columns(&of->band, &places, &depth)) {
        return;
    }
    const line_places first = places;
    const int64_t at = depth.at;
    for (int32_t i = 0;;) {
        if (line->plane_count == 0) {
            paint_with_depth(of, &places, &depth);
        } else {
            paint_on_faces(of, &places);
        }
        if (++i >= line->width) {
            return;
        }
        places = first;
        places.across += i;
        depth.at = at;
    }
}

void fxl_paint_wide_line(fxl_line_canvas *canvas, const fxl_painted_line *line)
{
    const fxl_band *band = canvas->band;
    const painting of = {canvas,
                         line,
                         {band->first_column, (int32_t)fxl_band_end_column(band), band->first_row,
                          band->first_row + band->rows}};
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

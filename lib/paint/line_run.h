/* SPDX-License-Identifier: MIT */
/* The pixels of a line one after the other, over cells of a depth buffer. Those of a line on faces are
 * painted by stretches in which the codes of each face are of one octave, so that a pixel takes
 * additions alone. A part of line_paint.c. */
#ifndef FXL_LINE_RUN_H
#define FXL_LINE_RUN_H

#include "line_depth.h"

/* A line from place to place along its major axis: the pixel across is exact, as is fxl_line_pixels,
 * whose parts are multiples of 2^16 but for the last 16 bits of what is left. These stay as they are
 * and decide no comparison: they are left out. Where the line falls, what is left is that to the
 * pixel's other edge, so that it never becomes negative. */
typedef struct {
    const fxl_line_axes *axes;
    int32_t first, count;  /* places, from the first one on */
    int32_t across;        /* the pixel at the first one */
    int32_t behind;        /* what is left of the pixel across, less its size: below 0 */
    int32_t step, size;    /* step <= size < 2^30 */
    uint8_t *cell, *pixel; /* of the first place */
    uintptr_t apart;       /* FXL_LINE_NARROW: that of the canvas, and no pixel */
    uint32_t colour;       /* as it is written */
} fxl_line_way;

/* The code of a face from place to place: the upper word. */
typedef struct {
    uint64_t code, along, sheer; /* what a place along adds, and one across */
    uint32_t added, shift;       /* as in fxl_line_plane */
} fxl_line_codes;

/* The codes of a face from the first place on, in its octave. */
/* lines 3.2 */
FXL_INLINED fxl_line_codes fxl_line_codes_of(const fxl_line_plane *face, const fxl_line_way *way)
{
    const uint32_t upright = way->axes->upright;
    const uint64_t along = face->steps[upright], across = face->steps[1u - upright];
    fxl_line_codes codes;
    codes.code = face->start + along * (uint32_t)way->first + across * (uint32_t)way->across;
    codes.along = along;
    codes.sheer = way->axes->change < 0 ? 0u - across : across;
    codes.added = face->added;
    codes.shift = face->shift;
    return codes;
}

/* Whether all pixels of a line are in one octave for certain, which the face then has. */
FXL_INLINED bool fxl_line_is_held(fxl_depth_scale scale, fxl_line_plane *face,
                                  const fxl_line_ends *ends, uint32_t upright)
{
    const int32_t along = face->words[upright], across = face->words[1u - upright];
    const int64_t first =
        face->at + fxl_multiply_s32(along, ends->from) + fxl_multiply_s32(across, ends->side);
    const int64_t last =
        first + fxl_multiply_s32(along, ends->length) + fxl_multiply_s32(across, ends->rise);
    const uint32_t word = fxl_line_word_of(fxl_bits_64(first));
    const uint32_t other = fxl_line_word_of(fxl_bits_64(last));
    return fxl_line_has_words(face, word, other) || fxl_line_find_octave(scale, face, word, other);
}

/* place pixel-format: how a pixel of lines is written */
/* format: of the canvas; constant where this function and those below are called. */
/* lines 3.1 */
FXL_INLINED void fxl_line_paint_place(uint8_t *cell, uint8_t *pixel, uint32_t colour, uint32_t code,
                                      uint32_t format)
{
    const fxl_depth_rule rule = {(format & FXL_LINE_WIDE) != 0, true};
    const bool is_colour = (format & FXL_LINE_COLOURS) != 0;
    if (fxl_depth_passes(cell, 0, code, rule)) {
        fxl_depth_keep(cell, 0, code, rule.wide);
        if (is_colour) {
            *(uint16_t *)(void *)pixel = (uint16_t)colour;
        } else {
            *pixel = (uint8_t)colour;
        }
    }
}

/* What is left of the pixel across at the next place. Returns whether that changes. */
FXL_INLINED bool fxl_line_step_behind(fxl_line_way *run)
{
    run->behind += run->step;
    if (run->behind < 0) {
        return false;
    }
    run->behind -= run->size;
    return true;
}

/* To the next place; axes: those of the line, format: constant. Returns whether the pixel across changes. */
FXL_INLINED bool fxl_line_step(fxl_line_way *run, const fxl_line_axes *axes, uint32_t format)
{
    run->cell += axes->cell_along;
    if (format != FXL_LINE_NARROW) {
        run->pixel += axes->pixel_along;
    }
    if (!fxl_line_step_behind(run)) {
        return false;
    }
    run->cell += axes->cell_across;
    if (format != FXL_LINE_NARROW) {
        run->pixel += axes->pixel_across;
    }
    return true;
}

/* Cells of 16 bits are twice as far apart as their pixels of 8. */
FXL_INLINED uint8_t *fxl_line_pixel_of(const fxl_line_way *run, uint32_t format)
{
    return format == FXL_LINE_NARROW ? (uint8_t *)(run->apart + ((uintptr_t)run->cell >> 1))
                                     : run->pixel;
}

FXL_INLINED uint32_t fxl_line_code_of(uint64_t code, const fxl_line_codes *codes, bool shifts)
{
    const uint32_t word = fxl_line_word_of(code);
    return shifts ? codes->added + (word >> codes->shift) : word;
}

/* `count` places from the first one on, from 1 on, in the octaves of the faces. count_of_faces, shifts,
 * format: constant where this function is called. What is painted may be none of the records, so these
 * are copied. */
/* lines 3.2 */
FXL_INLINED void fxl_line_paint_stretch(const fxl_line_way *way, fxl_line_plane *const *faces,
                                        int32_t count, uint32_t count_of_faces, bool shifts,
                                        uint32_t format)
{
    fxl_line_way run = *way;
    const fxl_line_axes axes = *way->axes;
    const fxl_line_codes first = fxl_line_codes_of(faces[0], way);
    const fxl_line_codes second = fxl_line_codes_of(faces[count_of_faces - 1], way);
    uint64_t one = first.code, other = second.code;
    for (;;) {
        uint32_t code = fxl_line_code_of(one, &first, shifts);
        if (count_of_faces > 1) {
            const uint32_t behind = fxl_line_code_of(other, &second, shifts);
            code = code > behind ? code : behind;
        }
        fxl_line_paint_place(run.cell, fxl_line_pixel_of(&run, format), run.colour, code, format);
        if (--count == 0) {
            return;
        }
        one += first.along;
        other += count_of_faces > 1 ? second.along : 0;
        if (fxl_line_step(&run, &axes, format)) {
            one += first.sheer;
            other += count_of_faces > 1 ? second.sheer : 0;
        }
    }
}

/* On one face, and on two: most lines. */
static __attribute__((noinline)) void
fxl_line_paint_one(const fxl_line_way *way, fxl_line_plane *const *faces, int32_t count)
{
    fxl_line_paint_stretch(way, faces, count, 1, false, FXL_LINE_NARROW);
}

static __attribute__((noinline)) void
fxl_line_paint_two(const fxl_line_way *way, fxl_line_plane *const *faces, int32_t count)
{
    fxl_line_paint_stretch(way, faces, count, 2, false, FXL_LINE_NARROW);
}

static __attribute__((noinline)) void fxl_line_paint_any(const fxl_line_way *way,
                                                         fxl_line_plane *const *faces,
                                                         int32_t count, uint32_t count_of_faces,
                                                         uint32_t format)
{
    if (count_of_faces == 1) {
        fxl_line_paint_stretch(way, faces, count, 1, true, format);
    } else {
        fxl_line_paint_stretch(way, faces, count, 2, true, format);
    }
}

/* `count` places from the first one on. format: of the canvas. */
FXL_INLINED void fxl_line_paint_faces(uint32_t format, const fxl_painted_line *line,
                                      const fxl_line_way *way, int32_t count)
{
    fxl_line_plane *const *faces = line->planes;
    const uint32_t shifts = format | faces[0]->shift;
    if (line->plane_count == 1 && shifts == 0) {
        fxl_line_paint_one(way, faces, count);
    } else if (line->plane_count == 2 && (shifts | faces[1]->shift) == 0) {
        fxl_line_paint_two(way, faces, count);
    } else {
        fxl_line_paint_any(way, faces, count, line->plane_count, format);
    }
}

/* The octave of a face at the first place. Returns how many places, `most` at most, it holds. *changes:
 * how often the pixel across changes up to the next one. */
static int32_t fxl_line_find_stretch(fxl_depth_scale scale, fxl_line_plane *face,
                                     const fxl_line_way *way, int32_t most, int32_t *changes)
{
    const fxl_line_axes *axes = way->axes;
    const bool upright = axes->upright != 0;
    uint64_t value = upright ? fxl_line_value_of(face, way->across, way->first)
                             : fxl_line_value_of(face, way->first, way->across);
    if (!fxl_line_holds(face, fxl_line_word_of(value))) {
        fxl_line_find_other(scale, face, value);
    }
    const uint64_t right = fxl_bits_64(face->plane.gradient.along);
    const uint64_t down = fxl_bits_64(face->plane.gradient.down);
    const uint64_t along = upright ? down : right, across = upright ? right : down;
    const uint64_t sheer = axes->change < 0 ? 0u - across : across;
    const uint32_t first = face->first, span = face->span;
    const int32_t step = way->step, size = way->size;
    int32_t behind = way->behind, left = most, changed = 0;
    do {
        value += along;
        behind += step;
        if (behind >= 0) {
            behind -= size;
            value += sheer;
            changed++;
        }
        left--;
    } while (fxl_line_word_of(value) - first < span && left > 0);
    *changes = changed;
    return most - left;
}

/* A line with its own depth, which is at the first place. format: constant where this function is
 * called. */
/* lines 3.3 */
FXL_INLINED void fxl_line_paint_own(const fxl_line_way *way, fxl_depth_scale scale,
                                    const fxl_line_depth *depth, uint32_t format)
{
    fxl_line_way run = *way;
    const fxl_line_axes axes = *way->axes;
    fxl_line_depth own = *depth;
    for (;;) {
        const uint32_t code = (format & FXL_LINE_WIDE) != 0
                                  ? fxl_line_code_of_depth(scale, &own)
                                  : fxl_line_cell_of_depth(scale, &own) << 16;
        fxl_line_paint_place(run.cell, fxl_line_pixel_of(&run, format), run.colour, code, format);
        if (--run.count == 0) {
            return;
        }
        (void)fxl_line_step(&run, &axes, format);
        own.at += own.step;
    }
}

#endif

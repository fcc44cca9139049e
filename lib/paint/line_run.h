/* SPDX-License-Identifier: MIT */
/* The pixels of a line one after the other, over cells of a depth buffer. Those of a line on faces are
 * painted by stretches in which the codes of each face are of one octave, so that a pixel takes
 * additions alone. A part of line_paint.c. */
#ifndef FXL_LINE_RUN_H
#define FXL_LINE_RUN_H

#include "line_depth.h"

/* The cell and the pixel of a place, and how far it is to those of the next place along, and across:
 * in bytes. */
typedef struct {
    uint8_t *cell, *pixel;
    int32_t cell_along, pixel_along, cell_across, pixel_across;
    uint32_t colour; /* as it is written */
    uint32_t count;  /* places that are left, from 1 on */
    uint32_t room;   /* how often the pixel across may change before it leaves the band */
    int32_t behind, step, size; /* what is left of the pixel across, less its size: below 0 */
} fxl_line_way;

/* The code of a face from place to place: the upper word. */
typedef struct {
    uint64_t code, along, sheer; /* what a place along adds, and one across */
    uint32_t added, shift;       /* as in fxl_line_plane */
} fxl_line_codes;

/* How many places have depths of the octave that the first one has for certain, from 1 to count;
 * word: of the first one. The pixel across is at place i between i rate / 4096 - 1 and 1.4 more than
 * that: 1/16 for what the rate leaves of 4096 parts of a pixel, 1/4 for its own rounding, and 1 for
 * that of the pixel. So a depth is no farther than two places across from that of a line from place to
 * place, of which a place has 3 words more, for what words leave of three numbers. */
static inline uint32_t fxl_line_places_held(const fxl_line_plane *face, uint32_t word,
                                            int32_t along, int32_t sheer, uint32_t rate,
                                            uint32_t count)
{
    const uint32_t before = word - face->first, behind = face->span - 1u - before; /* words */
    const uint32_t reach = sheer < 0 ? 0u - fxl_bits_32(sheer) : fxl_bits_32(sheer);
    const uint32_t margin = 2u * reach + 4u;
    if ((reach | (along < 0 ? 0u - fxl_bits_32(along) : fxl_bits_32(along))) >> 28 != 0 ||
        before < margin || behind < margin) {
        return 1;
    }
    const int32_t change = along + (int32_t)(fxl_multiply_s32(sheer, (int32_t)rate) >> 12);
    const uint32_t room = (change < 0 ? before : behind) - margin;
    const uint32_t least = fxl_bits_32(change < 0 ? -change : change) + 3u; /* below 2^30 */
    if (room >= fxl_multiply_u32(least, count)) {
        return count;
    }
    uint32_t rest;
    return fxl_divide_u32(room, least, &rest) + 1u;
}

/* The same, all of them; value: worded, of the first one. */
static __attribute__((noinline)) uint32_t fxl_line_places_walked(const fxl_line_plane *face,
                                                                 uint64_t value,
                                                                 const fxl_line_places *places,
                                                                 uint32_t count)
{
    const fxl_gradient *gradient = &face->plane.gradient;
    const uint64_t right = fxl_line_worded(face, gradient->along);
    const uint64_t down = fxl_line_worded(face, gradient->down);
    const uint64_t across = places->upright ? right : down;
    const uint64_t along = places->upright ? down : right;
    const uint64_t sheer = places->change < 0 ? 0u - across : across;
    const uint32_t first = face->first, span = face->span;
    const uint32_t pixel = places->pixel, step = places->step;
    uint32_t held = 0, left = places->left;
    do {
        value += along;
        left += step;
        if (left >= pixel) {
            left -= pixel;
            value += sheer;
        }
    } while (++held < count && fxl_line_word_of(value) - first < span);
    return held;
}

/* The codes of a face from the first place on. Returns how many places have them, from 1 to count. */
/* lines 3.2 */
FXL_INLINED uint32_t fxl_line_codes_begin(fxl_depth_scale scale, fxl_line_plane *face,
                                          const fxl_line_places *places, uint32_t rate,
                                          uint32_t count, fxl_line_codes *codes)
{
    const fxl_gradient *gradient = &face->plane.gradient;
    const bool upright = places->upright, falls = places->change < 0;
    const int32_t x = upright ? places->across : places->first;
    const int32_t y = upright ? places->first : places->across;
    const int64_t depth = gradient->at + fxl_multiply_s64_u16(gradient->down, (uint32_t)y);
    const uint64_t value =
        fxl_line_worded(face, depth + fxl_multiply_s64_u16(gradient->along, (uint32_t)x));
    const uint32_t word = fxl_line_word_of(value);
    if (!fxl_line_holds(face, word)) {
        const uint32_t code = fxl_line_code_in_other(scale, face, depth, value, x);
        if (!fxl_line_holds(face, word)) {
            codes->along = codes->sheer = codes->added = codes->shift = 0;
            codes->code = (uint64_t)code << 32;
            return 1;
        }
    }
    const uint64_t step = (uint64_t)(face->octave.step << face->shift) << 32;
    const uint64_t across = upright ? step : face->row;
    codes->code = face->start + face->row * (uint32_t)y + step * (uint32_t)x;
    codes->along = upright ? face->row : step;
    codes->sheer = falls ? 0u - across : across;
    codes->added = face->added;
    codes->shift = face->shift;
    const int32_t along = upright ? face->down : face->right;
    const int32_t right = upright ? face->right : face->down;
    const int32_t sheer = falls ? (int32_t)(0u - fxl_bits_32(right)) : right;
    return fxl_line_places_held(face, word, along, sheer, rate, count) < count
               ? fxl_line_places_walked(face, value, places, count)
               : count;
}

/* place pixel-format: how a pixel of lines is written */
/* format: of the canvas; constant where this function and those below are called. */
/* lines 3.1 */
FXL_INLINED void fxl_line_paint_place(const fxl_line_way *run, uint32_t code, uint32_t format)
{
    const fxl_depth_rule rule = {(format & FXL_LINE_WIDE) != 0, true};
    const bool is_colour = (format & FXL_LINE_COLOURS) != 0;
    if (fxl_depth_passes(run->cell, 0, code, rule)) {
        fxl_depth_keep(run->cell, 0, code, rule.wide);
        if (is_colour) {
            *(uint16_t *)(void *)run->pixel = (uint16_t)run->colour;
        } else {
            *run->pixel = (uint8_t)run->colour;
        }
    }
}

/* To the next place. Returns whether the pixel across changes. */
FXL_INLINED bool fxl_line_step(fxl_line_way *run)
{
    run->cell += run->cell_along;
    run->pixel += run->pixel_along;
    run->behind += run->step;
    return run->behind >= 0;
}

/* To the next pixel across. False: it is none of the band. */
FXL_INLINED bool fxl_line_step_across(fxl_line_way *run)
{
    if (run->room == 0) {
        run->count = 0;
        return false;
    }
    run->room--;
    run->behind -= run->size;
    run->cell += run->cell_across;
    run->pixel += run->pixel_across;
    return true;
}

FXL_INLINED uint32_t fxl_line_code_of(uint64_t code, const fxl_line_codes *codes, bool shifts)
{
    const uint32_t word = (uint32_t)(code >> 32);
    return shifts ? codes->added + (word >> codes->shift) : word;
}

/* The next `places` places of a run, which it then has behind it. faces: how many; faces, shifts,
 * format: constant where this function is called. */
/* lines 3.2 */
FXL_INLINED void fxl_line_paint_stretch(fxl_line_way *of, const fxl_line_codes codes[2],
                                        uint32_t places, uint32_t faces, bool shifts,
                                        uint32_t format)
{
    fxl_line_way run = *of; /* copied, so that a pixel that is written may be none of it */
    uint64_t one = codes[0].code, other = faces > 1 ? codes[1].code : 0;
    bool goes_on = true;
    run.count -= places;
    while (goes_on) {
        uint32_t code = fxl_line_code_of(one, &codes[0], shifts);
        if (faces > 1) {
            const uint32_t second = fxl_line_code_of(other, &codes[1], shifts);
            code = code > second ? code : second;
        }
        fxl_line_paint_place(&run, code, format);
        places--;
        goes_on = places != 0 || run.count != 0;
        if (goes_on) {
            one += codes[0].along;
            other += faces > 1 ? codes[1].along : 0;
            if (fxl_line_step(&run)) {
                goes_on = fxl_line_step_across(&run);
                one += codes[0].sheer;
                other += faces > 1 ? codes[1].sheer : 0;
            }
            goes_on = goes_on && places != 0;
        }
    }
    *of = run;
}

/* A run with the line's own depth, which is at the first place. format: constant where this function
 * is called. */
/* lines 3.3 */
FXL_INLINED void fxl_line_paint_own(const fxl_line_way *of, fxl_depth_scale scale,
                                    fxl_line_depth *depth, uint32_t format)
{
    fxl_line_way run = *of;
    for (;;) {
        fxl_line_paint_place(&run, fxl_line_code_of_depth(scale, depth), format);
        if (--run.count == 0 || (fxl_line_step(&run) && !fxl_line_step_across(&run))) {
            return;
        }
        depth->at += depth->step;
    }
}

#endif

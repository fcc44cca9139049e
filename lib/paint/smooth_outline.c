/* SPDX-License-Identifier: MIT */
/* The text in C of outlines of one colour whose light is linear: of codes and light in words, near to
 * far. Where it may not be linear over all of a row, it is over pieces of the row. */
#include "smooth_outline.h"

#include "../math/family.h"
#include "outline_rows.h"
#include "rgb565_colour.h"

#if !FXL_DRAWS_SMOOTH_OUTLINES && !FXL_IS_COMPACT /* a host has it for tests and proofs alone */

/* place light: RGB565: the part of a colour that light leaves of a lit triangle in words */
/* place pixel-format: the pixels of lit triangles in words */
/* What the pixels of an outline depend on. Light is that of fxl_smooth_outline. */
typedef struct {
    fxl_smooth_words words;
    uint32_t border; /* fxl_depth_border */
    uint32_t end;    /* light from here on is not of the ramp */
    uint32_t limit;  /* the same; 0: codes have a border */
    /* Pixels of 8 bits: the entry of the face's colour in level 0. Of 16: null, and what follows. */
    const uint8_t *ramp;
    uint32_t part_of_level;
    fxl_mixture_565 mixture;
} outline;

/* Code and light of some pixels of a row, and their changes. */
typedef struct {
    uint32_t code, along, light, light_along;
} line;

/* Pixels of a row whose codes have one octave, and whose light is of the ramp. */
static inline void paint_near(const outline *of, line at, uint16_t *cell, uint8_t *pixel,
                              uint32_t count)
{
    const uint16_t *end = cell + count;
    const uint8_t *ramp = of->ramp;
    if (ramp != NULL) {
        for (; cell != end; cell++, pixel++, at.code += at.along, at.light += at.light_along) {
            if (fxl_keep_nearer(cell, at.code)) {
                *pixel = ramp[at.light >> 24 << 8];
            }
        }
        return;
    }
    const fxl_mixture_565 mixture = of->mixture;
    const uint32_t part_of_level = of->part_of_level;
    const uintptr_t beyond = (uintptr_t)pixel - (uintptr_t)cell;
    for (; cell != end; cell++, at.code += at.along, at.light += at.light_along) {
        if (fxl_keep_nearer(cell, at.code)) {
            *(uint16_t *)((uintptr_t)cell + beyond) =
                fxl_mixed_565(&mixture, 0, fxl_part_of_565(at.light, part_of_level));
        }
    }
}

/* Whether light is below the ramp, of it, or above. */
static inline int32_t place_of(const outline *of, uint32_t light)
{
    return fxl_signed_32(light) < 0 ? -1 : light >= of->end;
}

/* How many pixels from the first one on, of count, are on its side of the border, and their light on its
 * side of the ends of the ramp: all are where the last one is. At least 1. */
static uint32_t alike(const outline *of, const line *at, uint32_t count)
{
    for (;; count = (count + 1u) / 2u) {
        const uint32_t code = at->code + at->along * (count - 1u);
        const uint32_t light = at->light + at->light_along * (count - 1u);
        if ((code < of->border) == (at->code < of->border) &&
            place_of(of, light) == place_of(of, at->light)) {
            return count;
        }
    }
}

/* A piece of a row as paint_near takes it. */
static line piece_of(const outline *of, const line *at)
{
    line piece = *at;
    if (at->code < of->border) {
        piece.code = 2u * at->code - of->border;
        piece.along = 2u * at->along;
    }
    const int32_t place = place_of(of, at->light);
    if (place != 0) {
        piece.light = place < 0 ? 0 : of->end - 1u;
        piece.light_along = 0;
    }
    return piece;
}

/* fxl_outline_row_painter. */
static inline __attribute__((always_inline)) void paint_row(const void *with, uint32_t pixel_bytes,
                                                            fxl_outline_row row)
{
    const outline *of = (const outline *)with;
    const fxl_smooth_words *words = &of->words;
    line at = {
        words->code + words->code_down * row.y + words->code_along * row.x, words->code_along,
        words->light + words->light_down * row.y + words->light_along * row.x, words->light_along};
    for (;;) {
        line piece = at;
        uint32_t count = row.count;
        if (at.light >= of->limit || at.light + at.light_along * (count - 1u) >= of->limit) {
            count = alike(of, &at, count);
            piece = piece_of(of, &at);
        }
        paint_near(of, piece, row.cell, row.pixel, count);
        row.count -= count;
        if (row.count == 0) {
            return;
        }
        at.code += at.along * count;
        at.light += at.light_along * count;
        row.cell += count;
        row.pixel += count * pixel_bytes;
    }
}

void fxl_draw_smooth_words(const fxl_paint *paint, const fxl_depth_plane *depth, const void *memory,
                           uint32_t pixel_bytes, const fxl_band *band, fxl_scan *scan)
{
    const fxl_depth_head *head = (const fxl_depth_head *)memory;
    const uint32_t levels_less_1 = paint->levels_less_1;
    outline of;
    const fxl_gradient *light = &paint->gradients->attributes[0], *code = &depth->gradient;
    of.words.code = fxl_low_32(fxl_bits_64(code->at));
    of.words.code_along = fxl_low_32(fxl_bits_64(code->along));
    of.words.code_down = fxl_low_32(fxl_bits_64(code->down));
    of.words.light = fxl_low_32(fxl_bits_64(light->at));
    of.words.light_along = fxl_low_32(fxl_bits_64(light->along));
    of.words.light_down = fxl_low_32(fxl_bits_64(light->down));
    of.border = fxl_depth_border(head->scale, depth);
    of.end = (levels_less_1 + 1u) << 24;
    of.ramp = paint->ramp + paint->colour;
    of.part_of_level = 0;
    of.mixture.red_dark = of.mixture.red_step = 0;
    of.mixture.green_dark = of.mixture.green_step = 0;
    if (pixel_bytes != 1) {
        const uint32_t half = fxl_half_part_565(levels_less_1);
        of.words.light += half - (1u << 23);
        of.end = (levels_less_1 << 24) + half + 1u;
        of.ramp = NULL;
        of.part_of_level = paint->of_565.part_of_level;
        of.mixture = fxl_mixture_of_565(paint->of_565.palette[paint->colour], paint->of_565.dark);
    }
    of.limit = of.border != 0 ? 0 : of.end;
    fxl_paint_outline_rows(band, (uint16_t *)(uintptr_t)(head + 1), pixel_bytes, scan, paint_row,
                           &of, pixel_bytes);
}

#endif

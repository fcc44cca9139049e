/* SPDX-License-Identifier: MIT */
/* Opaque pixels of RGB565 whose channels are linear. A kernel of Armv7-M. Internal. */
#ifndef FXL_COLOUR_RUN_H
#define FXL_COLOUR_RUN_H

#include <stdint.h>

#include "fixel/types.h"

#include "../math/core.h"
#include "plain_rows.h"
#include "rgb565_colour.h"
#include "texel_place.h"
#include "texture_level.h"

#ifdef __cplusplus
extern "C" {
#endif

/* The first pixel, and what a pixel adds, in the order in which the kernel loads them. `both` has
 * blue in its upper half and red in its lower one, each with 11 bits after the point; green has 26.
 * A channel's level is what stands in the uppermost bits: red's is where a pixel has it. */
typedef struct {
    uint32_t both, green, step, green_step;
} fxl_colour_words;

/* Red and blue in 10.22, in one word: each loses 11 bits. */
static inline uint32_t fxl_colours_both(int32_t red, int32_t blue)
{
    return (fxl_bits_32(blue >> 11) << 16) + fxl_bits_32(red >> 11);
}

/* Writes count pixels. Sums are modulo 2^32; red and blue of all pixels are from 0 to below 32, or
 * the two mix. Requires count > 0. */
void fxl_paint_colour_run(const fxl_colour_words *words, uint16_t *pixels, uint32_t count);

/* Texels of a row, in segments of the same length: what the kernels below need, and keep from segment to
 * segment. The weight comes first, then u, v, light. Texels without light are shown, or added to what is
 * beneath. */
typedef struct fxl_lit_run fxl_lit_run;

/* Paints the pixels x0 <= x < x1 of a row, which begins at `pixels`, up to the first segment whose
 * light is no level at a pixel, or whose attributes take other shifts than most. Returns the column
 * from which on nothing is painted. A segment that ends at x0, or before it, has no pixels: so the
 * first one finds what the second one begins with. Pixels are those of paint_segment (paint_row.h).
 * Requires 0 <= x0 < x1, and log from 2 to 4. Safe for any other number: no texel is read that is
 * not of the table. */
typedef int32_t fxl_columns_kernel(fxl_lit_run *run, uint16_t *pixels, int32_t x0, int32_t x1);

fxl_columns_kernel fxl_paint_lit_columns, fxl_paint_unlit_columns;

struct fxl_lit_run {
    FXL_ALIGN_8 int64_t numbers[4]; /* of the row at column `begin` */
    int64_t steps[4];               /* what a segment adds */
    uint32_t from[3];               /* u, v, light at `begin` */
    int32_t lefts[3];               /* 30 - shift: an attribute's drop, and the weight's zeros */
    int32_t begin;                  /* where the next segment begins */
    uint32_t log;                   /* it has 2^log columns */
    uint32_t end_of_light;          /* least number above a level, in 16.16 */
    /* place sampling: the kernel's masks */
    uint32_t columns_mask, rows_mask, log_width; /* of a texture with at most 256 x 256 texels */
    const uint8_t *texels;
    const uint16_t *palette; /* null: texels of RGB565 */
    uint32_t part_of_level;
    fxl_mixture_565 mixture; /* of 0 and the dark colour */
    uint32_t least;          /* weight of segments of 16 columns */
    fxl_columns_kernel *paint;
    uint32_t lowest;     /* FXL_LOWEST_565 where texels are added; else 0 */
    uint32_t sixteenths; /* of a blend; 0: none */
};

/* Paints runs from runs->next on, in segments of 16 columns, whose steps run->steps has. Returns -1 if it has come to the
 * end. Otherwise the column from which on nothing is painted of the run before runs->next, whose row is
 * runs->row: its weights are too small, or run->paint has left it there. Requires pixels of less than 2^15 columns. */
int32_t fxl_paint_texel_list(fxl_lit_run *run, fxl_plain_runs *runs);

/* Whether texels repeat, and all of them are drawn. */
static inline bool fxl_has_whole_texels(const fxl_paint *paint)
{
    return paint->level.texels != NULL && paint->opacity == 16 && paint->level.colours == NULL &&
           (paint->level.flags & ~FXL_LEVEL_565) == 0;
}

/* Whether fxl_paint_texel_runs paints them: those of paint_repeated with light that is an attribute,
 * and those without light that are blended or added. */
static inline bool fxl_has_texel_runs(const fxl_paint *paint)
{
    const bool is_lit = paint->of_565.part_of_level != 0;
    return (fxl_is_mixed_565(paint) ? !is_lit : is_lit && !paint->is_evenly_lit) &&
           fxl_has_whole_texels(paint);
}

/* fxl_paint_pixels_565 of all runs of a face with such texels, which finds what they share once. */
void fxl_paint_texel_runs(const fxl_paint *paint, fxl_plain_runs *runs);

#ifdef __cplusplus
}
#endif

#endif

/* SPDX-License-Identifier: MIT */
/* A row of a band with a depth buffer: which of its pixels are visible. What paints those is given
 * by the caller, and is inlined. `bits` is constant where these functions are called: 16 or 32 a
 * cell. Internal. */
#ifndef FXL_DEPTH_ROW_H
#define FXL_DEPTH_ROW_H

#include "../math/family.h"
#include "depth_cells.h"
#include "depth_code.h"

#ifdef __cplusplus
extern "C" {
#endif

#define FXL_INLINED static inline __attribute__((always_inline))

/* Which polygons are painted. */
enum {
    FXL_DEPTH_ALL = 0,
    FXL_DEPTH_OPAQUE = 1,
    FXL_DEPTH_BLENDED = 2 /* those whose surface is FXL_SURFACE_BLEND or FXL_SURFACE_ADD */
};

/* The beginning of the target's memory; the cells follow. */
typedef struct {
    FXL_ALIGN_8 fxl_depth_scale scale;
    uint8_t pass; /* FXL_DEPTH_ALL and so on */
    bool or_equal;
    /* The rows of the screen, clear_from <= y < clear_to, whose cells are cleared or drawn: what
     * was kept there before the band began is gone. All rows of the band: FXL_DEPTH_ALL_CLEAR and
     * INT16_MAX. */
    int16_t clear_from, clear_to;
} fxl_depth_head;

#define FXL_DEPTH_ALL_CLEAR (-1) /* clear_from */

FXL_STATIC_ASSERT(sizeof(fxl_depth_head) == 8, "FXL_DEPTH_BYTES");

/* Of which visible pixels the depth is kept. */
enum {
    FXL_DEPTH_KEEPS_ALL = 0,
    FXL_DEPTH_KEEPS_NONE = 1,  /* of a blended one, so that what it covers can be seen through it */
    FXL_DEPTH_KEEPS_DRAWN = 2, /* of a surface that has holes */
    FXL_DEPTH_TESTED = 3 /* the same, and its painter tests each pixel itself: a run begins with
                          * a visible pixel, and others may be hidden. Where it has kernels */
};

/* A polygon that is painted. */
typedef struct {
    const fxl_depth_plane *plane;
    const fxl_depth_head *head;
    const fxl_band *band;
    uint8_t keeps;           /* FXL_DEPTH_KEEPS_ALL and so on */
    fxl_depth_octave octave; /* of the pixels painted last */
} fxl_depth_painting;

/* Paints the pixels x0 <= x < x1 of a row, which are visible; with: the painter's own. Where depths
 * are kept of drawn pixels alone, it keeps them in the cells; line: the codes from x0 on. */
typedef void fxl_run_painter(const void *with, int32_t x0, int32_t x1, void *cells,
                             fxl_depth_line line);

/* Pixels of one octave. cells: of column 0. */
FXL_INLINED void fxl_depth_paint_line(const fxl_depth_painting *of, void *cells, int32_t x0,
                                      int32_t x1, fxl_depth_line line, fxl_depth_rule rule,
                                      fxl_run_painter *paint, const void *with)
{
#if FXL_KERNELS_ARMV7M && !FXL_IS_COMPACT
    if (of->keeps == FXL_DEPTH_TESTED) {
        if (!fxl_depth_passes(cells, x0, line.code, rule)) {
            x0 = fxl_depth_hidden_end(cells, x0, x1, &line, rule);
        }
        if (x0 < x1) {
            paint(with, x0, x1, cells, line);
        }
        return;
    }
#endif
    while (x0 < x1) {
        const fxl_depth_line from = line;
        const int32_t end = of->keeps == FXL_DEPTH_KEEPS_ALL
                                ? fxl_depth_visible_end(cells, x0, x1, &line, true, rule)
                                : fxl_depth_visible_end(cells, x0, x1, &line, false, rule);
        if (x0 < end) {
            paint(with, x0, end, cells, from);
        }
        x0 = end < x1 ? fxl_depth_hidden_end(cells, end, x1, &line, rule) : x1;
    }
}

/* fxl_depth_octave_end of a plane in words, whose codes grow or fall along a row. Not inline: few
 * rows come here, and what it has would be on the stack of all. */
static __attribute__((noinline, unused)) int32_t
fxl_depth_words_end(fxl_depth_painting *of, uint32_t depth, int32_t x0, int32_t x1)
{
    const uint32_t along = fxl_low_32(fxl_bits_64(of->plane->gradient.along));
    int32_t inside = x0, outside = x1;
    fxl_depth_octave_of_word(of->head->scale, of->plane, depth + along * (uint32_t)x0, &of->octave);
    if (fxl_depth_octave_holds(&of->octave, depth + along * (uint32_t)(x1 - 1))) {
        return x1;
    }
    while (outside - inside > 1) {
        const int32_t middle = (inside + outside) / 2;
        if (fxl_depth_octave_holds(&of->octave, depth + along * (uint32_t)middle)) {
            inside = middle;
        } else {
            outside = middle;
        }
    }
    return outside;
}

/* Sets the octave of column x0, where the gradient in column 0 is `depth`. Returns how far it goes:
 * all of the columns x0 to the one before have it; x1 at most. It is found by halving, as depth is
 * linear along a row. */
static inline int32_t fxl_depth_octave_end(fxl_depth_painting *of, int64_t depth, int32_t x0,
                                           int32_t x1)
{
    const int64_t along = of->plane->gradient.along;
    const int64_t value = depth + fxl_multiply_s64_u16(along, (uint32_t)x0);
    if (!fxl_depth_octave_holds(&of->octave, value)) {
        fxl_depth_octave_of(of->head->scale, of->plane, value, &of->octave);
    }
    int32_t inside = x0, outside = x1;
    const int64_t last = depth + fxl_multiply_s64_u16(along, (uint32_t)(x1 - 1));
    if (fxl_depth_octave_holds(&of->octave, last)) {
        return x1;
    }
    while (outside - inside > 1) {
        const int32_t middle = (inside + outside) / 2;
        const int64_t between = depth + fxl_multiply_s64_u16(along, (uint32_t)middle);
        if (fxl_depth_octave_holds(&of->octave, between)) {
            inside = middle;
        } else {
            outside = middle;
        }
    }
    return outside;
}

/* The pixels x0 <= x < x1 of row y. */
FXL_INLINED void fxl_depth_paint_row(fxl_depth_painting *of, int32_t y, int32_t x0, int32_t x1,
                                     uint32_t bits, fxl_run_painter *paint, const void *with)
{
    const fxl_gradient *gradient = &of->plane->gradient;
    const size_t row_bytes = (size_t)of->band->width * (bits / 8u);
    void *cells =
        (uint8_t *)(uintptr_t)(of->head + 1) + (size_t)(y - of->band->first_row) * row_bytes;
    const int64_t depth = gradient->at + fxl_multiply_s64_u16(gradient->down, (uint32_t)y);
    while (x0 < x1) {
        const int32_t end = fxl_depth_is_in_words(of->plane)
                                ? fxl_depth_words_end(of, (uint32_t)(depth & UINT32_MAX), x0, x1)
                                : fxl_depth_octave_end(of, depth, x0, x1);
        const fxl_depth_octave *octave = &of->octave;
        fxl_depth_line line = {octave->bias, octave->step};
        if (!octave->is_constant) {
            line.code += fxl_depth_shifted(depth, octave->drop) + line.step * (uint32_t)x0;
        }
        if (of->head->or_equal) {
            const fxl_depth_rule rule = {bits == 32, true};
            fxl_depth_paint_line(of, cells, x0, end, line, rule, paint, with);
        } else {
            const fxl_depth_rule rule = {bits == 32, false};
            fxl_depth_paint_line(of, cells, x0, end, line, rule, paint, with);
        }
        x0 = end;
    }
}

#if FXL_KERNELS_ARMV7M && !FXL_IS_COMPACT

/* fxl_depth_paint_row of 16 bits: one copy for all targets, as kernels draw most rows. */
void fxl_depth_paint_row_16(fxl_depth_painting *of, int32_t y, int32_t x0, int32_t x1,
                            fxl_run_painter *paint, const void *with);

#endif

/* fxl_depth_paint_row of a target's bits. */
FXL_INLINED void fxl_depth_paint_target_row(fxl_depth_painting *of, int32_t y, int32_t x0,
                                            int32_t x1, uint32_t bits, fxl_run_painter *paint,
                                            const void *with)
{
#if FXL_KERNELS_ARMV7M && !FXL_IS_COMPACT
    if (bits == 16) {
        fxl_depth_paint_row_16(of, y, x0, x1, paint, with);
        return;
    }
#endif
    fxl_depth_paint_row(of, y, x0, x1, bits, paint, with);
}

/* memory: the target's. */
static inline void fxl_depth_begin(fxl_depth_painting *of, const void *memory,
                                   const fxl_depth_plane *plane, const fxl_band *band)
{
    of->plane = plane;
    of->head = (const fxl_depth_head *)memory;
    of->band = band;
    of->keeps = FXL_DEPTH_KEEPS_ALL;
    of->octave.low = of->octave.high = 0; /* no value is of it */
    of->octave.drop = 0;
}

#ifdef __cplusplus
}
#endif

#endif

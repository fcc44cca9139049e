/* SPDX-License-Identifier: MIT */
/* Fills pixels with a colour. Internal. */
#ifndef FXL_FILL_H
#define FXL_FILL_H

#include "../math/core.h"
#include "fixel/types.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Sets the pixels of a trapezoid, and no other byte, with aligned stores only.
 * Requires a trapezoid that scan returned for this band. It is a kernel: each family
 * of cores has its own, and all write the same bytes. */
void fxl_fill_trapezoid(const fxl_band *band, const fxl_trapezoid *trapezoid, uint8_t colour);

/* The same for a band of RGB565, whose pixels have an even address. */
void fxl_fill_trapezoid_rgb565(const fxl_band *band, const fxl_trapezoid *trapezoid,
                               uint16_t colour);

struct fxl_renderer; /* fixel/render.h */

/* fxl_target.fill: fxl_fill_band, and the same for a band of RGB565. One of these at an odd address
 * stays: the call that draws says why. They do not look at the renderer. */
void fxl_fill_band_palette(const struct fxl_renderer *renderer, const fxl_band *band,
                           uint8_t colour);
void fxl_fill_band_rgb565(const struct fxl_renderer *renderer, const fxl_band *band,
                          uint8_t colour);

/* Sets the pixels from one (included) to an end (not included). */
void fxl_fill_row_rgb565(uint16_t *pixel, uint16_t *end, uint16_t colour);

/* Sets the pixels of a span, and no other byte.
 * Requires a span that scan returned for this band. */
void fxl_fill_span(const fxl_band *band, const fxl_span *span, uint8_t colour);

typedef uint32_t __attribute__((may_alias)) fxl_word;

typedef uint16_t __attribute__((may_alias)) fxl_half_word;

/* Fills the bytes from pixel (included) to end (not included). `four` has the colour in each of its
 * four bytes. From 4 bytes on it stores a byte and a half word up to the next word, and words. Whole
 * words from an aligned address are stored as words, so they may be two pixels each. */
static inline void fxl_fill_row(uint8_t *pixel, uint8_t *end, uint32_t four)
{
    if (end - pixel >= 4) {
        if (((uintptr_t)pixel & 1u) != 0) {
            *pixel++ = (uint8_t)four;
        }
        if (((uintptr_t)pixel & 2u) != 0) {
            *(fxl_half_word *)(void *)pixel = (uint16_t)four;
            pixel += 2;
        }
        for (; end - pixel >= 32; pixel += 32) {
            fxl_word *words = (fxl_word *)(void *)pixel;
            words[0] = four;
            words[1] = four;
            words[2] = four;
            words[3] = four;
            words[4] = four;
            words[5] = four;
            words[6] = four;
            words[7] = four;
        }
        for (; end - pixel >= 8; pixel += 8) {
            fxl_word *words = (fxl_word *)(void *)pixel;
            words[0] = four;
            words[1] = four;
        }
        if (end - pixel >= 4) {
            *(fxl_word *)(void *)pixel = four;
            pixel += 4;
        }
    }
    while (pixel != end) {
        *pixel++ = (uint8_t)four;
    }
}

/* Moves an edge to the next row. The carry of the fraction is a pixel. */
static inline void fxl_edge_step(fxl_edge *edge)
{
    uint64_t fraction = (uint64_t)edge->fraction + edge->step_fraction;
    edge->fraction = fxl_low_32(fraction);
    edge->x += edge->step + (int32_t)(fraction >> 32);
}

#ifdef __cplusplus
}
#endif

#endif

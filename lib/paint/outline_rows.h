/* SPDX-License-Identifier: MIT */
/* The rows of an outline whose depth codes are linear on the screen, in C: those of a scan, and the
 * test of a pixel. What paints a row is given by the caller, and is inlined. Internal. */
#ifndef FXL_OUTLINE_ROWS_H
#define FXL_OUTLINE_ROWS_H

#include "../raster/scan.h"
#include "fixel/types.h"

/* Some pixels of a row, from 1 on. */
typedef struct {
    uint32_t x, y; /* of the first one, on the screen */
    uint32_t count;
    uint16_t *cell; /* of it */
    uint8_t *pixel;
} fxl_outline_row;

/* Paints them; of, kind: the painter's own. */
typedef void fxl_outline_row_painter(const void *of, uint32_t kind, fxl_outline_row row);

/* Whether a pixel is nearer than its cell, near to far. Its code is kept then. */
/* SPEC 10.4 */
static inline bool fxl_keep_nearer(uint16_t *cell, uint32_t code)
{
    if (code >> 16 <= *cell) {
        return false;
    }
    *cell = (uint16_t)(code >> 16);
    return true;
}

/* An edge, or its step, as one number: fxl_edge_step is a sum then, which wraps. */
static inline uint64_t fxl_whole_edge(int32_t x, uint32_t fraction)
{
    return (uint64_t)fxl_bits_32(x) << 32 | fraction;
}

/* All rows of a scan that was begun. cells: of the band. */
static inline __attribute__((always_inline)) void
fxl_paint_outline_rows(const fxl_band *band, uint16_t *cells, uint32_t pixel_bytes, fxl_scan *scan,
                       fxl_outline_row_painter *paint, const void *of, uint32_t kind)
{
    const fxl_trapezoid *trapezoid;
    while ((trapezoid = fxl_scan_next_trapezoid(scan)) != NULL) {
        const fxl_edge *edges = trapezoid->edges;
        const uint64_t a_step = fxl_whole_edge(edges[0].step, edges[0].step_fraction);
        const uint64_t b_step = fxl_whole_edge(edges[1].step, edges[1].step_fraction);
        uint64_t a = fxl_whole_edge(edges[0].x, edges[0].fraction);
        uint64_t b = fxl_whole_edge(edges[1].x, edges[1].fraction);
        const uint32_t end = (uint32_t)trapezoid->end_row;
        for (uint32_t y = (uint32_t)trapezoid->first_row; y < end; y++) {
            const int32_t left = (int32_t)(a >> 32), right = (int32_t)(b >> 32);
            const uint32_t x = (uint32_t)(left < right ? left : right);
            const uint32_t count = (uint32_t)(left < right ? right : left) - x;
            if (count != 0) {
                const uint32_t line = y - band->first_row;
                const fxl_outline_row row = {x, y, count, cells + ((size_t)line * band->width + x),
                                             band->pixels +
                                                 ((size_t)line * band->stride + x) * pixel_bytes};
                paint(of, kind, row);
            }
            a += a_step;
            b += b_step;
        }
    }
}

#endif

/* SPDX-License-Identifier: MIT */
/* The rows of a trapezoid of a face without light, whose pixels are those of a kernel of segments.
 * Internal. */
#ifndef FXL_PLAIN_ROWS_H
#define FXL_PLAIN_ROWS_H

#include "../raster/fill.h"
#include "fixel/records.h"
#include "segments.h"

#ifdef __cplusplus
extern "C" {
#endif

/* The next row, whose `segments` is not null, and what leads to the rows below it. */
typedef struct {
    fxl_paint_row row;
    int64_t downs[3]; /* what weight, u and v change from row to row */
    fxl_edge edges[2];
    int32_t end_row;
    uint32_t stride; /* bytes */
} fxl_plain_rows;

/* Paints rows from rows->row on. Returns false if it has come to end_row. Returns true at a row
 * whose weights the kernel does not take: rows->row is that row, and nothing of it is painted.
 * Requires a face without a ramp, and row.y < end_row. Pixels have 8 bits, or 16. */
bool fxl_paint_rows(fxl_plain_rows *rows);
bool fxl_paint_rows_565(fxl_plain_rows *rows);

/* Runs of visible pixels: depth_rows.h. The row is that of the run before. Only Armv7-M paints
 * them, where its code is not compiled for size. */
typedef struct {
    fxl_paint_row row; /* y is not kept */
    int64_t downs[4];  /* as above; and light, of a lit face */
    const uint32_t *next, *end;
    uint32_t stride; /* bytes */
} fxl_plain_runs;

/* Paints runs from runs->next on. Returns false if it has come to the end. Returns true after a run
 * whose weights the kernel does not take: it is the one before runs->next, in runs->row, and
 * nothing of it is painted. Requires a face without a ramp. Pixels have 8 bits, or 16. */
bool fxl_paint_runs(fxl_plain_runs *runs);
bool fxl_paint_runs_565(fxl_plain_runs *runs);

/* The same of a face with a ramp. It does not take a run that has segments of several lengths
 * either, or pixels that are each divided. Pixels have 8 bits. */
bool fxl_paint_lit_runs(fxl_plain_runs *runs);

/* The codes of depth along a row, and its cells of 16 bits: the code of column x is code + x step,
 * modulo 2^32. A cell has its upper half. */
typedef struct {
    uint32_t step;
    uint16_t *cells;   /* of column 0 */
    uint32_t code;     /* of column 0 */
    uint32_t or_equal; /* 1: what is as near as the cell is visible too; else 0 */
} fxl_hole_depths;

/* fxl_paint_segments of texels that are keyed or stippled, of the pixels that are visible: whose
 * code / 2^16, rounded down, is above their cell. It keeps that of those that are drawn. Returns
 * true if the kernel does not take the row's weights: then nothing is painted. Only Armv7-M has it,
 * where its code is not compiled for size. */
bool fxl_paint_holes(const fxl_segment_face *face, const fxl_paint_row *row, int32_t x0, int32_t x1,
                     const fxl_hole_depths *depths);
bool fxl_paint_holes_565(const fxl_segment_face *face, const fxl_paint_row *row, int32_t x0,
                         int32_t x1, const fxl_hole_depths *depths);

/* A sum below the last row may be beyond what is bounded: then it wraps. */
static inline void fxl_plain_rows_next(fxl_plain_rows *rows)
{
    fxl_paint_row *row = &rows->row;
    row->weight = (int64_t)((uint64_t)row->weight + (uint64_t)rows->downs[0]);
    for (uint32_t i = 0; i < 2; i++) {
        row->attributes[i] = (int64_t)((uint64_t)row->attributes[i] + (uint64_t)rows->downs[1 + i]);
    }
    fxl_edge_step(&rows->edges[0]);
    fxl_edge_step(&rows->edges[1]);
    row->pixels += rows->stride;
    row->y++;
}

/* The columns that a row covers; none if they are equal. */
static inline void fxl_plain_rows_columns(const fxl_plain_rows *rows, int32_t *x0, int32_t *x1)
{
    const int32_t a = rows->edges[0].x, b = rows->edges[1].x;
    *x0 = a < b ? a : b;
    *x1 = a < b ? b : a;
}

/* fxl_paint_rows in portable C. paint: the kernel of segments. */
static inline __attribute__((always_inline)) bool fxl_paint_rows_by(
    fxl_plain_rows *rows,
    void (*paint)(const fxl_segment_face *face, const fxl_paint_row *row, int32_t x0, int32_t x1))
{
    const fxl_segment_face *face = rows->row.segments;
    for (; rows->row.y < rows->end_row; fxl_plain_rows_next(rows)) {
        int32_t x0, x1;
        fxl_plain_rows_columns(rows, &x0, &x1);
        if (x0 < x1) {
            if (!fxl_segments_suffice(face, &rows->row, x0, x1)) {
                return true;
            }
            paint(face, &rows->row, x0, x1);
        }
    }
    return false;
}

#ifdef __cplusplus
}
#endif

#endif

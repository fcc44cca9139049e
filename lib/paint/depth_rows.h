/* SPDX-License-Identifier: MIT */
/* Rows of a polygon in a depth buffer of 16 bits, near to far: the depth test of all rows of a
 * trapezoid in one call. It keeps the depths of visible pixels, and lists runs of such pixels,
 * which a kernel of rows paints: fxl_plain_runs. Only Armv7-M has this, where its code is not
 * compiled for size; elsewhere depth_row.h does the same run by run. Internal. */
#ifndef FXL_DEPTH_ROWS_H
#define FXL_DEPTH_ROWS_H

#include "../math/family.h"
#include "../raster/fill.h"
#include "depth_row.h"

#ifdef __cplusplus
extern "C" {
#endif

#if FXL_KERNELS_ARMV7M && !FXL_IS_COMPACT
#define FXL_HAS_DEPTH_ROWS 1
#else
#define FXL_HAS_DEPTH_ROWS 0
#endif

/* A run of visible pixels: its first column, from bit 16 on the column after its last one, and
 * FXL_RUN_BELOW. An empty run has two equal columns. */
#define FXL_RUN_BELOW 0x80000000u /* it is in the row below that of the run before */

/* What the kernel needs of a polygon, and what it keeps from row to row. An octave here is the
 * number of leading zeros of the gradient's upper word. */
typedef struct {
    FXL_ALIGN_8 fxl_edge edges[2];
    int64_t value; /* of the plane in column 0 of the next row */
    int64_t along, down;
    uint16_t *cells;    /* of column 0 of the next row */
    uint32_t row_bytes; /* of a row of cells */
    uint32_t zeros;     /* of the octave that is known; above 32: of none */
    int32_t drop;       /* of it, as of fxl_depth_octave; so the next one */
    uint32_t bias;
    uint32_t is_last; /* it is the last octave, where codes may be below 1 */
    uint32_t step;
    int32_t one;       /* of the plane */
    uint32_t octaves;  /* of the scale */
    uint32_t mantissa; /* of the scale */
    uint32_t rows;     /* of the trapezoid; and FXL_RUN_BELOW, if the first one lies below the row
                          of the runs before */
    uint32_t *runs;    /* where the next run goes */
    uint32_t *runs_end;
    uint32_t rest[8];    /* of a row that has several octaves: the kernel's own */
    uint32_t resumed[9]; /* where to go on: the kernel's own; the first one is 0: nowhere */
} fxl_depth_rows;

#if FXL_HAS_DEPTH_ROWS

/* Tests the rows of a trapezoid. Returns false if all are tested. Returns true if there is no room
 * for a run more: the same call, with room, goes on. Requires fxl_depth_rows_begin, edges within
 * the band's columns, rows from 1 on, and room for a run. */
bool fxl_find_depth_runs(fxl_depth_rows *rows);

/* The same far to near, for what is blended: no depth is kept. */
bool fxl_find_visible_runs(fxl_depth_rows *rows);

#endif

/* Whether the kernels can test a polygon: its depths are all kept near to far, or not at all far to
 * near, and a value of its plane whose upper word is not above 0 is beyond the last octave. */
static inline bool fxl_depth_rows_take(const fxl_depth_painting *painting)
{
    return painting->keeps ==
               (painting->head->or_equal ? FXL_DEPTH_KEEPS_NONE : FXL_DEPTH_KEEPS_ALL) &&
           painting->plane->one >= 32 + painting->head->scale.octaves;
}

/* Prepares a polygon that the kernel can test. Sets neither value and cells nor edges and rows. */
static inline void fxl_depth_rows_begin(const fxl_depth_painting *painting, fxl_depth_rows *rows)
{
    const fxl_depth_plane *plane = painting->plane;
    const fxl_depth_scale scale = painting->head->scale;
    rows->along = plane->gradient.along;
    rows->down = plane->gradient.down;
    rows->row_bytes = 2u * painting->band->width;
    rows->zeros = UINT32_MAX;
    rows->one = plane->one;
    rows->octaves = scale.octaves;
    rows->mantissa = scale.mantissa;
    rows->resumed[0] = 0;
}

/* Goes to row y of the band. */
static inline void fxl_depth_rows_go(const fxl_depth_painting *painting, int32_t y,
                                     fxl_depth_rows *rows)
{
    const uintptr_t cells = (uintptr_t)(painting->head + 1);
    rows->value = painting->plane->gradient.at + rows->down * y;
    rows->cells = (uint16_t *)(cells + (uint32_t)(y - painting->band->first_row) * rows->row_bytes);
}

#ifdef __cplusplus
}
#endif

#endif

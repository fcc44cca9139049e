/* SPDX-License-Identifier: MIT */
/* Where rows of a horizon pass a sine. Internal. */
#ifndef FXL_HORIZON_ROWS_H
#define FXL_HORIZON_ROWS_H

#include "fixel/types.h"

#ifdef __cplusplus
extern "C" {
#endif

#define FXL_HORIZON_ROWS 16 /* at a time */

/* Some rows of a band. 2^scale is the least power of two above each |d| of a whole row of the frame,
 * whatever part of it the band has; it is one for all rows. Lengths are in units of 2^(scale - 31):
 * exact, and below 2^31. */
typedef struct {
    const fxl_lens *lens;
    fxl_q2_30 right, up, forward; /* upward components of the camera's rows: B is the first */
    int32_t first_x;              /* X of the band's first column, 16.16 */
    uint32_t columns;

    unsigned scale;
    int32_t x, y, step; /* X of the first column, Y of the first row, and a pixel */
    int64_t straight;   /* what the focal length adds to A, in units of 2^(scale - 61) */
    uint64_t ahead;     /* and its square to c */
    int32_t xx, xy, yy; /* products of right and up, in units of 2^-28 */
    uint32_t count;
    bool rises, turns; /* from the first column to the right; and whether it falls (rises) later */

    /* The piece of each row that is looked at: up to where it turns, or from there on. */
    bool is_second;
    int32_t flip;       /* -1 if the level falls along it, else 0 */
    uint32_t from, end; /* columns that it has in all rows */
    uint16_t turn[FXL_HORIZON_ROWS];
} fxl_horizon_rows;

static inline uint32_t fxl_horizon_from(const fxl_horizon_rows *rows, uint32_t row)
{
    return rows->is_second ? rows->turn[row] : 0;
}

static inline uint32_t fxl_horizon_end(const fxl_horizon_rows *rows, uint32_t row)
{
    return rows->is_second ? rows->columns : rows->turn[row];
}

/* Where a sine is passed in the last row, and the least that this moves from row to row. */
typedef struct {
    int16_t column, step;
} fxl_horizon_change;

/* Takes as many rows as are alike from one whose Y, in 16.16, is y: 1 to most. */
void fxl_horizon_take(fxl_horizon_rows *rows, int32_t y, uint32_t most);

/* Looks at one piece of the rows. */
void fxl_horizon_choose(fxl_horizon_rows *rows, bool is_second);

/* Whether a column has passed a sine: is above it, or, where the level falls, is not. */
bool fxl_horizon_has_passed(const fxl_horizon_rows *rows, uint32_t row, uint32_t column,
                            fxl_q2_30 sine);

/* Whether each row has passed a sine at the first column of its piece, or none has at its last one:
 * false also where that is not sure. */
bool fxl_horizon_are_alike(const fxl_horizon_rows *rows, fxl_q2_30 sine, bool is_last);

/* The columns that pass a sine first; the end of the piece where none does. */
void fxl_horizon_find(const fxl_horizon_rows *rows, fxl_q2_30 sine, fxl_horizon_change *change,
                      uint16_t *columns);

#ifdef __cplusplus
}
#endif

#endif

/* SPDX-License-Identifier: MIT */
/* Kernels of Armv6-M for faces without light: rows, runs of segments of the same length, and rows
 * of constant weight. segment_runs.h and plain_rows.h are the portable text of all three. Internal.
 */
#ifndef FXL_PLAIN_RUN_H
#define FXL_PLAIN_RUN_H

#include "plain_rows.h"

#ifdef __cplusplus
extern "C" {
#endif

/* What paints pixels of 8 or of 16 bits: code and its sizes, which plain_rows_armv6m.h names. A
 * program links that of the pixels it has. */
typedef struct fxl_texel_code fxl_texel_code;
extern const fxl_texel_code fxl_texel_code_8, fxl_texel_code_565;

/* The pixels x0 <= x < x1 of a row, in segments of 2^log columns; log 0: each is divided. */
typedef struct {
    int32_t x0, x1;
    const fxl_texel_code *code;
    uint32_t log;
} fxl_run;

/* The same in a row of constant weight: both coordinates, of 32 bits, at the 16 columns that have
 * x0, their changes in 16 columns, and the step of a position in one. */
typedef struct {
    int32_t x0, x1;
    const fxl_texel_code *code;
    uint32_t u, v, u_change, v_change, step;
} fxl_line_run;

/* All require a face without a ramp, columns below 2^16, and what fxl_paint_segments requires.
 * Pixels of 8 bits become texels, whatever table the face has. All are as safe as
 * fxl_paint_segments for any other number. */

/* Requires 0 <= x0 < x1, and log 0, 2, 3 or 4. */
void fxl_paint_run(const fxl_segment_face *face, const fxl_paint_row *row, const fxl_run *run);
void fxl_paint_line(const fxl_segment_face *face, const fxl_paint_row *row,
                    const fxl_line_run *line);

/* fxl_paint_rows, of a face whose rows are not lines. */
bool fxl_paint_plain_rows(fxl_plain_rows *rows, const fxl_texel_code *code);

#ifdef __cplusplus
}
#endif

#endif

/* SPDX-License-Identifier: MIT */
/* The kernel of fill: one for each family of cores (lib/kernels), all with the
 * same bytes as lib/kernels/portable. Internal. */
#ifndef FXL_FILL_ROWS_H
#define FXL_FILL_ROWS_H

#include "fixel/record.h"

/* Sets the pixels of a trapezoid's rows, and no other byte; row is where the
 * first of them begins, stride what the next lies further on. No alignment is
 * asked of either, and no access is misaligned.
 * Requires first_row < end_row and x within the row's memory on every row. */
void fxl_fill_rows(uint8_t *row, size_t stride, const fxl_trapezoid *trapezoid, uint8_t colour);

#endif

/* SPDX-License-Identifier: MIT */
/* fxl_fill_trapezoid for Armv8.1-M with MVE. Rows of fewer than 64 bytes are stored by
 * vectors, the last of which is predicated, so bytes beside a word cost nothing extra.
 * Longer rows are stored by store-multiple instructions, which takes half the
 * instructions. The program has turned on the vector unit, as for any code of a hard-float
 * ABI. */
#include "../math/family.h"

#if FXL_KERNELS_MVE

#define FXL_ROWS_BY_VECTORS 1

#include "fill_rows_armv7m.S"

#endif

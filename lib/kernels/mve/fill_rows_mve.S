/* SPDX-License-Identifier: MIT */
/* fxl_fill_trapezoid for ARMv8.1-M with MVE: rows of fewer than 64 bytes by vectors
 * whose last one is cut off, which takes no more for bytes beside a word. Longer
 * ones go by multiple stores, which take half the instructions. The caller has
 * turned the vectors on, as for any code of a hard-float ABI. */
#include "../family.h"

#if FXL_KERNELS_MVE

#define FXL_ROWS_BY_VECTORS 1

#include "../armv7m/fill_rows_armv7m.S"

#endif

/* SPDX-License-Identifier: MIT */
/* fxl_fill_trapezoid_rgb565 and fxl_fill_rows_rgb565 for Armv7-M and Armv8-M Mainline: the texts of
 * fxl_fill_trapezoid and fxl_fill_rows once more, for pixels of 16 bits. Both edges are kept as
 * halves of addresses, so a step of an edge is a pixel there, too. */
#include "../math/family.h"

#define FXL_PIXELS_OF_16_BITS 1

    .global fxl_fill_rows_rgb565

#if FXL_FILLS_COMPACT
#include "fill_compact_armv7m.S"
#else
#if FXL_KERNELS_MVE
#define FXL_ROWS_BY_VECTORS 1
#endif
#include "fill_rows_armv7m.S"
#endif

/* SPDX-License-Identifier: MIT */
/* Colour into a band. */
#ifndef FXL_FILL_H
#define FXL_FILL_H

#include "fixel/types.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Sets the pixels of a trapezoid, and no other byte, with aligned stores alone.
 * Requires one that scan gave for this band. A kernel: one for each family of
 * cores (lib/kernels), all with the same bytes. */
void fxl_fill_trapezoid(const fxl_band *band, const fxl_trapezoid *trapezoid, uint8_t colour);

/* Sets the pixels of a span. Requires a span that scan gave for this band. */
void fxl_fill_span(const fxl_band *band, const fxl_span *span, uint8_t colour);

/* Sets every pixel of the band; bytes between width and stride stay. */
void fxl_fill_band(const fxl_band *band, uint8_t colour);

#ifdef __cplusplus
}
#endif

#endif

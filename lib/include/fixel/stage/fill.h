/* SPDX-License-Identifier: MIT */
/* Fills pixels of a band with a colour. */
#ifndef FXL_FILL_H
#define FXL_FILL_H

#include "fixel/types.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Sets the pixels of a trapezoid, and no other byte, with aligned stores only.
 * Requires a trapezoid that scan returned for this band. It is a kernel: each family
 * of cores has its own, and all write the same bytes. */
void fxl_fill_trapezoid(const fxl_band *band, const fxl_trapezoid *trapezoid, uint8_t colour);

/* Sets the pixels of a span, and no other byte.
 * Requires a span that scan returned for this band. */
void fxl_fill_span(const fxl_band *band, const fxl_span *span, uint8_t colour);

/* Sets every pixel of the band. The bytes between width and stride are untouched. */
void fxl_fill_band(const fxl_band *band, uint8_t colour);

#ifdef __cplusplus
}
#endif

#endif

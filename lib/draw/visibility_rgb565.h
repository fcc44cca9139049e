/* SPDX-License-Identifier: MIT */
/* The visibility method of frames of 16 bits a pixel. It is set with a fxl_rgb565_frame alone, as
 * its memory. Internal. */
#ifndef FXL_VISIBILITY_RGB565_H
#define FXL_VISIBILITY_RGB565_H

#include "fixel/rgb565.h"

#ifdef __cplusplus
extern "C" {
#endif

/* The order of fxl_visibility_sorted; a later polygon covers an earlier one. A band of it is
 * a fxl_band whose pixels are of 16 bits, and whose stride is in bytes. */
extern const fxl_visibility fxl_visibility_rgb565;

/* Sets the pixels from one (included) to an end (not included). */
void fxl_fill_row_rgb565(uint16_t *pixel, uint16_t *end, uint16_t colour);

#ifdef __cplusplus
}
#endif

#endif

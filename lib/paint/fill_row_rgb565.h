/* SPDX-License-Identifier: MIT */
/* Filling a row of 16 bits a pixel. Internal. */
#ifndef FXL_FILL_ROW_RGB565_H
#define FXL_FILL_ROW_RGB565_H

#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/* Sets the pixels from one (included) to an end (not included). */
void fxl_fill_row_rgb565(uint16_t *pixel, uint16_t *end, uint16_t colour);

#ifdef __cplusplus
}
#endif

#endif

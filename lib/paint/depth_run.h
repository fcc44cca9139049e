/* SPDX-License-Identifier: MIT */
/* The depth test of a run of pixels, in a depth buffer of 16 bits front to back. Kernels: each
 * family of cores has its own. Internal. */
#ifndef FXL_DEPTH_RUN_H
#define FXL_DEPTH_RUN_H

#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/* The code of pixel i is code + i step, modulo 2^32. A pixel is visible if its code / 2^16, rounded
 * down, is above its cell.
 *
 * Returns how many pixels from the first on, of count, are visible, and keeps their codes / 2^16 in
 * the cells. */
uint32_t fxl_depth_keep_visible(uint16_t *cells, uint32_t count, uint32_t code, uint32_t step);

/* Returns how many pixels from the first on, of count, are not visible. */
uint32_t fxl_depth_skip_hidden(const uint16_t *cells, uint32_t count, uint32_t code, uint32_t step);

#ifdef __cplusplus
}
#endif

#endif

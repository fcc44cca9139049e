/* SPDX-License-Identifier: MIT */
/* Painting the pixels of a face that has a surface, 16 bits each. Internal. */
#ifndef FXL_PAINT_RGB565_H
#define FXL_PAINT_RGB565_H

#include "paint.h"

#ifdef __cplusplus
extern "C" {
#endif

/* All that a face's pixels depend on. `blend` of the paint is not used. */
typedef struct {
    fxl_paint paint; /* the first member: the painter of rows is handed its address */
    const uint16_t *palette;
    uint32_t part_of_level; /* 2^16 / (levels - 1), rounded; 0: unlit */
    uint16_t dark;
    uint16_t key;  /* of a texture that is FXL_TEXTURE_565 */
    uint8_t flags; /* of the surface */
} fxl_paint_565;

/* fxl_row_painter; with: not used, paint: the first member of a fxl_paint_565. row->pixels is the
 * address of a uint16_t. Safe for any gradients: no texel is read that is not of the level, and no
 * other pixel is written. */
void fxl_paint_row_rgb565(void *with, const fxl_paint *paint, const fxl_paint_row *row, int32_t x0,
                          int32_t x1);

#ifdef __cplusplus
}
#endif

#endif

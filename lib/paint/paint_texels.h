/* SPDX-License-Identifier: MIT */
/* The texels of a part of a segment: what fxl_paint_segments calls, where it is in C. Internal. */
#ifndef FXL_PAINT_TEXELS_H
#define FXL_PAINT_TEXELS_H

#include "segments.h"

#ifdef __cplusplus
extern "C" {
#endif

/* At a run's first pixel, and the steps a pixel. */
typedef struct {
    uint32_t position, step;
    uint32_t light, light_step; /* 1/256 level */
} fxl_texel_run;

/* Paints count pixels. Requires 1 <= count <= 16. */
void fxl_paint_texels(const fxl_segment_face *face, const fxl_texel_run *run, uint8_t *pixels,
                      uint32_t count);

#ifdef __cplusplus
}
#endif

#endif

/* SPDX-License-Identifier: MIT */
/* Bands with a depth buffer, in parts. Internal. */
#ifndef FXL_DEPTH_DRAW_H
#define FXL_DEPTH_DRAW_H

#include "fixel/render.h"

#ifdef __cplusplus
extern "C" {
#endif

/* fxl_target.draw_band: as many rows at a time as the workspace has cells for. Far to near
 * each part is drawn in two passes: what is opaque, then what is blended. A cell and a pixel have
 * so many bytes. */
void fxl_depth_draw_parts(const fxl_renderer *renderer, fxl_workspace *workspace,
                          const fxl_band *band, uint32_t cell_bytes, uint32_t pixel_bytes);

#ifdef __cplusplus
}
#endif

#endif

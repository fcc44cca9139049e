/* SPDX-License-Identifier: MIT */
/* The depth of a face on the screen, and bands with a depth buffer, in parts. Internal. */
#ifndef FXL_DRAW_DEPTH_H
#define FXL_DRAW_DEPTH_H

#include "surface_polygon.h"

#ifdef __cplusplus
extern "C" {
#endif

/* The plane through the face's first corner with the face's normal.
 * A face that is seen edge-on, to within the rounding of its normal, is at infinity.
 * Error: the normal is off by less than 2^-28, and the depth of the plane relatively by less than
 * 2^-27. */
void fxl_depth_plane_find(const fxl_model_view *model_view, const fxl_face *face,
                          const fxl_traversal *traversal, fxl_depth_plane *plane);

/* fxl_target.draw_band: as many rows at a time as the workspace has cells for. Far to near
 * each part is drawn in two passes: what is opaque, then what is blended. A cell and a pixel have
 * so many bytes. */
void fxl_depth_draw_parts(const fxl_renderer *renderer, fxl_workspace *workspace,
                          const fxl_band *band, uint32_t cell_bytes, uint32_t pixel_bytes);

#ifdef __cplusplus
}
#endif

#endif

/* SPDX-License-Identifier: MIT */
/* The one pixel of a tiny triangle, whose depth is found without the triangle's plane. Internal. */
#ifndef FXL_DEPTH_PIXEL_H
#define FXL_DEPTH_PIXEL_H

#include "../paint/depth_outline.h"
#include "submit.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Draws a triangle that covers one pixel, as fxl_find_depth_plane and fxl_depth_tiny_draw do, and makes
 * the box of its centres that pixel. False: the depth that is estimated does not decide the code, and
 * nothing is drawn. Requires what fxl_depth_tiny_draw does, and the corners of the face in
 * workspace->screen. */
bool fxl_depth_draw_pixel(const fxl_model_view *model_view, const fxl_face *face,
                          const fxl_traversal *traversal, fxl_tiny *tiny, uint32_t filling,
                          uint32_t pixel_bytes);

#ifdef __cplusplus
}
#endif

#endif

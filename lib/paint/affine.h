/* SPDX-License-Identifier: MIT */
/* Attributes that are linear on the screen. Internal. */
#ifndef FXL_AFFINE_H
#define FXL_AFFINE_H

#include "fixel/records.h"
#include "gradients.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Where all three corners are on the screen, puts them into the plane of the screen, so that their
 * weight is constant and their attributes are linear on the screen. Corners that are on one line
 * there stay as they are. A corner is on the screen if it can be projected, with
 * 0 <= x <= width and 0 <= y <= height. Exact, given the projected corners. */
void fxl_corners_make_affine(fxl_gradient_corners *face, const fxl_view *view);

#ifdef __cplusplus
}
#endif

#endif

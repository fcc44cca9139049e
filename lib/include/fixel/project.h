/* SPDX-License-Identifier: MIT */
/* From the view onto the screen (Listing 65.3, ProjectPolygon). */
#ifndef FXL_PROJECT_H
#define FXL_PROJECT_H

#include "fixel/lens.h"

/* Nothing nearer than this projects: 2^-9, half the nearest near plane. */
#define FXL_PROJECT_DEPTH_MIN ((fxl_q18_46)1 << 37)

/* x = width/2 + focal X / Z, y = height/2 - focal Y / Z, each rounded once, to
 * the nearest 1/65536 pixel (halves upward, before the centre is added). X and
 * Y enter whole, Z with 31 bits.
 * Requires |x|, |y|, |z| < 2^61 units.
 * Error, given the view point: at most 0.5 + 2^-30 + 2^-31 |x - width/2| units in
 * x, in units of 1/65536 pixel, likewise in y: 0.52 on a screen of 1024 pixels.
 * FXL_E_RANGE where z < FXL_PROJECT_DEPTH_MIN or a coordinate would leave
 * FXL_SCREEN_COORDINATE_MAX: screen untouched. */
fxl_status fxl_project_point(const fxl_lens *lens, const fxl_view_point *view,
                             fxl_screen_point *screen);

/* Every vertex of a polygon; colour and count carried over. On FXL_E_RANGE the
 * screen polygon's count is 0. */
fxl_status fxl_project_polygon(const fxl_lens *lens, const fxl_view_polygon *view,
                               fxl_screen_polygon *screen);

#endif

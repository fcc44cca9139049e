/* SPDX-License-Identifier: MIT */
/* From the view onto the screen (Listing 65.3, ProjectPolygon). */
#ifndef FXL_PROJECT_H
#define FXL_PROJECT_H

#include "fixel/lens.h"

/* x = width/2 + focal X / Z, y = height/2 - focal Y / Z, each rounded once, to
 * the nearest 1/65536 pixel (halves upward, before the centre is added).
 * Error, transform included: at most 0.5 + 2^-30 * (|x - width/2| + focal * max(1, |X/Z|, |Y/Z|))
 * units, |x - width/2| and focal in units of 1/65536 pixel.
 * FXL_E_RANGE where z <= 0 or a coordinate would leave
 * FXL_SCREEN_COORDINATE_MAX: screen untouched. */
fxl_status fxl_project_point(const fxl_lens *lens, const fxl_view_point *view,
                             fxl_screen_point *screen);

/* Every point of a polygon; colour and count carried over. On FXL_E_RANGE the
 * screen polygon's count is 0. */
fxl_status fxl_project_polygon(const fxl_lens *lens, const fxl_view_polygon *view,
                               fxl_screen_polygon *screen);

#endif

/* SPDX-License-Identifier: MIT */
/* From the view onto the screen (Listing 65.3, ProjectPolygon). */
#ifndef FXL_PROJECT_H
#define FXL_PROJECT_H

#include "fixel/stage/lens.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Nothing nearer than this projects: 2^-9, half the nearest near plane. */
#define FXL_PROJECT_DEPTH_MIN (FXL_CAST(fxl_q18_46, 1) << 37)

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

/* What projecting takes of a lens, set up once. Members are for project alone. */
typedef struct {
    uint32_t factor;   /* 4 focal */
    int32_t depth_min; /* least upper word of Z that a kernel takes the short way for */
    uint32_t factor_less_1;
    uint32_t factor_2;  /* 2^2 factor, modulo 2^32 */
    uint32_t factor_17; /* 2^17 factor, modulo 2^32 */
    fxl_q16_16 centre_x, centre_y;
} fxl_projection;

/* Requires a lens made by its function. */
void fxl_projection_from_lens(const fxl_lens *lens, fxl_projection *projection);

/* The same as fxl_project_point, for who projects many points. */
fxl_status fxl_project_visible(const fxl_projection *projection, const fxl_view_point *view,
                               fxl_screen_point *screen);

/* The same for a point inside the lens's frustum, or outside it by a few units: a kernel,
 * one for each family of cores. */
fxl_status fxl_project_inside(const fxl_projection *projection, const fxl_view_point *view,
                              fxl_screen_point *screen);

/* Every vertex of a polygon; colour and count carried over. On FXL_E_RANGE the
 * screen polygon's count is 0. */
fxl_status fxl_project_polygon(const fxl_lens *lens, const fxl_view_polygon *view,
                               fxl_screen_polygon *screen);

#ifdef __cplusplus
}
#endif

#endif

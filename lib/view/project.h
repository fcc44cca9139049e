/* SPDX-License-Identifier: MIT */
/* Projection: from the view to the screen. Internal. */
#ifndef FXL_PROJECT_H
#define FXL_PROJECT_H

#include "../math/contract.h"
#include "fixel/records.h"

#ifdef __cplusplus
extern "C" {
#endif

/* The least depth that can be projected: 2^-9 world unit, half the nearest near plane. */
#define FXL_PROJECT_DEPTH_MIN (FXL_CAST(fxl_q18_46, 1) << 37)
/* What fxl_projection_from_lens sets, for contracts. */
#define FXL_PROJECTION(p) \
    ((p)->factor >= 4 && (p)->factor < 1u << 31 && (p)->factor % 4 == 0 && \
     ((p)->depth_min == INT32_MAX || (p)->depth_min == (int32_t)(FXL_PROJECT_DEPTH_MIN >> 32)) && \
     (p)->centre_x >= 32768 && (p)->centre_x <= 512 * 65536 && (p)->centre_y >= 32768 && \
     (p)->centre_y <= 512 * 65536 && ((p)->depth_min == INT32_MAX || (p)->factor < 1u << 28) && \
     (p)->factor_2 == (p)->factor << 2 && (p)->factor_17 == (p)->factor << 17)
#define FXL_PROJECTS(p, view, screen) \
    (FXL_OBJECT(p) && FXL_OBJECT(view) && FXL_OBJECT(screen) && FXL_PROJECTION(p) && \
     FXL_BELOW((view)->x, ((int64_t)1 << 61) - 1) && FXL_BELOW((view)->y, ((int64_t)1 << 61) - 1) && \
     FXL_BELOW((view)->z, ((int64_t)1 << 61) - 1))

/* Projects a point (X, Y, Z) of the view:
 *   x = width/2 + focal X / Z, y = height/2 - focal Y / Z,
 * each rounded once, to the nearest 1/65536 pixel (halves upward, before the centre is
 * added). All bits of X and Y are used, and 31 bits of Z.
 * Requires |X|, |Y|, |Z| < 2^61 units, and a lens made by fxl_lens_from_fov.
 * FXL_E_RANGE: Z < FXL_PROJECT_DEPTH_MIN, or a coordinate would exceed FXL_SCREEN_COORDINATE_MAX;
 * screen untouched.
 * Error, given the view point, in units of 1/65536 pixel: at most
 * 0.5 + 2^-30 + 2^-31 |x - width/2| in x, likewise in y: 0.52 on a screen of 1024
 * pixels. */
fxl_status fxl_project_point(const fxl_lens *lens, const fxl_view_point *view,
                             fxl_screen_point *screen);

/* Sets up a projection. Requires a lens made by fxl_lens_from_fov. Exact. */
void fxl_projection_from_lens(const fxl_lens *lens, fxl_projection *projection)
    FXL_REQUIRES(FXL_OBJECT(lens) && FXL_OBJECT(projection) && lens->width >= 1)
    FXL_REQUIRES(lens->width <= FXL_SCREEN_MAX && lens->height >= 1 && lens->height <= FXL_SCREEN_MAX)
    FXL_REQUIRES(lens->focal > 0 && lens->focal < 1 << 29) FXL_ASSIGNS(*projection)
    FXL_ENSURES(FXL_PROJECTION(projection));

/* Does the same as fxl_project_point, with the lens set up beforehand. Requires a projection that
 * fxl_projection_from_lens set up: one of zeros may divide by zero. */
fxl_status fxl_project_visible(const fxl_projection *projection, const fxl_view_point *view,
                               fxl_screen_point *screen)
    FXL_REQUIRES(FXL_PROJECTS(projection, view, screen)) FXL_ASSIGNS(*screen)
    FXL_ENSURES(FXL_RESULT == FXL_OK || FXL_RESULT == FXL_E_RANGE);

/* Does the same for a point that is inside the lens's frustum, or outside it by a few units.
 * Requires a projection as fxl_project_visible does, and checks neither: it is called for each
 * vertex. It is a kernel: each family of cores has its own, and all give the same
 * bits. */
fxl_status fxl_project_inside(const fxl_projection *projection, const fxl_view_point *view,
                              fxl_screen_point *screen);

/* The same as fxl_project_visible, for any point, by a long division. */
fxl_status fxl_project_any(const fxl_projection *projection, const fxl_view_point *view,
                           fxl_screen_point *screen)
    FXL_REQUIRES(FXL_PROJECTS(projection, view, screen)) FXL_ASSIGNS(*screen)
    FXL_ENSURES(FXL_RESULT == FXL_OK || FXL_RESULT == FXL_E_RANGE);

#ifdef __cplusplus
}
#endif

#endif

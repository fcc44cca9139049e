/* SPDX-License-Identifier: MIT */
/* A sky and a ground in the place of the background: bands of colour by elevation.
 * docs/extras/horizon.md. */
#ifndef FXL_HORIZON_H
#define FXL_HORIZON_H

#include "fixel/render.h"
#include "fixel/scene.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Checks a horizon of tables that are as long as they must be.
 * FXL_E_ARGUMENT: it is null, or one of its tables is.
 * FXL_E_COUNT: count is outside 1..FXL_HORIZON_MAX.
 * FXL_E_RANGE: a sine is out of range, or below the one before it. */
fxl_status fxl_horizon_check(const fxl_horizon *horizon);

/* Attaches a horizon to a renderer, or, where it is null, detaches it. fxl_render, fxl_frame_fill and
 * fxl_pump_frame then draw it in the place of the background, as the eye of the frame sees it; the
 * colour that fxl_frame_fill is given has no meaning. Light and fog leave it as it is, what is
 * blended is mixed with it, and fxl_pick_face finds nothing where it is seen.
 * Exact where a sine is 0, given the camera's rows: a pixel is above the horizon if the ray through
 * its centre rises. Of another sine t a pixel may show the other side where the sine of its ray's
 * elevation is within 2^-20 of t.
 * FXL_E_ARGUMENT: renderer is null, or a table of the horizon is.
 * FXL_E_ORDER: the renderer was never initialised, or has no target.
 * Others: those of fxl_horizon_check.
 * With each of these statuses: nothing is changed but refused_calls. */
fxl_status fxl_attach_horizon(fxl_renderer *renderer, const fxl_horizon *horizon);

/* What functions of this header refuse: for fxl_explain. */
extern const char fxl_horizon_reasons[];

#ifdef __cplusplus
}
#endif

#endif

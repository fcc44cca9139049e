/* SPDX-License-Identifier: MIT */
/* A sky and a ground in the place of the background: bands of colour by elevation.
 * docs/extras/horizon.md. */
#ifndef FXL_HORIZON_H
#define FXL_HORIZON_H

#include "fixel/render.h"

#ifdef __cplusplus
extern "C" {
#endif

#define FXL_HORIZON_MAX 64u

/* What stands behind everything. The caller owns it, and keeps it as long as it is attached; it may
 * change between two frames: fxl_changed_find learns of it when the horizon is attached anew. */
typedef struct fxl_horizon {
    /* count sines of elevations in 2.30, ascending, each from -1 to 1: 0 is the horizon, 1 the
     * zenith. */
    const fxl_q2_30 *sines;
    /* count + 1 entries of the palette: colours[k] is seen where k of the sines are at most that of
     * the elevation. So colours[0] is that of the nadir. */
    const uint8_t *colours;
    uint32_t count; /* 1..FXL_HORIZON_MAX */
} fxl_horizon;

/* Attaches a horizon to a renderer, or, where it is null, detaches it. fxl_render, fxl_frame_fill and
 * fxl_pump_frame then draw it in the place of the background, as the eye of the frame sees it; the
 * colour that fxl_frame_fill is given has no meaning. Light and fog leave it as it is, what is
 * blended is mixed with it, and fxl_pick_face finds nothing where it is seen.
 * Exact where a sine is 0, given the camera's rows: a pixel is above the horizon if the ray through
 * its centre rises. Of another sine t a pixel may show the other side where the sine of its ray's
 * elevation is within 2^-20 of t.
 * FXL_E_ARGUMENT: renderer is null, or a table of the horizon is.
 * FXL_E_ORDER: the renderer was never initialised, or has no target.
 * FXL_E_COUNT: count is outside 1..FXL_HORIZON_MAX.
 * FXL_E_RANGE: a sine is out of range, or below the one before it.
 * With each of these statuses: nothing is changed but refused_calls. */
fxl_status fxl_attach_horizon(fxl_renderer *renderer, const fxl_horizon *horizon);

/* What functions of this header refuse: for fxl_explain. */
extern const char fxl_horizon_reasons[];

#ifdef __cplusplus
}
#endif

#endif

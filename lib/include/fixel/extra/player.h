/* SPDX-License-Identifier: MIT */
/* A viewer that walks about: speed, friction, turning, clamped coordinates
 * (Listing 65.3, UpdateViewPos). */
#ifndef FXL_PLAYER_H
#define FXL_PLAYER_H

#include "fixel/scene.h"

#ifdef __cplusplus
extern "C" {
#endif

/* One step of a walk, in this order:
 *   1. each pair of turning keys adds or subtracts gait->turn (angles wrap);
 *      keys of a pair held together cancel;
 *   2. speed += acceleration for forward, -= for back; held within speed_max;
 *   3. x += forward.x * speed, z += forward.z * speed, with the forward of the
 *      new angles; y stays, as if walking, so a viewer who looks up moves
 *      slower; each product rounded to nearest; each coordinate held within
 *      FXL_COORDINATE_MAX, which sets *clamped (may be null) and is counted;
 *   4. friction moves speed towards 0 and stops there.
 * Error of a step: at most 0.51 + |speed| * 2^-29 units of 1/65536 in x and z.
 * FXL_E_ARGUMENT, FXL_E_RANGE (unknown key bits, gait, speed or position out
 * of range): viewer untouched. */
fxl_status fxl_player_step(fxl_player *viewer, uint32_t keys, const fxl_motion_limits *limits,
                           bool *clamped);

#ifdef __cplusplus
}
#endif

#endif

/* SPDX-License-Identifier: MIT */
/* A player who walks about: speed, friction, turning, clamped coordinates (Listing 65.3,
 * UpdateViewPos). */
#ifndef FXL_PLAYER_H
#define FXL_PLAYER_H

#include "fixel/scene.h"

/* Moves a player by one step. keys is an OR of FXL_KEY_... The step has four parts, in this
 * order:
 *   1. Each pair of turning keys adds limits->turn to an angle or subtracts it. Angles wrap. The
 *      two keys of a pair, held together, cancel.
 *   2. speed += acceleration for forward, -= for back; speed is clamped to +-speed_max.
 *   3. x += forward.x * speed, z += forward.z * speed, with the forward of the new angles. y
 *      stays, as for someone walking; so a player who looks up or down moves slower. Each product
 *      is rounded to nearest. Each coordinate is clamped to +-FXL_COORDINATE_MAX. *clamped (which
 *      may be null) says whether that happened, and viewer->clamped counts it.
 *   4. Friction moves speed towards 0 and stops there.
 * Error of a step: at most 0.51 + |speed| * 2^-29 units of 1/65536 in x and z.
 * FXL_E_ARGUMENT (a null pointer), FXL_E_RANGE (unknown key bits; limits, speed or position out
 * of range): *viewer untouched. */
fxl_status fxl_player_step(fxl_player *viewer, uint32_t keys, const fxl_motion_limits *limits,
                           bool *clamped);

#endif

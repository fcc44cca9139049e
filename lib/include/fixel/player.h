/* SPDX-License-Identifier: MIT */
/* A player who walks or flies about: speed, friction, turning, clamped coordinates (Listing 65.3,
 * UpdateViewPos). And a pose that looks at a point. */
#ifndef FXL_PLAYER_H
#define FXL_PLAYER_H

#include "fixel/scene.h"

#ifdef __cplusplus
extern "C" {
#endif

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
 * FXL_E_ARGUMENT: a null pointer.
 * FXL_E_RANGE: unknown key bits; limits, speed or position out of range.
 * With each of these statuses: *viewer untouched. */
fxl_status fxl_player_step(fxl_player *viewer, uint32_t keys, const fxl_motion_limits *limits,
                           bool *clamped);

/* Moves a player by one step in the direction of the view: the same step, but that part 3 also does
 * y += forward.y * speed, rounded and clamped likewise. So a player who looks up rises, at full
 * speed. Error of a step: at most 0.51 + |speed| * 2^-29 units of 1/65536 in x, y and z.
 * FXL_E_ARGUMENT: a null pointer.
 * FXL_E_RANGE: unknown key bits; limits, speed or position out of range.
 * With each of these statuses: *viewer untouched. */
fxl_status fxl_player_fly(fxl_player *viewer, uint32_t keys, const fxl_motion_limits *limits,
                          bool *clamped);

/* Multiplies acceleration, friction and top speed by a factor: the speed factor of the chapter
 * (speedscale). `turn` is copied. *scaled may be *limits. Each product is rounded to the nearest
 * 1/65536, halves upward.
 * Requires a factor of 0..256 in 16.16.
 * FXL_E_ARGUMENT: a null pointer.
 * FXL_E_RANGE: the factor; limits out of range; a product above 256.
 * With each of these statuses: *scaled untouched.
 * Source: A5 (Listing 65.3). */
fxl_status fxl_scale_motion_limits(const fxl_motion_limits *limits, fxl_q16_16 factor,
                                   fxl_motion_limits *scaled);

/* Turns a pose so that it looks at a point: sets yaw and pitch. Position and roll stay. Where the
 * point is straight above or below the position, yaw stays too.
 * Error: at most 0.75 of 2^-32 turn in each angle.
 * FXL_E_ARGUMENT: a null pointer.
 * FXL_E_RANGE: the position or the point is outside of FXL_COORDINATE_MAX.
 * FXL_E_DEGENERATE: the point is the position.
 * With each of these statuses: *pose untouched. */
fxl_status fxl_pose_look_at(fxl_pose *pose, const fxl_point *target);

/* What functions of this header refuse: for fxl_explain. */
extern const char fxl_player_reasons[];

#ifdef __cplusplus
}
#endif

#endif

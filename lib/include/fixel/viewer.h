/* SPDX-License-Identifier: MIT */
/* A viewer that walks about: speed, friction, turning, clamped coordinates
 * (Listing 65.3, UpdateViewPos). */
#ifndef FXL_VIEWER_H
#define FXL_VIEWER_H

#include "fixel/record.h"
#include "fixel/status.h"

/* What a player holds down, as bits. */
enum {
    FXL_KEY_FORWARD = 1u << 0,
    FXL_KEY_BACK = 1u << 1,
    FXL_KEY_LEFT = 1u << 2,     /* yaw decreases */
    FXL_KEY_RIGHT = 1u << 3,    /* yaw increases */
    FXL_KEY_PITCH_UP = 1u << 4, /* pitch increases */
    FXL_KEY_PITCH_DOWN = 1u << 5,
    FXL_KEY_ROLL_LEFT = 1u << 6, /* roll increases: the right side rises */
    FXL_KEY_ROLL_RIGHT = 1u << 7,
    FXL_KEY_ALL = 0xFFu
};

/* How fast keys work, per step. */
typedef struct {
    fxl_q16_16 acceleration; /* world units per step per step, 0..256 */
    fxl_q16_16 friction;     /* the same, taken off the speed after moving, 0..256 */
    fxl_q16_16 speed_max;    /* world units per step, 0..256 */
    fxl_angle turn;          /* angle per step, at most a quarter turn */
} fxl_gait;

#define FXL_GAIT_MAX ((fxl_q16_16)(256 * 65536))

typedef struct {
    fxl_pose pose;
    fxl_q16_16 speed; /* along the view, negative is backward */
    uint32_t clamped; /* steps in which a coordinate was held at the range's end */
} fxl_viewer;

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
fxl_status fxl_viewer_step(fxl_viewer *viewer, uint32_t keys, const fxl_gait *gait, bool *clamped);

#endif

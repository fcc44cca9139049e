/* SPDX-License-Identifier: MIT */
/* The camera: three unit vectors from three angles. */
#ifndef FXL_CAMERA_H
#define FXL_CAMERA_H

#include "fixel/types.h"

#ifdef __cplusplus
extern "C" {
#endif

/* A rotation: its rows are the axes that it turns x, y and z of the view to. */
typedef struct {
    fxl_direction right, up, forward;
} fxl_axes;

/* The view matrix: the position of the eye, and the world-to-view rotation. */
typedef struct fxl_camera {
    fxl_point position;
    fxl_axes axes;
} fxl_camera;

/* Sets up a camera from a pose:
 *   forward = ( cos p sin y,  sin p, cos p cos y)
 *   right   = ( cos r cos y - sin r sin p sin y,  sin r cos p, -cos r sin y - sin r sin p cos y)
 *   up      = (-sin r cos y - cos r sin p sin y,  cos r cos p,  sin r sin y - cos r sin p cos y)
 * Requires |position| <= FXL_COORDINATE_MAX in each coordinate. Takes any angles.
 * FXL_E_ARGUMENT: a null pointer.
 * FXL_E_RANGE: a number is out of its range.
 * With each of these statuses: camera untouched.
 * Error: at most 2 units of 2^-30 an entry.
 * Source: Listing 65.3, UpdateViewPos. SPEC.md, section 1.4, says where sign and order of the
 * angles follow the Black Book's text and not its listing. */
fxl_status fxl_camera_from_pose(const fxl_pose *pose, fxl_camera *camera);

#ifdef __cplusplus
}
#endif

#endif

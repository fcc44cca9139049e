/* SPDX-License-Identifier: MIT */
/* In the place of lib/src/rotate.h: one copy, in look_at.c. */
#ifndef FXL_ROTATE_H
#define FXL_ROTATE_H

#include "fixel/camera.h"

void fxl_rotate(const fxl_camera *camera, const fxl_point *point, fxl_view_point *view);

#endif

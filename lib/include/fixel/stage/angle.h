/* SPDX-License-Identifier: MIT */
/* Sine and cosine of binary angles. */
#ifndef FXL_ANGLE_H
#define FXL_ANGLE_H

#include "fixel/types.h"

/* The sine of an angle, as 2.30. Takes any angle. sin(-a) == -sin(a) for every a.
 * Error: at most 0.51 unit of 2^-30; exact at the quarter turns. */
fxl_q2_30 fxl_sin(fxl_angle angle);

/* The cosine of an angle, as 2.30: fxl_sin(angle + FXL_ANGLE_QUARTER). Takes any angle.
 * Error: at most 0.51 unit of 2^-30; exact at the quarter turns. */
fxl_q2_30 fxl_cos(fxl_angle angle);

#endif

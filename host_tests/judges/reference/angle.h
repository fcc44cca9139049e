/* SPDX-License-Identifier: MIT */
/* Sine and cosine of binary angles, in double. */
#ifndef REF_ANGLE_H
#define REF_ANGLE_H

#include "reference/record.h"

/* Sine and cosine of an angle. Exact at the quarter turns, elsewhere good to about the last bit
 * of a double. */
double ref_sin(ref_angle angle);
double ref_cos(ref_angle angle);

/* Converts an angle to radians, 0 <= a < 2 pi. */
double ref_radians(ref_angle angle);

#endif

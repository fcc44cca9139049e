/* SPDX-License-Identifier: MIT */
/* Sine and cosine with more bits than 2.30, as sums of products need them. Internal. */
#ifndef FXL_SINE_H
#define FXL_SINE_H

#include "fixel/types.h"

/* Sine and cosine in units of 2^-31, so 1 is 2^31.
 * Error: at most 0.52 unit of 2^-31. */
int64_t fxl_sin_q31(fxl_angle angle);
int64_t fxl_cos_q31(fxl_angle angle);

#endif

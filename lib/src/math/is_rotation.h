/* SPDX-License-Identifier: MIT */
/* Whether the rows of an orientation are those of a rotation. Internal. */
#ifndef FXL_IS_ROTATION_H
#define FXL_IS_ROTATION_H

#include <stdbool.h>

#include "fixel/types.h"

/* The largest difference from 1 of a row's squared length, and the largest product of two rows, in
 * units of 2^-60: a length and a right angle within 2^-28. */
#define FXL_ROW_SQUARE_MAX_ERROR ((FXL_CAST(int64_t, 1) << 33) + 16)
#define FXL_ROW_ANGLE_MAX_ERROR  (FXL_CAST(int64_t, 1) << 32)

/* Whether every row has unit length to within 2^-28, every two rows are at right angles to within
 * 2^-28, and the orientation is no mirror. Exact. */
bool fxl_is_rotation(const fxl_orientation *orientation);

/* Whether a scale is in FXL_SCALE_MIN..FXL_SCALE_MAX. */
static inline bool fxl_is_scale(fxl_q16_16 scale)
{
    return scale >= FXL_SCALE_MIN && scale <= FXL_SCALE_MAX;
}

#endif

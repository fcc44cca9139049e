/* SPDX-License-Identifier: MIT */
/* The grid of pixel centres. Internal. */
#ifndef FXL_PIXEL_CENTRE_H
#define FXL_PIXEL_CENTRE_H

#include "fixel/types.h"

/* place fill-rule: the first row or column at or past a coordinate; the centre of a pixel */
#define FXL_HALF_PIXEL 32768

/* The first row (or column) whose centre is at or past a coordinate. Requires
 * |coordinate| < 2^30. */
/* SPEC 5.2 */
static inline int32_t fxl_first_centre_from(fxl_q16_16 coordinate)
{
    return (coordinate + FXL_HALF_PIXEL - 1) >> 16;
}

/* The coordinate of a row's (or column's) centre. fxl_first_centre_from(c) <= row if
 * c <= fxl_centre_of(row), and only then. Requires |row| < 2^14. */
/* SPEC 1.1 */
static inline fxl_q16_16 fxl_centre_of(int32_t row)
{
    return row * 65536 + FXL_HALF_PIXEL;
}

#endif

/* SPDX-License-Identifier: MIT */
/* The normal of two vectors. Internal. */
#ifndef FXL_UNIT_CROSS_H
#define FXL_UNIT_CROSS_H

#include "fixel/types.h"

/* *unit = a x b, scaled to unit length. Returns false, and leaves *unit, where the product is 0.
 * Requires components of at most 2^30. Error: 2.5 units of 2^-30 a component. */
bool fxl_unit_cross(const fxl_point *a, const fxl_point *b, fxl_direction *unit);

#endif

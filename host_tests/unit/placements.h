/* SPDX-License-Identifier: MIT */
/* Random placements. */
#ifndef PLACEMENTS_H
#define PLACEMENTS_H

#include "unit.h"

/* A random rotation: each entry is rounded to the nearest 2^-30. */
fxl_orientation placements_orientation(void);

/* A random placement; one in four has scale 1, and one in eight a scale at an end of the range. */
fxl_placement placements_any(void);

#endif

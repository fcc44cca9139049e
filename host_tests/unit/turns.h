/* SPDX-License-Identifier: MIT */
/* Random turns. */
#ifndef TURNS_H
#define TURNS_H

#include "unit.h"

/* A random rotation: each entry is rounded to the nearest 2^-30. */
fxl_orientation turns_orientation(void);

/* A random turn; one in four has scale 1, and one in eight a scale at an end of the range. */
fxl_placement turns_any(void);

#endif

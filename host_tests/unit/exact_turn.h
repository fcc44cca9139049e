/* SPDX-License-Identifier: MIT */
/* Rotations in long double, against which orientations are measured. */
#ifndef EXACT_TURN_H
#define EXACT_TURN_H

#include "unit.h"

#define EXACT_PI  3.14159265358979323846264338327950288L
#define EXACT_ONE ((long double)FXL_Q2_30_ONE)

typedef struct {
    long double at[3][3];
} exact_turn;

/* The entries of an orientation, row by row. */
void exact_entries(const fxl_orientation *o, fxl_q2_30 out[3][3]);

/* The largest difference of an entry, in units of 2^-30. */
long double exact_distance(const exact_turn *wanted, const fxl_orientation *actual);

/* What fxl_orientation_from_angles and fxl_orientation_from_axis write, without an error. */
exact_turn exact_angles(fxl_angle yaw, fxl_angle pitch, fxl_angle roll);
exact_turn exact_axis(fxl_point axis, fxl_angle angle);

/* b and then a. */
exact_turn exact_product(const exact_turn *a, const exact_turn *b);

#endif

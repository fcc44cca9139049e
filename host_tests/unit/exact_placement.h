/* SPDX-License-Identifier: MIT */
/* Rotations in long double, against which orientations are measured: by unit tests, and by the
 * oracle. */
#ifndef EXACT_PLACEMENT_H
#define EXACT_PLACEMENT_H

#include "fixel/orientation.h"

#define EXACT_PI  3.14159265358979323846264338327950288L
#define EXACT_ONE ((long double)FXL_Q2_30_ONE)

typedef struct {
    long double at[3][3];
} exact_placement;

/* The entries of an orientation, row by row. */
void exact_entries(const fxl_orientation *o, fxl_q2_30 out[3][3]);

/* The largest difference of an entry, in units of 2^-30. */
long double exact_distance(const exact_placement *wanted, const fxl_orientation *actual);

/* What fxl_orientation_from_angles and fxl_orientation_from_axis write, without an error. */
exact_placement exact_angles(fxl_angle yaw, fxl_angle pitch, fxl_angle roll);
exact_placement exact_axis(fxl_point axis, fxl_angle angle);

/* What fxl_orientation_look_at writes, without an error. */
exact_placement exact_look(fxl_point direction, fxl_point up);

/* The rotation that is nearest to a product of two stated orientations: b and then a. */
exact_placement exact_nearest_to_product(const fxl_orientation *a, const fxl_orientation *b);

/* A quaternion: w, x, y, z. */
typedef struct {
    long double at[4];
} exact_quaternion;

/* Hamilton's product: i j = k. */
exact_quaternion exact_hamilton(const exact_quaternion *a, const exact_quaternion *b);

/* The rotation that takes v to q v q*, divided by the norm. */
exact_placement exact_turn_of(const exact_quaternion *q);

/* The quaternion of unit length of a rotation that is within 0.1 of exact_turn_of(about). */
exact_quaternion exact_quaternion_of(const exact_placement *turn, const exact_quaternion *about);

/* A place in a chain of parents, without rounding. */
typedef struct {
    long double centre[3], scale; /* in units of 2^-16, and of 1 */
    exact_placement turn;
} exact_place;

exact_place exact_place_of(const fxl_point *centre, const fxl_placement *placement);

/* The place of a child whose place in its parent's model is stated. */
exact_place exact_attached(const exact_place *parent, const exact_place *child);

/* The bounds of docs/extras/orientation.md, section 3.2: g, f and e. All are 0 at depth 0. */
typedef struct {
    long double centre, scale, turn;
} exact_bounds;

/* The bounds of a child, from those of its parent. */
exact_bounds exact_bounds_of_child(const exact_bounds *of_parent, const exact_place *parent,
                                   const exact_place *child);

/* b and then a. */
exact_placement exact_product(const exact_placement *a, const exact_placement *b);

#endif

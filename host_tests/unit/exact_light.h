/* SPDX-License-Identifier: MIT */
/* The brightness of a face or a corner by its definition (docs/extras/light.md), and random
 * settings. */
#ifndef EXACT_LIGHT_H
#define EXACT_LIGHT_H

#include "unit.h"

typedef struct {
    double x, y, z;
} exact_vector;

/* A point, in units of unit. */
exact_vector exact_point(const fxl_point *point, double unit);

exact_vector exact_direction(const fxl_direction *direction);

double exact_dot(exact_vector a, exact_vector b);

exact_vector exact_minus(exact_vector a, exact_vector b);

/* The brightness at a place with a normal. */
double exact_brightness(const fxl_light_settings *of, const fxl_camera *camera, exact_vector middle,
                        exact_vector normal);

/* place light: definition: the unit tests */
/* Random settings, whose point lights are near and far of a point of the world. */
fxl_light_settings exact_light_any(const uint8_t *ramp, const fxl_point *about);

#endif

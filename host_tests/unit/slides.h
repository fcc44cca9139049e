/* SPDX-License-Identifier: MIT */
/* A sphere that slides among the cubes of a scene, at random. */
#ifndef SLIDES_H
#define SLIDES_H

#include "unit.h"

/* What happened, added up. */
typedef struct {
    uint32_t contacts;
    uint32_t slid; /* moves that were never blocked, of those with contacts */
} slide_counts;

/* Moves the sphere eight times. It is free after every move: not nearer to a cube than its radius,
 * but for so many units. A small move that meets nothing has no cube half-way either, and goes all
 * the way; a large one is cut into such moves. distance: from the nearest cube, 0 within. */
void slides_stay_free(const fxl_scene *scene, fxl_sphere *sphere,
                      double (*distance)(const fxl_point *point), fxl_q16_16 slack,
                      slide_counts *counts);

#endif

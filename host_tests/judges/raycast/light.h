/* SPDX-License-Identifier: MIT */
/* Light at run time (docs/extras/light.md): the colour of a face that a ray meets. */
#ifndef RAYCAST_LIGHT_H
#define RAYCAST_LIGHT_H

#include <stdint.h>

#include "vector.h"

/* Of an image; ramp is null where it has no light. */
typedef struct {
    const uint8_t *base, *points, *ramp;
    uint32_t point_count, levels;
} light_tables;

/* A face: its normal, and the middle of its bounding box along the axes of the model. */
typedef struct {
    vector normal, middle;
    uint8_t material;
} light_face;

/* The colour of a face for an eye that looks along forward. */
uint8_t light_colour(const light_tables *light, const light_face *face, vector eye, vector forward);

#endif

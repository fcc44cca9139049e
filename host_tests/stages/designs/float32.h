/* SPDX-License-Identifier: MIT */
/* Single precision as the design float32 has it. */
#ifndef DESIGNS_FLOAT32_H
#define DESIGNS_FLOAT32_H

#include "designs/design.h"

typedef struct {
    float x, y, z;
} vector;

static inline float q16(int32_t value)
{
    return (float)value * 0x1p-16f;
}

static inline float dot(const vector *a, const vector *b)
{
    return a->x * b->x + a->y * b->y + a->z * b->z;
}

static inline vector vector_of(const fxl_point *point)
{
    return (vector){q16(point->x), q16(point->y), q16(point->z)};
}

static inline vector row_of(const fxl_direction *row)
{
    return (vector){(float)row->x * 0x1p-30f, (float)row->y * 0x1p-30f, (float)row->z * 0x1p-30f};
}

typedef struct {
    float x, y;       /* on the screen, pixels */
    float z;          /* the depth */
    float reciprocal; /* 1 / z */
} float32_point;

static inline float32_point float32_project(const fxl_camera *camera, const fxl_lens *lens,
                                            const vector *point)
{
    vector eye = vector_of(&camera->position);
    vector from_eye = {point->x - eye.x, point->y - eye.y, point->z - eye.z};
    vector right = row_of(&camera->axes.right), up = row_of(&camera->axes.up);
    vector forward = row_of(&camera->axes.forward);
    float z = dot(&forward, &from_eye), reciprocal = 1.0f / z, focal = q16(lens->focal);
    float centre_x = (float)lens->width * 0.5f, centre_y = (float)lens->height * 0.5f;
    return (float32_point){dot(&right, &from_eye) * reciprocal * focal + centre_x,
                           centre_y - dot(&up, &from_eye) * reciprocal * focal, z, reciprocal};
}

#endif

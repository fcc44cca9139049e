/* SPDX-License-Identifier: MIT */
/* 16.16 as the naive design has it: what a product or a quotient leaves over is dropped. */
#ifndef DESIGNS_NAIVE_H
#define DESIGNS_NAIVE_H

#include "designs/design.h"

typedef int32_t fixed;

/* Kinder than the wrap of a real port. */
static inline fixed held(int64_t value)
{
    return (fixed)(value > INT32_MAX ? INT32_MAX : value < INT32_MIN ? INT32_MIN : value);
}

static inline fixed multiply(fixed a, fixed b)
{
    return held(((int64_t)a * b) >> 16);
}

static inline fixed divide(fixed a, fixed b)
{
    return b == 0 ? (a < 0 ? INT32_MIN : INT32_MAX) : held((int64_t)a * 65536 / b);
}

typedef struct {
    fixed x, y, z;
} vector;

static inline fixed dot(const vector *a, const vector *b)
{
    return held((int64_t)multiply(a->x, b->x) + multiply(a->y, b->y) + multiply(a->z, b->z));
}

static inline vector vector_of(const fxl_point *point)
{
    return (vector){point->x, point->y, point->z};
}

static inline vector row_of(const fxl_direction *row)
{
    return (vector){row->x >> 14, row->y >> 14, row->z >> 14};
}

typedef struct {
    fixed x, y;       /* on the screen, pixels */
    fixed z;          /* the depth */
    fixed reciprocal; /* 1 / z */
} naive_point;

/* TransformPoint and ProjectPolygon of Listing 65.3. */
static inline naive_point naive_project(const fxl_camera *camera, const fxl_lens *lens,
                                        const vector *point)
{
    vector eye = vector_of(&camera->position);
    vector from_eye = {held((int64_t)point->x - eye.x), held((int64_t)point->y - eye.y),
                       held((int64_t)point->z - eye.z)};
    vector right = row_of(&camera->axes.right), up = row_of(&camera->axes.up);
    vector forward = row_of(&camera->axes.forward);
    fixed z = dot(&forward, &from_eye), reciprocal = divide(65536, z);
    fixed x = multiply(multiply(dot(&right, &from_eye), reciprocal), lens->focal);
    fixed y = multiply(multiply(dot(&up, &from_eye), reciprocal), lens->focal);
    return (naive_point){held(lens->width * INT64_C(32768) + x),
                         held(lens->height * INT64_C(32768) - y), z, reciprocal};
}

#endif

/* SPDX-License-Identifier: MIT */
/* Vectors of three doubles. */
#ifndef RAYCAST_VECTOR_H
#define RAYCAST_VECTOR_H

typedef struct {
    double x, y, z;
} vector;

static inline vector vector_minus(vector a, vector b)
{
    return (vector){a.x - b.x, a.y - b.y, a.z - b.z};
}

static inline vector vector_plus(vector a, vector b)
{
    return (vector){a.x + b.x, a.y + b.y, a.z + b.z};
}

static inline vector vector_times(vector a, double factor)
{
    return (vector){a.x * factor, a.y * factor, a.z * factor};
}

static inline double vector_dot(vector a, vector b)
{
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

static inline vector vector_cross(vector a, vector b)
{
    return (vector){a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

#endif

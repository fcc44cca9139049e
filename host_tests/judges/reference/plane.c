/* SPDX-License-Identifier: MIT */
#include "reference/plane.h"

#include <math.h>

static long double dot(const ref_point *a, const ref_point *b)
{
    return (long double)a->x * b->x + (long double)a->y * b->y + (long double)a->z * b->z;
}

ref_plane ref_plane_from_point(const ref_point *point, const ref_point *normal, double inset)
{
    return (ref_plane){.normal = *normal, .distance = dot(normal, point) + inset};
}

long double ref_plane_distance(const ref_plane *plane, const ref_point *point)
{
    return dot(&plane->normal, point) - plane->distance;
}

/* The products of whole numbers of 1/65536 unit have 60 bits, so they and their differences are
 * exact in 64. */
bool ref_plane_from_points(const ref_point *a, const ref_point *b, const ref_point *c,
                           ref_plane *plane)
{
    const long double ux = b->x - a->x, uy = b->y - a->y, uz = b->z - a->z;
    const long double vx = c->x - a->x, vy = c->y - a->y, vz = c->z - a->z;
    const long double x = uy * vz - uz * vy, y = uz * vx - ux * vz, z = ux * vy - uy * vx;
    const long double length = sqrtl(x * x + y * y + z * z);
    if (length == 0) {
        return false;
    }
    const ref_point normal = {(double)(x / length), (double)(y / length), (double)(z / length)};
    *plane = ref_plane_from_point(a, &normal, 0);
    return true;
}

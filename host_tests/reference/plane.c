/* SPDX-License-Identifier: MIT */
#include "reference/plane.h"

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

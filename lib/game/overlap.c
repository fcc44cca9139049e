/* SPDX-License-Identifier: MIT */
#include "exact.h"

/* The sum of the radii is below 2^32, so its square is below 2^64. */
bool fxl_spheres_overlap(const fxl_sphere *a, const fxl_sphere *b)
{
    fxl_point between;
    const uint32_t reach = (uint32_t)a->radius + (uint32_t)b->radius;
    fxl_subtract(&a->centre, &b->centre, &between);
    return fxl_square_of(&between) <= fxl_multiply_u32(reach, reach);
}

bool fxl_boxes_overlap(const fxl_box *a, const fxl_box *b)
{
    return a->least.x <= b->most.x && b->least.x <= a->most.x && a->least.y <= b->most.y &&
           b->least.y <= a->most.y && a->least.z <= b->most.z && b->least.z <= a->most.z;
}

/* From the nearest number of least..most. */
static int32_t off(int32_t value, int32_t least, int32_t most)
{
    return value < least ? value - least : value > most ? value - most : 0;
}

bool fxl_sphere_meets_box(const fxl_sphere *sphere, const fxl_box *box)
{
    const fxl_point *centre = &sphere->centre, *least = &box->least, *most = &box->most;
    const fxl_point between = {off(centre->x, least->x, most->x), off(centre->y, least->y, most->y),
                               off(centre->z, least->z, most->z)};
    return fxl_square_of(&between) <= (uint64_t)fxl_multiply_s32(sphere->radius, sphere->radius);
}

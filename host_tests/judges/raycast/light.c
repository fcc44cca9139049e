/* SPDX-License-Identifier: MIT */
#include "light.h"

#include <math.h>

#include "file.h"

enum {
    POINT = 20
};

static double part(const uint8_t *at)
{
    return get_i32(at) / 1073741824.0;
}

static double length(const uint8_t *at)
{
    return get_i32(at) / 65536.0;
}

static double of_point(const uint8_t *point, const light_face *face)
{
    const vector at = {length(point), length(point + 4), length(point + 8)};
    const vector way = vector_minus(at, face->middle);
    const double reach = length(point + 12), away = sqrt(vector_dot(way, way));
    const double facing = vector_dot(way, face->normal);
    return away > 0 && away < reach && facing > 0
               ? part(point + 16) * facing / away * (1 - away * away / (reach * reach))
               : 0;
}

/* place light: definition: the ray-cast oracle */
/* place light: a new setting: the ray-cast oracle's reader */
uint8_t light_colour(const light_tables *light, const light_face *face, vector eye, vector forward)
{
    const uint8_t *base = light->base;
    const vector way = {part(base + 8), part(base + 12), part(base + 16)};
    const double fog_near = length(base + 20), fog_far = length(base + 24);
    double bright = part(base) + part(base + 4) * fmax(-vector_dot(way, face->normal), 0);
    for (uint32_t i = 0; i < light->point_count; i++)
        bright += of_point(light->points + (size_t)POINT * i, face);
    bright = fmin(bright, 1);
    if (fog_far > 0) {
        const double depth = vector_dot(forward, vector_minus(face->middle, eye));
        bright *= fmin(1, fmax(0, (fog_far - depth) / (fog_far - fog_near)));
    }
    const uint32_t level = (uint32_t)(bright * (light->levels - 1) + 0.5);
    return light->ramp[256 * level + face->material];
}

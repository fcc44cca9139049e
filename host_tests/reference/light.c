/* SPDX-License-Identifier: MIT */
#include "reference/light.h"

#include <math.h>

static double dot(ref_point a, ref_point b)
{
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

static ref_point from_to(ref_point a, ref_point b)
{
    return (ref_point){b.x - a.x, b.y - a.y, b.z - a.z};
}

void ref_light_make_ramp(ref_light *light, const uint8_t *palette, const uint8_t *dark)
{
    for (int level = 0; level < light->levels; level++) {
        for (int colour = 0; colour < 256; colour++) {
            double least = INFINITY;
            int best = colour;
            for (int entry = 0; entry < 256 && level < light->levels - 1; entry++) {
                double distance = 0;
                for (int k = 0; k < 3; k++) {
                    double wanted = floor(dark[k] +
                                          (palette[3 * colour + k] - dark[k]) * (double)level /
                                              (light->levels - 1) +
                                          0.5);
                    distance +=
                        (palette[3 * entry + k] - wanted) * (palette[3 * entry + k] - wanted);
                }
                if (distance < least) {
                    least = distance;
                    best = entry;
                }
            }
            light->ramp[level][colour] = (uint8_t)best;
        }
    }
}

/* The middle of the bounding box of a face in the world. */
static ref_point middle_of(const ref_scene *scene, const ref_instance *instance,
                           const ref_face *face)
{
    ref_point low = {INFINITY, INFINITY, INFINITY}, high = {-INFINITY, -INFINITY, -INFINITY};
    for (int i = 0; i < face->count; i++) {
        const ref_lattice_point corner = ref_face_vertex(scene, instance, face, i);
        const ref_point at = ref_point_from_lattice(&corner);
        low = (ref_point){fmin(low.x, at.x), fmin(low.y, at.y), fmin(low.z, at.z)};
        high = (ref_point){fmax(high.x, at.x), fmax(high.y, at.y), fmax(high.z, at.z)};
    }
    return (ref_point){(low.x + high.x) / 2, (low.y + high.y) / 2, (low.z + high.z) / 2};
}

static double from_point(const ref_point_light *light, ref_point middle, ref_point normal)
{
    const ref_point to = from_to(middle, light->position);
    const double distance = sqrt(dot(to, to));
    if (distance == 0 || distance >= light->range) {
        return 0;
    }
    return light->strength * fmax(0, dot(normal, to) / distance) *
           (1 - (distance / light->range) * (distance / light->range));
}

static double brightness(const ref_light *light, const ref_camera *camera, ref_point middle,
                         ref_point normal)
{
    double sum = light->ambient + light->strength * fmax(0, -dot(normal, light->direction));
    for (int i = 0; i < light->point_count; i++) {
        sum += from_point(&light->points[i], middle, normal);
    }
    sum = fmin(sum, 1);
    if (light->fog_far != 0) {
        const double depth = dot(from_to(camera->position, middle), camera->forward);
        const double left = (light->fog_far - depth) / (light->fog_far - light->fog_near);
        sum *= fmin(fmax(left, 0), 1);
    }
    return sum;
}

uint8_t ref_light_colour(const ref_light *light, const ref_camera *camera, const ref_scene *scene,
                         const ref_instance *instance, const ref_face *face)
{
    const ref_point normal = {ldexp(face->normal[0], -30), ldexp(face->normal[1], -30),
                              ldexp(face->normal[2], -30)};
    const double exact =
        brightness(light, camera, middle_of(scene, instance, face), normal) * (light->levels - 1);
    return light->ramp[(int)floor(exact + 0.5)][face->material];
}

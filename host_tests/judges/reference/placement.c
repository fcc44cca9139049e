/* SPDX-License-Identifier: MIT */
#include "reference/placement.h"

#include <math.h>

const ref_placement *ref_placement_of(const ref_scene *scene, const ref_instance *instance)
{
    const uint32_t number = (uint32_t)(instance - scene->instances);
    return scene->placements && number >= scene->first_turned
               ? &scene->placements[number - scene->first_turned]
               : NULL;
}

int64_t ref_placement_radius(const ref_placement *placement, int32_t radius)
{
    return ((int64_t)radius * placement->scale + 65535) / 65536 + REF_PLACEMENT_SLACK;
}

int32_t ref_instance_radius(const ref_scene *scene, const ref_instance *instance)
{
    const ref_placement *placement = ref_placement_of(scene, instance);
    const int32_t radius = scene->models[instance->model].radius;
    return placement ? (int32_t)ref_placement_radius(placement, radius) : radius;
}

/* floor(value / divisor); divisor > 0. */
static ref_exact divide_down(ref_exact value, ref_exact divisor)
{
    const ref_exact quotient = value / divisor;
    return quotient - (value % divisor < 0);
}

/* floor(value / divisor + 1/2), for an even divisor. */
static ref_exact divide_round(ref_exact value, ref_exact divisor)
{
    return divide_down(value + divisor / 2, divisor);
}

static ref_exact sum_of(const int32_t row[3], const int32_t v[3])
{
    return (ref_exact)row[0] * v[0] + (ref_exact)row[1] * v[1] + (ref_exact)row[2] * v[2];
}

ref_point ref_placement_point(const ref_placement *placement, const ref_lattice_point *centre,
                              const ref_lattice_point *vertex)
{
    const int32_t v[3] = {vertex->x, vertex->y, vertex->z};
    const int32_t c[3] = {centre->x, centre->y, centre->z};
    double at[3];
    for (int i = 0; i < 3; i++) {
        /* In units of 2^-62; below 2^76, of which a long double keeps the 64 highest bits. */
        at[i] = (double)((long double)(sum_of(placement->rows[i], v) * placement->scale +
                                       ((ref_exact)c[i] << 46)) *
                         0x1p-62L);
    }
    return (ref_point){at[0], at[1], at[2]};
}

ref_lattice_point ref_placement_rounded(const ref_placement *placement,
                                        const ref_lattice_point *centre,
                                        const ref_lattice_point *vertex)
{
    const int32_t v[3] = {vertex->x, vertex->y, vertex->z};
    int32_t at[3];
    for (int i = 0; i < 3; i++) {
        at[i] = (int32_t)divide_round(sum_of(placement->rows[i], v) * placement->scale,
                                      (ref_exact)1 << 46);
    }
    return (ref_lattice_point){centre->x + at[0], centre->y + at[1], centre->z + at[2]};
}

void ref_placement_normal(const ref_placement *placement, const int32_t normal[3],
                          int32_t turned[3])
{
    for (int i = 0; i < 3; i++) {
        turned[i] = (int32_t)divide_round(sum_of(placement->rows[i], normal), (ref_exact)1 << 30);
    }
}

void ref_direction_in_model(const ref_scene *scene, const ref_instance *instance,
                            const int32_t direction[3], int32_t in_model[3])
{
    const ref_placement *placement = ref_placement_of(scene, instance);
    for (int i = 0; i < 3; i++) {
        in_model[i] = direction[i];
        if (placement) {
            const int32_t column[3] = {placement->rows[0][i], placement->rows[1][i],
                                       placement->rows[2][i]};
            in_model[i] = (int32_t)divide_round(sum_of(column, direction), (ref_exact)1 << 30);
        }
    }
}

/* The transpose of the orientation times the eye less the centre, in units of 2^-46. */
static ref_exact eye_along(const ref_placement *placement, const ref_lattice_point *centre,
                           const ref_lattice_point *eye, int axis)
{
    return (ref_exact)placement->rows[0][axis] * ((int64_t)eye->x - centre->x) +
           (ref_exact)placement->rows[1][axis] * ((int64_t)eye->y - centre->y) +
           (ref_exact)placement->rows[2][axis] * ((int64_t)eye->z - centre->z);
}

/* Both sides in units of 2^-76. */
bool ref_placement_is_front(const ref_placement *placement, const ref_lattice_point *centre,
                            const ref_lattice_point *eye, const int32_t normal[3],
                            const ref_lattice_point *vertex)
{
    const int32_t v[3] = {vertex->x, vertex->y, vertex->z};
    ref_exact side = -(sum_of(normal, v) * placement->scale * ((ref_exact)1 << 14));
    for (int i = 0; i < 3; i++) {
        side += normal[i] * eye_along(placement, centre, eye, i);
    }
    return side > 0;
}

int ref_placement_eye(const ref_placement *placement, const ref_lattice_point *centre,
                      const ref_lattice_point *eye, int32_t radius, ref_lattice_point *in_model)
{
    for (int shift = 0;; shift++) {
        ref_exact at[3];
        bool fits = true;
        for (int i = 0; i < 3; i++) {
            at[i] = divide_round(eye_along(placement, centre, eye, i),
                                 (ref_exact)placement->scale << (14 + shift));
            const ref_exact size = at[i] < 0 ? -at[i] : at[i];
            fits = fits && size + (radius >> shift) < (ref_exact)1 << 30;
        }
        if (fits) {
            *in_model = (ref_lattice_point){(int32_t)at[0], (int32_t)at[1], (int32_t)at[2]};
            return shift;
        }
    }
}

double ref_placement_depth_bound(const ref_scene *scene, const ref_instance *instance)
{
    const ref_placement *placement = ref_placement_of(scene, instance);
    const double root_3 = 1.7320508075688772; /* |x| + |y| + |z| of a unit vector, at most */
    if (!placement) {
        return 0;
    }
    int shift = 0;
    while (65536 << shift < placement->scale) {
        shift++;
    }
    const double radius = scene->models[instance->model].radius / REF_ONE;
    return root_3 * radius * (ldexp(1, shift - 31) + 2 * 0x2p-30 * placement->scale / REF_ONE);
}

/* SPDX-License-Identifier: MIT */
/* Formulas of equations.smt2 and roundings.gappa beside the functions that they were written from, as in math/formulas.c. */
#include "clip/clip_view.c"
#include "clip/intersection.c"
#include "clip/volume.c"
#include "math/arith.c"

#include <fenv.h>

#include "enumeration.h"
#include "formula.h"

#define COORDINATE_MAX (((int64_t)1 << 61) - 1)

/* Of coordinates: the upper word, and the lower one. */
static wide upper_of(int64_t value)
{
    return floor_of(value, (wide)1 << 32);
}

static wide lower_of(int64_t value)
{
    return floor_rest(value, (wide)1 << 32);
}

/* [[row]]
 * id = "fxl_half_space_distance beside its formula"
 * function = "lib/clip/volume.c:fxl_half_space_distance"
 * property = "the formula's sum, which is the floor of the whole one, of a million planes and points"
 * checks = 1000000
 * formula = "fxl_half_space_distance exact"
 */
void enumerate_distance(void)
{
    for (uint32_t i = 0; i < SAMPLES; i++) {
        const int64_t most_b = INT32_MAX, a = between(most_b), b = between(most_b - llabs(a)), c = between(most_b - llabs(a) - llabs(b));
        const int64_t x = between(COORDINATE_MAX), y = between(COORDINATE_MAX), z = between(COORDINATE_MAX), offset = between((int64_t)1 << 61);
        const fxl_half_space plane = {{(int32_t)a, (int32_t)b, (int32_t)c}, offset};
        const fxl_view_point point = {x, y, z};
        const wide hx = upper_of(x), lx = lower_of(x), hy = upper_of(y), ly = lower_of(y), hz = upper_of(z), lz = lower_of(z);
        TRY(i, fxl_half_space_distance(&plane, &point) == distance_result + offset && distance_result == floor_of(distance_sum, distance_R));
    }
}

/* [[row]]
 * id = "fxl_intersection_screen beside its formula"
 * function = "lib/clip/intersection.h:fxl_intersection_screen"
 * property = "the formula's quotient, of a million edges"
 * checks = 1000000
 * formula = "fxl_intersection_screen bound"
 */
void enumerate_screen(void)
{
    for (uint32_t i = 0; i < SAMPLES; i++) {
        const int32_t from = (int32_t)between(536739840 / 2), to = (int32_t)between(536739840 / 2);
        const wide e = to - from, w = (wide)up_to(536870911 - 1) + 1, inside = (wide)up_to((uint64_t)w - 1);
        {
            const wide i = inside, p = screen_product;
            TRY(i, screen_contract && fxl_intersection_screen(from, to, (int64_t)inside, (int64_t)(inside - w)) == from + screen_quotient);
        }
    }
}

/* [[row]]
 * id = "project_onto beside its formula"
 * function = "lib/clip/clip_view.c:project_onto"
 * property = "the formula's sum, which is the floor of the whole one, of a million points"
 * checks = 1000000
 * formula = "project_onto exact"
 */
void enumerate_onto(void)
{
    for (uint32_t i = 0; i < SAMPLES; i++) {
        const wide s = (wide)up_to(1 << 30), d = (wide)up_to((uint64_t)(s > 1 << 29 ? 1610612736 - s : 1 << 30));
        const int64_t across = between(COORDINATE_MAX), along = between(COORDINATE_MAX);
        const wide ah = upper_of(across), al = lower_of(across), bh = upper_of(along), bl = lower_of(along);
        HOLDS(i, onto_contract && onto_across == across && onto_along == along);
        TRY(i, project_onto((int32_t)s, across, (int32_t)d, along) == onto_result && onto_result == floor_of(s * across + d * along, (wide)1 << 30));
    }
}

/* [[row]]
 * id = "fxl_intersect_edge beside its formula"
 * function = "lib/clip/intersection.c:fxl_intersect_edge"
 * property = "each coordinate is the formula's, which is as near as it claims, of a million edges"
 * checks = 1000000
 * formula = "intersection by Gappa"
 */
/* [[row]]
 * id = "interpolate beside its formula"
 * function = "lib/clip/intersection.c:interpolate"
 * property = "the same"
 * checks = 1000000
 * formula = "intersection by Gappa"
 */
/* A product has up to 126 bits, of which a real has 113: cut off, they have the floor of all. */
void enumerate_edge(void)
{
    fesetround(FE_TOWARDZERO);
    for (uint32_t i = 0; i < SAMPLES; i++) {
        const int64_t from[3] = {between(COORDINATE_MAX), between(COORDINATE_MAX), between(COORDINATE_MAX)};
        const int64_t to[3] = {between(COORDINATE_MAX), between(COORDINATE_MAX), between(COORDINATE_MAX)};
        const int64_t inside = (int64_t)up_to((uint64_t)INT64_MAX - 2) + 1, outside = -(int64_t)up_to((uint64_t)(INT64_MAX - inside - 1)) - 1;
        const fxl_view_point first = {from[0], from[1], from[2]}, last = {to[0], to[1], to[2]};
        fxl_view_point point = {0, 0, 0};
        fxl_intersect_edge(&first, &last, &inside, &outside, &point);
        const int64_t found[3] = {point.x, point.y, point.z};
        /* The quotient, to 2^-48: a real holds no more. */
        const wide_unsigned whole = (wide_unsigned)((wide)inside - outside), part = (wide_unsigned)inside << 64;
        const real exact = (real)(wide)(part / whole) + (real)(wide)((part % whole << 48) / whole) * 0x1p-48Q;
        for (int j = 0; j < 3; j++) {
            const real extent = (real)((wide)(to[j] < from[j] ? from[j] : to[j]) - (to[j] < from[j] ? to[j] : from[j]));
            HOLDS(i, edge_assumed && edge_holds && found[j] == (to[j] < from[j] ? from[j] - edge_part : from[j] + edge_part));
        }
        tried += 1;
    }
}

/* SPDX-License-Identifier: MIT */
#include "arith.h"
#include "plane.h"

fxl_plane fxl_plane_from_point(const fxl_point *point, const fxl_direction *normal,
                               fxl_q16_16 inset)
{
    FXL_ASSERT(fxl_point_in_range(point) && inset >= 0 && inset <= FXL_INSET_MAX);
    fxl_plane plane;
    plane.normal = *normal;
    /* The sum is below 2^61 (fxl_dot), the product of the inset below 2^47. */
    plane.distance = fxl_dot(normal, point->x, point->y, point->z) + (int64_t)inset * FXL_Q2_30_ONE;
    return plane;
}

fxl_q18_46 fxl_plane_distance(const fxl_plane *plane, const fxl_point *point)
{
    FXL_ASSERT(fxl_point_in_range(point));
    /* The sum is below 2^61. The plane's distance is below 2^61 for a point in range,
     * plus 2^61 for near or far. So the difference is below 2^63. */
    return fxl_dot(&plane->normal, point->x, point->y, point->z) - plane->distance;
}

/* A vector whose components are differences of two products below 2^60 each: below 2^61. */
typedef struct {
    int64_t x, y, z;
} wide_vector;

/* The cross product of a and b; |a|, |b| <= 2^30 a component. */
static wide_vector cross(const fxl_point *a, const fxl_point *b)
{
    wide_vector c = {fxl_multiply_s32(a->y, b->z) - fxl_multiply_s32(a->z, b->y),
                     fxl_multiply_s32(a->z, b->x) - fxl_multiply_s32(a->x, b->z),
                     fxl_multiply_s32(a->x, b->y) - fxl_multiply_s32(a->y, b->x)};
    return c;
}

/* value * 2^up where up >= 0, else value / 2^-up, to the nearest. */
static int64_t shifted(int64_t value, int up)
    FXL_REQUIRES(up >= -32 && up <= 29 && FXL_BELOW(value, (int64_t)1 << 61))
    FXL_REQUIRES(fxl_magnitude(value) <= (uint64_t)1 << (30 - up)) FXL_ASSIGNS()
    FXL_ENSURES(FXL_BELOW(FXL_RESULT, (int64_t)1 << 30) && (FXL_RESULT != 0 || fxl_magnitude(value) >> (29 - up) == 0))
{
    return up >= 0 ? value * ((int64_t)1 << up) : fxl_round_shift(value, (unsigned)-up);
}

/* Scales a vector to unit length; false for the zero vector. The longest component is brought to
 * 30 bits, which loses at most half a unit of 2^-30 of direction. Twice the length's square is
 * below 4 * 3 * 2^60 < 2^64. The root, of twice the length, is good to half a unit of at least
 * 2^30, and each quotient to half a unit of 2^-30. */
static bool normalise(const wide_vector *v, fxl_direction *unit)
    FXL_REQUIRES(FXL_OBJECT(v) && FXL_OBJECT(unit) && FXL_BELOW(v->x, (int64_t)1 << 61))
    FXL_REQUIRES(FXL_BELOW(v->y, (int64_t)1 << 61) && FXL_BELOW(v->z, (int64_t)1 << 61))
    FXL_ASSIGNS(*unit) FXL_EQUATES(!FXL_RESULT || FXL_DIRECTION(unit))
{
    unsigned bits = fxl_bit_length(fxl_magnitude(v->x) | fxl_magnitude(v->y) | fxl_magnitude(v->z));
    if (bits == 0) {
        return false;
    }
    int up = 30 - (int)bits;
    int64_t x = shifted(v->x, up), y = shifted(v->y, up), z = shifted(v->z, up);
    uint64_t square = (uint64_t)(x * x) + (uint64_t)(y * y) + (uint64_t)(z * z);
    uint32_t twice = fxl_square_root(4 * square);
    FXL_LEMMA(twice >= 2 * fxl_magnitude(x) && twice >= 2 * fxl_magnitude(y) &&
              twice >= 2 * fxl_magnitude(z));
    /* |x| <= 2^30, so the numerators are at most 2^61. */
    unit->x = fxl_divide_round(x * ((int64_t)1 << 31), twice);
    unit->y = fxl_divide_round(y * ((int64_t)1 << 31), twice);
    unit->z = fxl_divide_round(z * ((int64_t)1 << 31), twice);
    return true;
}

bool fxl_unit_cross(const fxl_point *a, const fxl_point *b, fxl_direction *unit)
{
    const wide_vector normal = cross(a, b);
    return normalise(&normal, unit);
}

/* clippers 3.4 */
fxl_status fxl_plane_from_points(const fxl_point *a, const fxl_point *b, const fxl_point *c,
                                 fxl_plane *plane)
{
    if (a == NULL || b == NULL || c == NULL || plane == NULL) {
        return FXL_E_ARGUMENT;
    }
    if (!fxl_point_in_range(a) || !fxl_point_in_range(b) || !fxl_point_in_range(c)) {
        return FXL_E_RANGE;
    }
    fxl_point to_b, to_c;
    fxl_direction normal;
    fxl_subtract(b, a, &to_b);
    fxl_subtract(c, a, &to_c);
    if (!fxl_unit_cross(&to_b, &to_c, &normal)) {
        return FXL_E_DEGENERATE;
    }
    *plane = fxl_plane_from_point(a, &normal, 0);
    return FXL_OK;
}

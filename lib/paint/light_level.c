/* SPDX-License-Identifier: MIT */
/* Errors are in units of 2^-30. Products are rounded down. A normal is within 2^-27 of unit length,
 * or within 2^-29 where its instance has no placement; that is its own, and no error. */
#include "../math/arith.h"
#include "rgb565_colour.h"
#include "../math/plane.h"
#include "fixel/light.h"
#include "light_level.h"

/* a * b, for 0 <= a, b <= 2^30 + 2^3. The product is below 2^61. Error: less than 1. */
static int64_t fraction_of(int64_t a, int64_t b)
{
    return (a * b) >> 30;
}

/* The light that travels along the direction. Both vectors are below 1 + 2^-26, so the sum is below
 * 2^61. Errors: the sum's shift 1, the product's 1. */
static int64_t from_direction(const fxl_light_settings *settings, const fxl_direction *normal)
{
    const fxl_direction *direction = &settings->direction;
    const int64_t facing = -((int64_t)normal->x * direction->x + (int64_t)normal->y * direction->y +
                             (int64_t)normal->z * direction->z);
    return facing > 0 ? fraction_of(settings->strength, facing >> 30) : 0;
}

/* The cosine between a normal and a vector to a light; dot is their product, above 0. The square is
 * that of the vector, below 2^60; it is scaled to 2^60..2^62, so its root is 2^30..2^31, with an
 * error of half a unit, which is half a unit of 2^-30 of the cosine. dot is at most the length
 * times (1 + 2^-26) * 2^30, so the scaled dot is below 2^62 and the quotient below 2^31. Errors:
 * the root's 1/2, the quotient's 1. */
static int64_t cosine(int64_t dot, uint64_t square)
{
    const unsigned shift = (62u - fxl_bit_length(square)) & ~1u;
    return fxl_divide_down(dot << (shift / 2), fxl_square_root(square << shift));
}

/* 1 - square / range_square, of 0 < square < range_square <= 2^60. Where both have more than 32
 * bits, their lower ones are cut off: the divisor has 32 bits left, so each of the two cuts moves
 * the quotient by less than 2^-31. Errors: 1 of the cuts, 1 of the quotient. */
static int64_t fading(uint64_t square, uint64_t range_square)
{
    const unsigned bits = fxl_bit_length(range_square);
    const unsigned shift = bits > 32 ? bits - 32 : 0;
    uint64_t numerator = (range_square - square) >> shift;
    const uint32_t divisor = (uint32_t)(range_square >> shift);
    if (numerator >= divisor) {
        return FXL_Q2_30_ONE;
    }
    /* Below 2^62. */
    return fxl_divide_down((int64_t)(numerator << 30), divisor);
}

/* A light at a point. Its place and the face's are doubled. Both are below 2^30 + 2, so differences
 * are below 2^31 + 2. The caller has taken those of 2^30 or more out of the way: then squares are
 * below 2^60, and a sum that is less than range_square too. Errors: cosine 1.5, fading 2, two
 * products 2. */
static int64_t from_point(const fxl_point_light *light, const fxl_lit_place *place)
{
    const int64_t x = 2 * (int64_t)light->position.x - place->middle.x;
    const int64_t y = 2 * (int64_t)light->position.y - place->middle.y;
    const int64_t z = 2 * (int64_t)light->position.z - place->middle.z;
    const int64_t range = 2 * (int64_t)light->range; /* below 2^30 */
    if (!fxl_within(x, range) || !fxl_within(y, range) || !fxl_within(z, range)) {
        return 0;
    }
    const uint64_t square = (uint64_t)(x * x) + (uint64_t)(y * y) + (uint64_t)(z * z);
    const uint64_t range_square = (uint64_t)(range * range);
    const fxl_direction *normal = &place->normal;
    /* Below sqrt(3) * 2^30 * 2^30 * (1 + 2^-26). */
    const int64_t dot = normal->x * x + normal->y * y + normal->z * z;
    if (square >= range_square || dot <= 0) {
        return 0;
    }
    return fraction_of(fraction_of(light->strength, cosine(dot, square)),
                       fading(square, range_square));
}

/* What fog leaves of the light: 1 before fog_near, 0 beyond fog_far. Coordinates of the face's
 * middle from the eye, doubled, are below 2^31 + 2, so the depth is below 2^62. Error: 1. */
static int64_t through_fog(const fxl_light_settings *settings, const fxl_camera *camera,
                           const fxl_point *middle)
{
    const fxl_direction *forward = &camera->axes.forward;
    const int64_t x = middle->x - 2 * (int64_t)camera->position.x;
    const int64_t y = middle->y - 2 * (int64_t)camera->position.y;
    const int64_t z = middle->z - 2 * (int64_t)camera->position.z;
    const int64_t depth = forward->x * x + forward->y * y + forward->z * z;       /* in 2^-47 */
    const int64_t length = 2 * ((int64_t)settings->fog_far - settings->fog_near); /* below 2^32 */
    /* Below 2^32 * 2^30. */
    const int64_t left = 2 * (int64_t)settings->fog_far * FXL_Q2_30_ONE - depth;
    if (left <= 0) {
        return 0;
    }
    return left >= length * FXL_Q2_30_ONE ? FXL_Q2_30_ONE : fxl_divide_down(left, (uint32_t)length);
}

/* Errors: of the directional light 2, of four points 4 * 5.5, of the fog 1, of its product 1. Where
 * the instance has a placement, its normal is rounded by 1 a component, and its middle by 2 units
 * of 2^-17, which fxl_lit_place is; so these are no errors of this function. */
fxl_q2_30 fxl_light_brightness(const fxl_light_settings *settings, const fxl_camera *camera,
                               const fxl_lit_place *place)
{
    int64_t sum = settings->ambient;
    if (settings->strength != 0) {
        sum += from_direction(settings, &place->normal);
    }
    for (uint32_t i = 0; i < settings->point_count; i++) {
        sum += from_point(&settings->points[i], place);
    }
    if (sum > FXL_Q2_30_ONE) {
        sum = FXL_Q2_30_ONE;
    }
    if (settings->fog_far != 0) {
        sum = fraction_of(sum, through_fog(settings, camera, &place->middle));
    }
    return (fxl_q2_30)sum;
}

/* The ramp of a palette. A program that has its ramp in flash does not call it. */
fxl_status fxl_light_make_ramp(const uint8_t *palette, const uint8_t *dark, uint32_t levels,
                               uint8_t *ramp)
{
    if (palette == NULL || dark == NULL || ramp == NULL) {
        return FXL_E_ARGUMENT;
    }
    if (levels < FXL_LIGHT_LEVELS_MIN || levels > FXL_LIGHT_LEVELS_MAX) {
        return FXL_E_COUNT;
    }
    const int32_t top = (int32_t)levels - 1;
    for (uint32_t i = 0; i < 256; i++) {
        for (int32_t level = 0; level < top; level++) {
            ramp[256 * (uint32_t)level + i] =
                fxl_mix_colours(palette, dark, &palette[3 * i], level, top);
        }
        ramp[256 * (uint32_t)top + i] = (uint8_t)i;
    }
    return FXL_OK;
}

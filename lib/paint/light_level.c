/* SPDX-License-Identifier: MIT */
/* Errors are in units of 2^-30. Products are rounded down. A normal is within 2^-27 of unit length,
 * or within 2^-29 where its instance has no placement; that is its own, and no error. */
#include "../math/family.h"
#include "../math/product.h"
#include "rgb565_colour.h"
#include "../math/plane.h"
#include "fixel/light.h"
#include "light_level.h"

/* a * b, for a, b <= 2^30 + 2^3. Error: less than 1. */
static inline uint32_t fraction_of(uint32_t a, uint32_t b)
{
    return (uint32_t)(fxl_product_unsigned(a, b) >> 30);
}

/* A sum of brightness, held to 1. */
/* light 2.4 */
static inline uint32_t sum_of(uint32_t a, uint32_t b)
{
    const uint32_t sum = a + b;
    return sum > FXL_Q2_30_ONE ? FXL_Q2_30_ONE : sum;
}

/* The light that travels along the direction. Both vectors are below 1 + 2^-26, so the sum is below
 * 2^61. Errors: the sum's shift 1, the product's 1. */
/* light 2.2 */
static FXL_ONE_COPY uint32_t from_direction(const fxl_direction *direction, fxl_q2_30 strength,
                                            const fxl_direction *normal)
{
    const int64_t facing =
        -(fxl_product(normal->x, direction->x) + fxl_product(normal->y, direction->y) +
          fxl_product(normal->z, direction->z));
    return facing > 0 ? fraction_of((uint32_t)strength, (uint32_t)(facing >> 30)) : 0;
}

/* The upper word of value * 2^shift, 0 <= shift <= 63, by words: cores have no shift of 64 bits. */
static inline uint32_t upper_of(uint64_t value, unsigned shift)
{
    const uint32_t high = (uint32_t)(value >> 32), low = (uint32_t)value;
    return shift < 32 ? high << shift | low >> 1 >> (31u - shift) : low << (shift - 32u);
}

/* Requires a value above 0. */
static inline unsigned zeros_of(uint64_t value)
{
    const uint32_t high = (uint32_t)(value >> 32);
    return high != 0 ? fxl_leading_zeros(high) : 32u + fxl_leading_zeros((uint32_t)value);
}

/* 2^46 / sqrt(value), for values of 2^30 to 2^32: from 2^30 to 2^31, relatively within 2^-25.
 *
 * The table has 8 bits for each 2^25 of the value: within 2^-6.5. Two steps of Newton's method
 * follow, y (1 + e / 2) with e = 1 - value y^2, of which each leaves 3/2 of the squared error. The
 * first one is in 16 bits, with e in units of 2^-20; e is below 2^-5.4, so its product is below
 * 2^31. Of the second one, e is in units of 2^-28 and below 2^-11. */
static uint32_t root_reciprocal(uint32_t value)
{
    static const uint8_t roots[96] = {
        254, 250, 247, 243, 240, 236, 233, 230, 228, 225, 222, 220, 217, 215, 212, 210,
        208, 206, 204, 202, 200, 198, 196, 194, 193, 191, 189, 188, 186, 185, 183, 182,
        180, 179, 178, 176, 175, 174, 172, 171, 170, 169, 168, 167, 166, 165, 163, 162,
        161, 160, 159, 158, 158, 157, 156, 155, 154, 153, 152, 151, 151, 150, 149, 148,
        147, 147, 146, 145, 144, 144, 143, 142, 142, 141, 140, 140, 139, 138, 138, 137,
        137, 136, 135, 135, 134, 134, 133, 132, 132, 131, 131, 130, 130, 129, 129, 128};
    const uint32_t rough = (uint32_t)roots[(value >> 25) - 32u] << 8;
    const int32_t first =
        (int32_t)((1u << 30) - fxl_upper_product_unsigned(rough * rough, value)) >> 10;
    const uint32_t root = (rough << 15) + (uint32_t)((int32_t)rough * first >> 6);
    const int32_t second =
        (int32_t)((1u << 28) -
                  fxl_upper_product_unsigned(fxl_upper_product_unsigned(root, root), value));
    return root + (uint32_t)(int32_t)(fxl_product((int32_t)root, second * 8) >> 32);
}

/* The cosine between a normal and a vector to a light; dot is their product, from 1 to below 2^61,
 * square that of the vector. It is scaled to 2^62 to 2^64; the dot by the root of that, to at most
 * 2^62 (1 + 2^-26), of which the upper word is 2^30 times the cosine and the vector's scaled
 * length, in units of 2^32. Errors: of the root 2^-25, which is 32, of the upper words 2. */
/* light 2.3 */
static uint32_t cosine(int64_t dot, uint64_t square)
{
    const unsigned shift = zeros_of(square) & ~1u;
    const uint32_t facing = upper_of((uint64_t)dot, shift / 2);
    return fraction_of(facing, root_reciprocal(upper_of(square, shift)));
}

/* 1 - square / range_square, of 0 < square < range_square <= 2^60. Both are scaled so that the
 * divisor is from 2^31 to 2^32. The estimate of 2^62 / divisor has 16 bits; Newton's step leaves
 * the square of its error, below 2^-29. Errors: 2 of that, 2 of the upper words. */
/* light 2.3 */
static uint32_t fading(uint64_t square, uint64_t range_square)
{
    const unsigned shift = zeros_of(range_square);
    const uint32_t divisor = upper_of(range_square, shift);
    const uint32_t estimate = fxl_divide_half((uint32_t)INT32_MAX, divisor >> 16);
    const uint32_t reciprocal =
        (estimate << 16) - fxl_upper_product_unsigned(estimate * estimate, divisor);
    const int32_t left =
        FXL_Q2_30_ONE - (int32_t)fxl_upper_product_unsigned(upper_of(square, shift), reciprocal);
    return left > 0 ? (uint32_t)left : 0;
}

/* A light at a point. Its place and the face's are doubled. Both are below 2^30 + 2, so differences
 * are below 2^31 + 4: one that does not fit wraps to more than any range, which is below 2^30, and
 * whatever the dot is then, the light is out of range. Of words three products are below 2^63. A
 * light behind the face is left out first. Within the range squares are below 2^60, and a sum that
 * is less than range_square too. Errors: cosine 34, fading 4, two products 2. */
__attribute__((noinline)) /* in place, a face turned away takes 12 instructions more */
/* light 2.3 */
static uint32_t
from_point(const fxl_point_light *light, const fxl_lit_place *place)
{
    const uint32_t x = 2u * (uint32_t)light->position.x - (uint32_t)place->middle.x;
    const uint32_t y = 2u * (uint32_t)light->position.y - (uint32_t)place->middle.y;
    const uint32_t z = 2u * (uint32_t)light->position.z - (uint32_t)place->middle.z;
    const fxl_direction *normal = &place->normal;
    const int64_t dot = fxl_product(normal->x, (int32_t)x) + fxl_product(normal->y, (int32_t)y) +
                        fxl_product(normal->z, (int32_t)z);
    const uint32_t range = 2u * (uint32_t)light->range;
    if (dot < 0 || x + range > 2u * range || y + range > 2u * range || z + range > 2u * range) {
        return 0;
    }
    const uint64_t square = (uint64_t)fxl_product((int32_t)x, (int32_t)x) +
                            (uint64_t)fxl_product((int32_t)y, (int32_t)y) +
                            (uint64_t)fxl_product((int32_t)z, (int32_t)z);
    const uint64_t range_square = fxl_product_unsigned(range, range);
    if (square >= range_square || dot == 0) {
        return 0;
    }
    return fraction_of(fraction_of((uint32_t)light->strength, cosine(dot, square)),
                       fading(square, range_square));
}

/* place light: the brightness; from it a level of the ramp, or in RGB565 a part */
/* What fog leaves of the light: 1 before fog_near, 0 beyond fog_far. The coordinates of the face's
 * middle are doubled, below 2^30 + 2, so by Cauchy-Schwarz the sum of their products is below 2^61,
 * and so is twice that of the eye's place. Error: 1. */
/* light 2.4 */
static int64_t through_fog(const fxl_light_settings *settings, const fxl_camera *camera,
                           const fxl_point *middle)
{
    const fxl_direction *forward = &camera->axes.forward;
    const fxl_point *eye = &camera->position;
    const int64_t depth = fxl_product(forward->x, middle->x) + fxl_product(forward->y, middle->y) +
                          fxl_product(forward->z, middle->z) -
                          2 * fxl_dot(forward, eye->x, eye->y, eye->z);           /* in 2^-47 */
    const int64_t length = 2 * ((int64_t)settings->fog_far - settings->fog_near); /* below 2^32 */
    /* Below 2^32 * 2^30. */
    const int64_t left = 2 * (int64_t)settings->fog_far * FXL_Q2_30_ONE - depth;
    if (left <= 0) {
        return 0;
    }
    return left >= length * FXL_Q2_30_ONE ? FXL_Q2_30_ONE : fxl_divide_down(left, (uint32_t)length);
}

/* Errors: of the directional light 2, of four points 4 * 40, of the fog 1, of its product 1. Where
 * the instance has a placement, its normal is rounded by 1 a component, and its middle by 2 units
 * of 2^-17, which fxl_lit_place is; so these are no errors of this function. */
static inline fxl_q2_30 brightness_of(const fxl_light_settings *settings,
                                      const fxl_direction *normal)
{
    return (fxl_q2_30)sum_of((uint32_t)settings->ambient,
                             from_direction(&settings->direction, settings->strength, normal));
}

/* The level at a corner. */
static inline int32_t level_at(const fxl_direction *normal, const fxl_direction *direction,
                               fxl_q2_30 strength, uint32_t ambient, uint32_t levels_less_1)
{
    const uint32_t sum = sum_of(ambient, from_direction(direction, strength, normal));
    return fxl_light_corner_level((fxl_q2_30)sum, levels_less_1);
}

/* The portable text. */
#if !FXL_KERNELS_ARMV7M || FXL_IS_COMPACT

void fxl_light_corners_of(const fxl_light_settings *settings, const fxl_direction *normals,
                          const fxl_corner *const corners[3], int32_t values[3])
{
    /* Copies, which the compiler knows that no value changes. */
    const fxl_direction d = settings->direction;
    const fxl_q2_30 strength = settings->strength;
    const uint32_t ambient = (uint32_t)settings->ambient, most = settings->levels - 1u;
    values[0] = level_at(&normals[corners[0]->normal], &d, strength, ambient, most);
    values[1] = level_at(&normals[corners[1]->normal], &d, strength, ambient, most);
    values[2] = level_at(&normals[corners[2]->normal], &d, strength, ambient, most);
}

#endif

int32_t fxl_kept_light_find(const fxl_surfaces *surfaces, uint32_t number, uint32_t *word)
{
    const fxl_light_settings *settings = &surfaces->light->settings;
    const int32_t light =
        level_at(&surfaces->set->normals[number], &settings->direction, settings->strength,
                 (uint32_t)settings->ambient, settings->levels - 1u);
    *word = (uint32_t)light ^ number << 16;
    return light;
}

fxl_q2_30 fxl_light_brightness(const fxl_light_settings *settings, const fxl_camera *camera,
                               const fxl_lit_place *place)
{
    uint32_t sum = (uint32_t)(settings->strength == 0 ? settings->ambient
                                                      : brightness_of(settings, &place->normal));
    const fxl_point_light *point = settings->points;
    for (uint32_t left = settings->point_count; left != 0; left--) {
        const uint32_t part = from_point(point++, place);
        if (part != 0) {
            sum = sum_of(sum, part);
        }
    }
    if (settings->fog_far != 0) {
        sum = fraction_of(sum, (uint32_t)through_fog(settings, camera, &place->middle));
    }
    return (fxl_q2_30)sum;
}

/* The ramp of a palette. A program that has its ramp in flash does not call it. */
/* light 3.2 */
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

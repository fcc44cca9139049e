/* SPDX-License-Identifier: MIT */
#include "corner_planes.h"

#include "../math/product.h"
#include "light_row.h"
#include "segments.h"
#include "smooth_outline.h"

/* --- what all values share ------------------------------------------------------------------ */

static inline uint32_t largest_of(const int32_t values[3])
{
    const int32_t larger = values[0] > values[1] ? values[0] : values[1];
    return (uint32_t)(larger > values[2] ? larger : values[2]);
}

/* The depths and the weights, near_z / z, by one division: of near_z by the product of the depths,
 * of which a weight leaves out one. False: the depths differ too much.
 *
 * The largest depth has bit 31, and all have bit 30 or 31, so products of two have 61 to 64 bits,
 * of which 31 or 32 are left after the largest one is scaled. The reciprocal is from 2^30 to 2^31,
 * and near_z is scaled to 2^31 to 2^32: the factor is from 2^29 to 2^31, and weights are below
 * 2^30. */
/* accuracy 5.1.1 */
static inline bool find_weights(const fxl_screen_corners *corners, const fxl_lens *lens,
                                fxl_corner_planes *planes)
{
    const fxl_q18_46 *z = corners->depths;
    uint32_t *depths = planes->depths;
    const uint32_t any = (uint32_t)((uint64_t)(z[0] | z[1] | z[2]) >> 32);
    if (any == 0) {
        return false; /* nearer than any near plane */
    }
    const unsigned shift = fxl_leading_zeros(any);
    FXL_EACH_CORNER
    for (uint32_t i = 0; i < 3; i++) {
        depths[i] =
            (uint32_t)((uint64_t)z[i] >> 32) << shift | (uint32_t)z[i] >> 1 >> (31u - shift);
        if (depths[i] >> 30 == 0) {
            return false;
        }
    }
    uint32_t products[3] = {fxl_upper_product_unsigned(depths[1], depths[2]),
                            fxl_upper_product_unsigned(depths[0], depths[2]),
                            fxl_upper_product_unsigned(depths[0], depths[1])};
    const unsigned zeros = fxl_leading_zeros(products[0] | products[1] | products[2]);
    const uint32_t near_z = (uint32_t)lens->near_z;
    const unsigned near_zeros = fxl_leading_zeros(near_z);
    for (uint32_t i = 0; i < 3; i++) {
        products[i] = products[i] << zeros >> 1;
    }
    const fxl_reciprocal reciprocal =
        fxl_reciprocal_of(fxl_upper_product_unsigned(products[0], depths[0]));
    const uint32_t factor =
        fxl_upper_product_unsigned(near_z << near_zeros, (uint32_t)reciprocal.value);
    for (uint32_t i = 0; i < 3; i++) {
        planes->weights[i] = (int32_t)fxl_upper_product_unsigned(factor, products[i]);
    }
    planes->weight_exponent = 32 + (int)near_zeros - (int)shift - (int)reciprocal.zeros;
    planes->has_weight = false;
    return true;
}

/* Edges are below 2^26 in 1/65536 pixel, so the area is below 2^53; of a small face it is at
 * least 2^25, of a thin one 2^19. Its upper 31 bits have a reciprocal r within 2^-29. The edges are
 * scaled to less than 2^31, so a product with r is at most 2^62. The longer side of the box
 * is scaled to 2^30 or more, so with r of at least 2^30 its coefficient would be at least 2^28:
 * what is cut off a coefficient is less than 2^-28 of that. */
/* SPEC 9.1.1 */
bool fxl_corner_planes_begin(const fxl_screen_corners *corners, const fxl_lens *lens,
                             int32_t side_max, fxl_corner_planes *planes)
{
    const fxl_screen_point *p = corners->points;
    const uint32_t width = (uint32_t)corners->width, height = (uint32_t)corners->height;
    const uint32_t range = (uint32_t)side_max - FXL_SMALL_SIDE_MIN;
    const bool for_words = side_max != FXL_SMALL_SIDE_MAX;
    if (width - FXL_SMALL_SIDE_MIN > range || height - FXL_SMALL_SIDE_MIN > range) {
        return false;
    }
    const int32_t x1 = p[1].x - p[0].x, y1 = p[0].y - p[1].y;
    const int32_t x2 = p[0].x - p[2].x, y2 = p[2].y - p[0].y;
    const int64_t area = fxl_product(x1, y2) - fxl_product(x2, y1);
    const uint64_t box = fxl_product_unsigned(width, height);
    planes->area = fxl_magnitude(area);
    planes->may_be_steep = planes->area << 3 < box;
    const unsigned thin = side_max == FXL_COLOURS_SIDE_MAX  ? 6
                          : side_max == FXL_TEXELS_SIDE_MAX ? 4 : 9;
    if (planes->area << thin < box ||
        (planes->may_be_steep && !for_words)) {
        return false;
    }
    if (!find_weights(corners, lens, planes)) {
        return false;
    }
    planes->weight_range = fxl_range_of(planes->weights);
    planes->weight_most = largest_of(planes->weights);
    /* A side has at most 26 bits, and weights 30. */
    if ((uint64_t)planes->weight_range * ((uint32_t)FXL_SMALL_SLOPES << 16) >
        fxl_product_unsigned(planes->weight_most, width < height ? width : height)) {
        if (!for_words) {
            return false;
        }
        planes->may_be_steep = true;
    }
    planes->is_for_words =
        planes->may_be_steep || width > FXL_SMALL_SIDE_MAX || height > FXL_SMALL_SIDE_MAX;
    const fxl_real upper = fxl_real_of(planes->area, 0);
    const int32_t magnitude = fxl_reciprocal_of(upper.mantissa >> 1).value;
    const int32_t reciprocal = area < 0 ? -magnitude : magnitude;
    const unsigned scale = fxl_leading_zeros(width > height ? width : height) - 1u;
    planes->x = p[0].x - 32768;
    planes->y = p[0].y - 32768;
    planes->along[0] = fxl_upper_product((int32_t)((uint32_t)y2 << scale), reciprocal);
    planes->along[1] = fxl_upper_product((int32_t)((uint32_t)y1 << scale), reciprocal);
    planes->down[0] = fxl_upper_product((int32_t)((uint32_t)x2 << scale), reciprocal);
    planes->down[1] = fxl_upper_product((int32_t)((uint32_t)x1 << scale), reciprocal);
    planes->exponent = (int)scale + 14 + upper.exponent;
    planes->corners = corners;
    planes->lens = lens;
    planes->is_located = false;
    planes->is_triangle = corners->is_triangle;
    return true;
}

/* With all corners in the place of the least depth z, the triangle would cover area z0 z1 z2 / z^3.
 * planes->depths are the corners' depths, shifted so that the largest one has 32 bits. */
void fxl_corner_planes_density(const fxl_corner_planes *planes, bool is_affine, fxl_q18_46 nearest,
                               fxl_texel_density *density)
{
    const uint32_t *z = planes->depths;
    density->pixels = fxl_real_of(planes->area, 0);
    density->depth = fxl_real_of(1, 0);
    if (!is_affine) {
        const fxl_q18_46 *exact = planes->corners->depths;
        const uint32_t any = (uint32_t)((uint64_t)(exact[0] | exact[1] | exact[2]) >> 32);
        density->depth = fxl_real_of((uint64_t)nearest, (int)fxl_leading_zeros(any) - 32);
        for (uint32_t i = 0; i < 3; i++) {
            const fxl_real pixels = density->pixels;
            density->pixels =
                fxl_real_of(fxl_product_unsigned(pixels.mantissa, z[i]), pixels.exponent);
        }
    }
}

/* --- a triangle in one octave or two ---------------------------------------------------------- */

/* A value that is linear on the screen, by its words: that of corner 0, the differences of the
 * others, and how many bits of their gradient are below a word's. along * x is below 2^31 2^27. */
static inline void find_words(const fxl_corner_planes *planes, uint32_t value, int64_t along,
                              int64_t down, unsigned drop, fxl_gradient *gradient)
{
    const int32_t step = fxl_signed_32(fxl_lower_of_shifted(along, drop));
    const int32_t step_down = fxl_signed_32(fxl_lower_of_shifted(down, drop));
    const int64_t off = fxl_product(step, planes->x) + fxl_product(step_down, planes->y);
    gradient->along = step;
    gradient->down = step_down;
    gradient->at = fxl_signed_32(value - fxl_lower_of_shifted(off, 16));
}

/* The upper word of a magnitude, but for a unit of the lowest bit. */
static inline uint32_t upper_size(int64_t value)
{
    const int32_t high = fxl_signed_32((uint32_t)(fxl_bits_64(value) >> 32));
    return (uint32_t)(high ^ (high >> 31));
}

/* With weights of `length` bits a code is a weight times 2^(mantissa + 17 - length), and a bias:
 * depth_code.h. A weight changes by at most 16 / s of its range a pixel along a side of s pixels,
 * where the range is at most s / 16 of the largest weight, which is below 2^length: so a code
 * changes by less than 2^(mantissa + 17), at most 2^31. Where that is not so, or the face is thin,
 * it is tested. Drops are from 10 to 38. */
bool fxl_corner_planes_depth_words(const fxl_corner_planes *planes, fxl_depth_plane *depth)
{
    const int32_t *weights = planes->weights, *across = planes->along, *below = planes->down;
    const fxl_depth_scale scale = fxl_depth_scale_of(planes->lens);
    const unsigned zeros = fxl_leading_zeros(planes->weight_most);
    const int number = planes->weight_exponent + (int)zeros - 32;
    const int crossed =
        (int)fxl_leading_zeros(planes->weight_most - planes->weight_range) - (int)zeros;
    if (!planes->is_triangle || scale.mantissa > 14 || number < 0 || crossed > 1 ||
        number + crossed >= scale.octaves) {
        return false;
    }
    const int32_t d1 = weights[1] - weights[0], d2 = weights[2] - weights[0];
    const int64_t along = fxl_product(d1, across[0]) + fxl_product(d2, across[1]);
    const int64_t down = fxl_product(d1, below[0]) + fxl_product(d2, below[1]);
    const unsigned length = 32u - zeros, bits = scale.mantissa + 17u; /* 28 to 31 */
    if (planes->may_be_steep &&
        (upper_size(along) | upper_size(down)) >> ((unsigned)planes->exponent + length - 33u) !=
            0) {
        return false;
    }
    const uint32_t bias = (uint32_t)(scale.octaves - 2 - number) << (bits - 1u);
    const uint32_t weight = (uint32_t)weights[0];
    const uint32_t code = length > bits ? weight >> (length - bits) : weight << (bits - length);
    find_words(planes, bias + 65536u + code, along, down,
               (unsigned)planes->exponent + length - bits, &depth->gradient);
    depth->one = crossed ? FXL_DEPTH_IS_BENT + number : FXL_DEPTH_IS_LINEAR;
    return true;
}

#define SHIFT_OF_LIGHT 53 /* of gradients whose lower words are those of light_row.h */

/* Drops of light are from 6 to 28. Weights are below 2^30, and what they are allowed is a power of two: no
 * product, but a shift. */
bool fxl_corner_planes_linear(const fxl_corner_planes *planes, const int32_t light[3],
                              fxl_gradients *gradients, fxl_depth_plane *depth)
{
    static const fxl_gradient constant = {FXL_CONSTANT_WEIGHT, 0, 0};
    const uint32_t least = planes->weight_most - planes->weight_range;
    const uint64_t error = fxl_product_unsigned(fxl_range_of(light), planes->weight_range);
    if (error > (uint64_t)least * (4u * FXL_WORDS_ERROR_LIGHT)) {
        return false;
    }
    const int32_t d1 = light[1] - light[0], d2 = light[2] - light[0];
    const int64_t along = fxl_product(d1, planes->along[0]) + fxl_product(d2, planes->along[1]);
    const int64_t down = fxl_product(d1, planes->down[0]) + fxl_product(d2, planes->down[1]);
    const unsigned drop = (unsigned)planes->exponent - 8u;
    if ((upper_size(along) | upper_size(down)) >> (drop - 1u) != 0) {
        return false;
    }
    const int32_t more = error > (uint64_t)least * (4u * FXL_AFFINE_ERROR_LIGHT)
                             ? fxl_corner_planes_mean(planes, d1, d2)
                             : 0;
    find_words(planes, (uint32_t)(light[0] + more) << 8, along, down, drop,
               &gradients->attributes[0]);
    gradients->shifts[0] = SHIFT_OF_LIGHT;
    gradients->count = 1;
    gradients->weight = constant;
    gradients->weight_min[0] = gradients->weight_min[1] = 1;
    return fxl_corner_planes_depth_words(planes, depth);
}

/* --- a triangle with texels ------------------------------------------------------------------- */

/* The words of a value, in 8.24. False: it changes by 128 or more a pixel. Exponents are from 14 on,
 * so drops are from 6 on. */
static inline bool find_value(const fxl_corner_planes *planes, const int32_t values[3],
                              fxl_gradient *gradient)
{
    const int32_t d1 = values[1] - values[0], d2 = values[2] - values[0];
    const int64_t along = fxl_product(d1, planes->along[0]) + fxl_product(d2, planes->along[1]);
    const int64_t down = fxl_product(d1, planes->down[0]) + fxl_product(d2, planes->down[1]);
    const unsigned drop = (unsigned)planes->exponent - 8u;
    if ((upper_size(along) | upper_size(down)) >> (drop - 1u) != 0) {
        return false;
    }
    find_words(planes, fxl_bits_32(values[0]) << 8, along, down, drop, gradient);
    return true;
}

/* Whether a constant weight changes no value by more than that of the rule. Ranges are below 2^31,
 * and of weights below 2^30. */
/* SPEC 9.1.1 */
static inline bool is_nearly_linear(const fxl_corner_planes *planes, int32_t (*values)[3],
                                    uint32_t count)
{
    const uint32_t least = planes->weight_most - planes->weight_range;
    const uint32_t u = fxl_range_of(values[FXL_ATTRIBUTE_U]);
    const uint32_t v = fxl_range_of(values[FXL_ATTRIBUTE_V]);
    return fxl_product_unsigned(u > v ? u : v, planes->weight_range) <=
               fxl_product_unsigned(least, 4u * FXL_WORDS_ERROR_TEXEL) &&
           (count <= FXL_SEGMENT_LIGHT ||
            fxl_product_unsigned(fxl_range_of(values[FXL_SEGMENT_LIGHT]), planes->weight_range) <=
                fxl_product_unsigned(least, 4u * FXL_WORDS_ERROR_LIGHT));
}

bool fxl_find_texels(const fxl_corner_planes *planes, int32_t (*values)[3], uint32_t count,
                     bool is_affine, fxl_gradients *gradients, fxl_depth_plane *depth)
{
    static const fxl_gradient constant = {FXL_CONSTANT_WEIGHT, 0, 0};
    if (!(is_affine || is_nearly_linear(planes, values, count))) {
        return false;
    }
    for (uint32_t i = 0; i < FXL_ATTRIBUTES && i < count; i++) {
        if (!find_value(planes, values[i], &gradients->attributes[i])) {
            return false;
        }
        gradients->shifts[i] = FXL_SHIFT_OF_TEXELS;
    }
    gradients->count = (uint8_t)count;
    gradients->weight = constant;
    gradients->weight_min[0] = gradients->weight_min[1] = 1;
    return fxl_corner_planes_depth_words(planes, depth);
}

/* The portable texts of fxl_find_smooth_planes and fxl_find_texel_planes. */
#if !FXL_KERNELS_ARMV7M || FXL_IS_COMPACT

int32_t fxl_find_texel_planes(const fxl_screen_corners *corners, const fxl_words_lens *lens,
                              const fxl_corner *const of[3], fxl_texel_planes *texels,
                              const int32_t *light, bool is_affine, uint32_t v_drop)
{
    int32_t values[FXL_ATTRIBUTES][3];
    const uint32_t count = light != NULL ? FXL_SEGMENT_LIGHT + 1u : FXL_SEGMENT_LIGHT;
    fxl_corner_planes planes;
    fxl_gradients gradients;
    fxl_depth_plane depth;
    for (uint32_t i = 0; i < 3; i++) {
        values[FXL_ATTRIBUTE_U][i] = of[i]->texel.u;
        values[FXL_ATTRIBUTE_V][i] = of[i]->texel.v;
        values[FXL_SEGMENT_LIGHT][i] = light != NULL ? light[i] : 0;
    }
    if (!fxl_has_few_texels(values) ||
        !fxl_corner_planes_begin(corners, lens->lens, FXL_TEXELS_SIDE_MAX, &planes) ||
        !fxl_find_texels(&planes, values, count, is_affine, &gradients, &depth)) {
        return 0;
    }
    fxl_texel_words_of(&gradients, &depth, texels);
    fxl_texel_planes_scale(texels, 0, v_drop);
    return depth.one;
}

#endif

#if FXL_DRAWS_SMOOTH_OUTLINES

static inline int64_t of_word(uint32_t word)
{
    return fxl_signed_32(word);
}

bool fxl_find_smooth_planes(const fxl_screen_corners *corners, const fxl_lens *lens,
                            const int32_t light[3], fxl_gradients *gradients,
                            fxl_depth_plane *depth)
{
    static const fxl_gradient constant = {FXL_CONSTANT_WEIGHT, 0, 0};
    fxl_smooth_words words;
    const fxl_words_lens words_lens = fxl_words_lens_of(lens);
    if (!corners->is_triangle) {
        return false;
    }
    const int32_t found = fxl_find_smooth_words(corners, &words_lens, light, &words);
    const int32_t one = found & ~FXL_WORDS_HAVE_MEAN;
    if (one == 0) {
        return false;
    }
    const fxl_gradient of_light = {of_word(words.light), of_word(words.light_along),
                                   of_word(words.light_down)};
    const fxl_gradient of_depth = {of_word(words.code), of_word(words.code_along),
                                   of_word(words.code_down)};
    gradients->attributes[0] = of_light;
    gradients->shifts[0] = SHIFT_OF_LIGHT;
    gradients->count = 1;
    gradients->weight = constant;
    gradients->weight_min[0] = gradients->weight_min[1] = 1;
    depth->gradient = of_depth;
    depth->one = one;
    return true;
}

#else

bool fxl_find_smooth_planes(const fxl_screen_corners *corners, const fxl_lens *lens,
                            const int32_t light[3], fxl_gradients *gradients,
                            fxl_depth_plane *depth)
{
    fxl_corner_planes planes;
    return fxl_corner_planes_begin(corners, lens, FXL_WORDS_SIDE_MAX, &planes) &&
           fxl_corner_planes_linear(&planes, light, gradients, depth);
}

#endif

/* SPDX-License-Identifier: MIT */
#include "corner_planes.h"

#include "../math/family.h"
#include "light_row.h"
#include "segments.h"

/* On a core without long products these are calls: in place, all of them take 2 KB more. */
#if FXL_KERNELS_ARMV6M
#define PRODUCT static __attribute__((noinline))
#else
#define PRODUCT static inline
#endif

PRODUCT int64_t product(int32_t a, int32_t b)
{
    return fxl_multiply_s32(a, b);
}

PRODUCT uint64_t product_unsigned(uint32_t a, uint32_t b)
{
    return fxl_multiply_u32(a, b);
}

PRODUCT int64_t product_wide(int64_t a, int32_t b)
{
    return fxl_multiply_s64(a, b);
}

/* The upper word of a product. */
static inline int32_t upper(int32_t a, int32_t b)
{
    return (int32_t)((uint64_t)product(a, b) >> 32);
}

static inline uint32_t upper_unsigned(uint32_t a, uint32_t b)
{
    return (uint32_t)(product_unsigned(a, b) >> 32);
}

/* value / 2^drop, rounded down, for 0 <= drop <= 31, by words: cores have no shift of 64 bits. */
static inline int64_t shifted(int64_t value, unsigned drop)
{
    const uint32_t high = (uint32_t)((uint64_t)value >> 32);
    const uint32_t low = (uint32_t)value >> drop | high << 1 << (31u - drop);
    return (int64_t)((uint64_t)(uint32_t)((int32_t)high >> drop) << 32 | low);
}

/* --- what all values share ------------------------------------------------------------------ */

/* The depths and the weights. The largest depth has bit 31, and all have bit 30 or 31: products are
 * at least 2^60. False: the depths differ too much. */
static inline bool find_weights(const fxl_screen_corners *corners, fxl_corner_planes *planes)
{
    const fxl_q18_46 *z = corners->depths;
    uint32_t *depths = planes->depths, *weights = planes->weights;
    const uint32_t any = (uint32_t)((uint64_t)(z[0] | z[1] | z[2]) >> 32);
    if (any == 0) {
        return false; /* nearer than any near plane */
    }
    const unsigned shift = fxl_leading_zeros(any);
    for (uint32_t i = 0; i < 3; i++) {
        depths[i] =
            (uint32_t)((uint64_t)z[i] >> 32) << shift | (uint32_t)z[i] >> 1 >> (31u - shift);
        if (depths[i] >> 30 == 0) {
            return false;
        }
    }
    planes->depth_shift = shift;
    weights[0] = upper_unsigned(depths[1], depths[2]);
    weights[1] = upper_unsigned(depths[0], depths[2]);
    weights[2] = upper_unsigned(depths[0], depths[1]);
    const unsigned zeros = fxl_leading_zeros(weights[0] | weights[1] | weights[2]);
    for (uint32_t i = 0; i < 3; i++) {
        weights[i] = weights[i] << zeros >> 1;
    }
    return true;
}

/* Edges are at most 2^22 in 1/65536 pixel, so the area is at most 2^45; of a small face it is at
 * least 2^25. Its upper 31 bits have a reciprocal r within 2^-29. The edges are scaled to less than
 * 2^31, so a product with r is at most 2^62. What is cut off a coefficient is less than 2^-29 of
 * the largest. */
bool fxl_corner_planes_begin(const fxl_screen_corners *corners, const fxl_lens *lens,
                             fxl_corner_planes *planes)
{
    const fxl_screen_point *p = corners->points;
    const uint32_t width = (uint32_t)corners->width, height = (uint32_t)corners->height;
    if (width - FXL_SMALL_SIDE_MIN > FXL_SMALL_SIDE_MAX - FXL_SMALL_SIDE_MIN ||
        height - FXL_SMALL_SIDE_MIN > FXL_SMALL_SIDE_MAX - FXL_SMALL_SIDE_MIN) {
        return false;
    }
    const int32_t x1 = p[1].x - p[0].x, y1 = p[0].y - p[1].y;
    const int32_t x2 = p[0].x - p[2].x, y2 = p[2].y - p[0].y;
    const int64_t area = product(x1, y2) - product(x2, y1);
    planes->area = fxl_magnitude(area);
    if (planes->area << 3 < product_unsigned(width, height) || !find_weights(corners, planes)) {
        return false;
    }
    const uint32_t high = (uint32_t)(planes->area >> 32), low = (uint32_t)planes->area;
    const unsigned zeros = fxl_leading_zeros(high != 0 ? high : low);
    const uint32_t mantissa = high != 0 ? high << zeros | low >> 1 >> (31u - zeros) : low << zeros;
    const int32_t magnitude = fxl_reciprocal_of(mantissa >> 1).value;
    const int32_t reciprocal = area < 0 ? -magnitude : magnitude;
    const unsigned scale = fxl_leading_zeros(width > height ? width : height) - 1u;
    planes->x = p[0].x - 32768;
    planes->y = p[0].y - 32768;
    planes->along[0] = upper((int32_t)((uint32_t)y2 << scale), reciprocal);
    planes->along[1] = upper((int32_t)((uint32_t)y1 << scale), reciprocal);
    planes->down[0] = upper((int32_t)((uint32_t)x2 << scale), reciprocal);
    planes->down[1] = upper((int32_t)((uint32_t)x1 << scale), reciprocal);
    planes->exponent = (int)scale + (high != 0 ? 46 : 14) - (int)zeros;
    planes->screen_bits = 32u - fxl_leading_zeros((lens->width + 15u) | lens->height);
    planes->is_triangle = corners->is_triangle;
    return true;
}

/* --- a value -------------------------------------------------------------------------------- */

/* The gradient of a value that is below 2^31 at the corners, scaled so that it is below 2^62 on the
 * whole screen. Returns the exponent: its 64 bits are the value times 2^exponent, from 7 to 36.
 *
 * Differences are below 2^31 and coefficients at most 2^30, so their sums are at most 2^62. Let the
 * upper words of both be below 2^bits, and the screen's sides 2^screen_bits: the value is below
 * 2^value_bits + 2 * 2^(bits + 32 + screen_bits - planes->exponent) on the screen. `least` keeps
 * the drop from being negative. What is cut off a step is less than 1/65536 in a column of 2^26. */
static int plane_of(const fxl_corner_planes *planes, const int32_t values[3],
                    fxl_gradient *gradient)
{
    const int32_t d1 = values[1] - values[0], d2 = values[2] - values[0];
    const int64_t along = product(d1, planes->along[0]) + product(d2, planes->along[1]);
    const int64_t down = product(d1, planes->down[0]) + product(d2, planes->down[1]);
    const int32_t along_high = (int32_t)((uint64_t)along >> 32);
    const int32_t down_high = (int32_t)((uint64_t)down >> 32);
    const uint32_t least = 1u << (28u - planes->screen_bits) >> 1;
    const uint32_t steps = (uint32_t)(along_high ^ (along_high >> 31)) |
                           (uint32_t)(down_high ^ (down_high >> 31)) | least;
    const uint32_t value = (uint32_t)(values[0] ^ (values[0] >> 31)) | 1u;
    const int by_steps = (int)(4u + planes->screen_bits) - (int)fxl_leading_zeros(steps);
    const int by_value = planes->exponent - 29 - (int)fxl_leading_zeros(value);
    const unsigned drop = (unsigned)(by_steps > by_value ? by_steps : by_value);
    gradient->along = shifted(along, drop);
    gradient->down = shifted(down, drop);
    const int exponent = planes->exponent - (int)drop;
    gradient->at = (int64_t)((uint64_t)(int64_t)values[0] << exponent) -
                   product_wide(gradient->along >> 16, planes->x) -
                   product_wide(gradient->down >> 16, planes->y);
    return exponent;
}

/* near_z / z of the corners, by one division: of near_z by the product of the depths, of which the
 * weights leave out one each. near_z and the reciprocal are below 2^32 and 2^31, so the factor is
 * from 2^29 to 2^31, and the values are below 2^30. */
void fxl_corner_planes_depth(const fxl_corner_planes *planes, const fxl_lens *lens,
                             fxl_depth_plane *plane)
{
    const uint32_t near_z = (uint32_t)lens->near_z;
    const unsigned near_zeros = fxl_leading_zeros(near_z);
    const fxl_reciprocal reciprocal =
        fxl_reciprocal_of(upper_unsigned(planes->weights[0], planes->depths[0]));
    const uint32_t factor = upper_unsigned(near_z << near_zeros, (uint32_t)reciprocal.value);
    int32_t values[3];
    for (uint32_t i = 0; i < 3; i++) {
        values[i] = (int32_t)upper_unsigned(factor, planes->weights[i]);
    }
    plane->one = 32 + (int)near_zeros - (int)planes->depth_shift - (int)reciprocal.zeros +
                 plane_of(planes, values, &plane->gradient);
}

/* --- a face --------------------------------------------------------------------------------- */

static inline uint32_t range_of(const int32_t values[3])
{
    int32_t least = values[0], most = values[0];
    for (uint32_t i = 1; i < 3; i++) {
        least = values[i] < least ? values[i] : least;
        most = values[i] > most ? values[i] : most;
    }
    return (uint32_t)most - (uint32_t)least;
}

/* Whether a constant weight changes no attribute by more than FXL_AFFINE_ERROR_TEXEL, or
 * FXL_AFFINE_ERROR_LIGHT: light is the last of an odd number. Differences of attributes are below
 * 2^31, and of weights below 2^31. */
static bool is_nearly_affine(const fxl_corner_planes *planes, int32_t (*values)[3], uint32_t count)
{
    const int32_t weights[3] = {(int32_t)planes->weights[0], (int32_t)planes->weights[1],
                                (int32_t)planes->weights[2]};
    const uint32_t range = range_of(weights);
    const unsigned part = planes->is_triangle ? 0 : 3;
    uint32_t least = planes->weights[0];
    for (uint32_t i = 1; i < 3; i++) {
        least = planes->weights[i] < least ? planes->weights[i] : least;
    }
    for (uint32_t i = 0; i < count; i++) {
        const uint32_t error =
            i % 2 == 0 && i + 1 == count ? FXL_AFFINE_ERROR_LIGHT : FXL_AFFINE_ERROR_TEXEL;
        if (product_unsigned(range_of(values[i]), range) >
            product_unsigned(least, 4u * error >> part)) {
            return false;
        }
    }
    return true;
}

/* Zeros above the largest magnitude of three values below 2^30, with its sign: 2 or more. */
static inline unsigned room_of(const int32_t values[3])
{
    uint32_t bits = 1;
    for (uint32_t i = 0; i < 3; i++) {
        bits |= (uint32_t)(values[i] ^ (values[i] >> 31));
    }
    return fxl_leading_zeros(bits);
}

static inline void scale(int32_t values[3], unsigned shift)
{
    for (uint32_t i = 0; i < 3; i++) {
        values[i] = (int32_t)((uint32_t)values[i] << shift);
    }
}

/* Attributes are linear on the screen: values are scaled to less than 2^30. The weight is 2^29. */
static void find_affine(const fxl_corner_planes *planes, int32_t (*values)[3],
                        fxl_gradients *gradients)
{
    static const fxl_gradient constant = {FXL_CONSTANT_WEIGHT, 0, 0};
    gradients->weight = constant;
    gradients->weight_min[0] = gradients->weight_min[1] = 1;
    for (uint32_t i = 0; i < gradients->count; i++) {
        const unsigned shift = room_of(values[i]) - 2u;
        scale(values[i], shift);
        gradients->shifts[i] =
            (int8_t)(61 - (int)shift - plane_of(planes, values[i], &gradients->attributes[i]));
    }
}

/* The attributes are scaled to less than 2^31, and their products with the weights to half of it.
 */
static void find_perspective(const fxl_corner_planes *planes, int32_t (*values)[3],
                             const fxl_lens *lens, fxl_gradients *gradients)
{
    const int32_t weights[3] = {(int32_t)planes->weights[0], (int32_t)planes->weights[1],
                                (int32_t)planes->weights[2]};
    const int weight_exponent = plane_of(planes, weights, &gradients->weight);
    for (uint32_t i = 0; i < gradients->count; i++) {
        const unsigned shift = room_of(values[i]) - 1u;
        scale(values[i], shift);
        for (uint32_t k = 0; k < 3; k++) {
            values[i][k] = upper(values[i][k], weights[k]);
        }
        gradients->shifts[i] = (int8_t)(32 - (int)shift + weight_exponent -
                                        plane_of(planes, values[i], &gradients->attributes[i]));
    }
    fxl_gradients_find_least(gradients, lens);
}

void fxl_corner_planes_find(const fxl_corner_planes *planes, int32_t (*values)[3], uint32_t count,
                            bool is_affine, const fxl_lens *lens, fxl_gradients *gradients)
{
    gradients->count = (uint8_t)count;
    if (is_affine || is_nearly_affine(planes, values, count)) {
        find_affine(planes, values, gradients);
    } else {
        find_perspective(planes, values, lens, gradients);
    }
}

/* With all corners in the place of the least depth z, the triangle would cover area z0 z1 z2 / z^3.
 */
void fxl_corner_planes_density(const fxl_corner_planes *planes, bool is_affine,
                               fxl_texel_density *density)
{
    const uint32_t *z = planes->depths;
    density->pixels = fxl_real_of(planes->area, 0);
    density->depth = fxl_real_of(1, 0);
    if (!is_affine) {
        const uint32_t near = z[0] < z[1] ? z[0] : z[1];
        density->depth = fxl_real_of(near < z[2] ? near : z[2], 0);
        for (uint32_t i = 0; i < 3; i++) {
            const fxl_real pixels = density->pixels;
            density->pixels = fxl_real_of(product_unsigned(pixels.mantissa, z[i]), pixels.exponent);
        }
    }
}

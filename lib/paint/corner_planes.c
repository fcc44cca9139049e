/* SPDX-License-Identifier: MIT */
#include "corner_planes.h"

#include "../math/product.h"
#include "light_row.h"
#include "segments.h"

/* value / 2^drop, rounded down, for 0 <= drop <= 31, by words: cores have no shift of 64 bits. */
static inline int64_t shifted(int64_t value, unsigned drop)
{
    const uint32_t high = (uint32_t)((uint64_t)value >> 32);
    const uint32_t low = (uint32_t)value >> drop | high << 1 << (31u - drop);
    return (int64_t)((uint64_t)(uint32_t)((int32_t)high >> drop) << 32 | low);
}

/* --- what all values share ------------------------------------------------------------------ */

static inline uint32_t range_of(const int32_t values[3])
{
    int32_t least = values[0], most = values[0];
    for (uint32_t i = 1; i < 3; i++) {
        least = values[i] < least ? values[i] : least;
        most = values[i] > most ? values[i] : most;
    }
    return (uint32_t)most - (uint32_t)least;
}

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

/* How far the pixels of 0 to `end` are at most from one of them, or one beside them, and one more.
 */
static inline uint32_t farthest(int32_t pixel, int32_t end)
{
    return (uint32_t)(2 * pixel > end ? pixel : end - pixel) + 1u;
}

/* The box has at most its height above the lowest of the three corners, and below the highest. */
static inline void find_rows(fxl_corner_planes *planes)
{
    const fxl_screen_corners *corners = planes->corners;
    const fxl_lens *lens = planes->lens;
    int32_t top = corners->points[0].y, bottom = top;
    for (uint32_t i = 1; i < 3; i++) {
        const int32_t y = corners->points[i].y;
        top = y < top ? y : top;
        bottom = y > bottom ? y : bottom;
    }
    const int32_t first = (bottom - corners->height) >> 16;
    const int32_t last = (top + corners->height + 65535) >> 16;
    planes->first_row = first < 0 ? 0 : first;
    planes->last_row = last > lens->height ? lens->height : last;
}

/* Where the face is on the screen. */
static inline void locate(fxl_corner_planes *planes)
{
    if (!planes->is_located) {
        const fxl_screen_point *p = planes->corners->points;
        planes->columns = farthest(p[0].x >> 16, (planes->lens->width + 15) & ~15);
        planes->rows = farthest(p[0].y >> 16, planes->lens->height);
        find_rows(planes);
        planes->is_located = true;
    }
}

/* Edges are at most 2^22 in 1/65536 pixel, so the area is at most 2^45; of a small face it is at
 * least 2^25, of a thin one 2^22. Its upper 31 bits have a reciprocal r within 2^-29. The edges are
 * scaled to less than 2^31, so a product with r is at most 2^62. What is cut off a coefficient is
 * less than 2^-29 of the largest. */
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
    const int64_t area = fxl_product(x1, y2) - fxl_product(x2, y1);
    const uint64_t box = fxl_product_unsigned(width, height);
    planes->area = fxl_magnitude(area);
    planes->is_thin = false;
    if (planes->area << 3 < box) {
        if (planes->area << 6 < box) {
            return false;
        }
        planes->is_thin = true;
    }
    if (!find_weights(corners, lens, planes)) {
        return false;
    }
    planes->weight_range = range_of(planes->weights);
    planes->weight_most = largest_of(planes->weights);
    /* A side has at most 23 bits, and weights 30. */
    if (!planes->is_thin &&
        fxl_product_unsigned(planes->weight_range, (uint32_t)FXL_SMALL_SLOPES << 16) >
            fxl_product_unsigned(planes->weight_most, width < height ? width : height)) {
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
    planes->along[0] = fxl_upper_product((int32_t)((uint32_t)y2 << scale), reciprocal);
    planes->along[1] = fxl_upper_product((int32_t)((uint32_t)y1 << scale), reciprocal);
    planes->down[0] = fxl_upper_product((int32_t)((uint32_t)x2 << scale), reciprocal);
    planes->down[1] = fxl_upper_product((int32_t)((uint32_t)x1 << scale), reciprocal);
    planes->exponent = (int)scale + (high != 0 ? 46 : 14) - (int)zeros;
    planes->corners = corners;
    planes->lens = lens;
    planes->is_located = false;
    planes->is_triangle = corners->is_triangle;
    planes->is_sparse = planes->area << 1 < box;
    return true;
}

/* --- a value -------------------------------------------------------------------------------- */

/* The gradient of a value that is below 2^30 at the corners, scaled so that it is below 2^62 on the
 * whole screen. Returns the exponent: its 64 bits are the value times 2^exponent, from 4 to 36.
 *
 * Differences are below 2^31 and coefficients at most 2^30, so their sums are at most 2^62.
 * `largest` is above the largest value on the screen in units of 2^(32 - planes->exponent): the
 * upper words are below 2^30 and sides at most 2^11, so it is below 2^43. It is at least 2^29, so
 * that no bits are added. What is cut off a step is less than 1/65536 of a unit of 2^-32, and less
 * than 2^26 of these in a column. */
static int plane_of(const fxl_corner_planes *planes, const int32_t values[3],
                    fxl_gradient *gradient)
{
    const int32_t d1 = values[1] - values[0], d2 = values[2] - values[0];
    const int64_t along = fxl_product(d1, planes->along[0]) + fxl_product(d2, planes->along[1]);
    const int64_t down = fxl_product(d1, planes->down[0]) + fxl_product(d2, planes->down[1]);
    const int32_t along_high = (int32_t)((uint64_t)along >> 32);
    const int32_t down_high = (int32_t)((uint64_t)down >> 32);
    const uint32_t value = (uint32_t)(values[0] ^ (values[0] >> 31)) + 1u;
    const int up = planes->exponent - 32; /* -12..4 */
    const uint64_t largest =
        (fxl_product_unsigned((uint32_t)(along_high ^ (along_high >> 31)) + 1u, planes->columns) +
         fxl_product_unsigned((uint32_t)(down_high ^ (down_high >> 31)) + 1u, planes->rows) +
         (up >= 0 ? fxl_product_unsigned(value, 1u << up) : (value >> -up) + 1u)) |
        1u << 29;
    const unsigned drop = fxl_bit_length(largest) - 30u;
    const int exponent = planes->exponent - (int)drop;
    gradient->along = shifted(along, drop);
    gradient->down = shifted(down, drop);
    gradient->at = (int64_t)((uint64_t)(int64_t)values[0] << exponent) -
                   fxl_product_wide(gradient->along >> 16, planes->x) -
                   fxl_product_wide(gradient->down >> 16, planes->y);
    return exponent;
}

/* The gradient of the weight, which is the depth's. */
static void find_weight(fxl_corner_planes *planes)
{
    if (!planes->has_weight) {
        locate(planes);
        planes->gradient_exponent = plane_of(planes, planes->weights, &planes->weight);
        planes->has_weight = true;
    }
}

void fxl_corner_planes_depth(fxl_corner_planes *planes, fxl_depth_plane *plane)
{
    find_weight(planes);
    plane->gradient = planes->weight;
    plane->one = planes->weight_exponent + planes->gradient_exponent;
}

/* --- a face --------------------------------------------------------------------------------- */

/* Whether a constant weight changes no attribute by more than FXL_AFFINE_ERROR_TEXEL, or
 * FXL_AFFINE_ERROR_LIGHT: light is the last of an odd number. ranges: of the attributes, below
 * 2^31; range: of the weights, below 2^30. */
static bool is_nearly_affine(const fxl_corner_planes *planes, const uint32_t *ranges,
                             uint32_t count, uint32_t range)
{
    const uint32_t least = planes->weight_most - range;
    const unsigned part = planes->is_triangle ? 0 : 3;
    for (uint32_t i = 0; i < count; i++) {
        const uint32_t error =
            i % 2 == 0 && i + 1 == count ? FXL_AFFINE_ERROR_LIGHT : FXL_AFFINE_ERROR_TEXEL;
        if (fxl_product_unsigned(ranges[i], range) >
            fxl_product_unsigned(least, 4u * error >> part)) {
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

/* --- a triangle in one octave --------------------------------------------------------------- */

/* A value that is linear on the screen, by its words: that of corner 0, the differences of the
 * others, and how many bits of their gradient are below a word's. along * x is below 2^31 2^27. */
static inline void find_words(const fxl_corner_planes *planes, uint32_t value, int64_t along,
                              int64_t down, unsigned drop, fxl_gradient *gradient)
{
    const int32_t step = (int32_t)fxl_lower_of_shifted(along, drop);
    const int32_t step_down = (int32_t)fxl_lower_of_shifted(down, drop);
    const int64_t off = fxl_product(step, planes->x) + fxl_product(step_down, planes->y);
    gradient->along = step;
    gradient->down = step_down;
    gradient->at = (int32_t)(value - fxl_lower_of_shifted(off, 16));
}

/* The upper word of a magnitude, but for a unit of the lowest bit. */
static inline uint32_t upper_size(int64_t value)
{
    const int32_t high = (int32_t)((uint64_t)value >> 32);
    return (uint32_t)(high ^ (high >> 31));
}

/* With weights of `length` bits a code is a weight times 2^(mantissa + 17 - length), and a bias:
 * depth_code.h. A weight changes by at most 16 / s of its range a pixel along a side of s pixels,
 * where the range is at most s / 16 of the largest weight, which is below 2^length: so a code
 * changes by less than 2^(mantissa + 17), at most 2^31. Of a thin face a code may change by
 * 2^(mantissa + 14), less than a quarter of the largest weight. Drops are from 13 to 38; of light,
 * from 9 to 28. */
bool fxl_corner_planes_linear(const fxl_corner_planes *planes, const int32_t light[3],
                              fxl_gradients *gradients, fxl_depth_plane *depth)
{
    static const fxl_gradient constant = {FXL_CONSTANT_WEIGHT, 0, 0};
    const int32_t *weights = planes->weights;
    const fxl_depth_scale scale = fxl_depth_scale_of(planes->lens);
    const unsigned zeros = fxl_leading_zeros(planes->weight_most);
    const int number = planes->weight_exponent + (int)zeros - 32;
    const uint32_t range = range_of(light);
    if (!planes->is_triangle || scale.mantissa > 14 || number < 0 || number >= scale.octaves ||
        fxl_leading_zeros(planes->weight_most - planes->weight_range) != zeros ||
        !is_nearly_affine(planes, &range, 1, planes->weight_range)) {
        return false;
    }
    const int32_t *across = planes->along, *below = planes->down;
    int32_t d1 = light[1] - light[0], d2 = light[2] - light[0];
    int64_t along = fxl_product(d1, across[0]) + fxl_product(d2, across[1]);
    int64_t down = fxl_product(d1, below[0]) + fxl_product(d2, below[1]);
    const unsigned drop = (unsigned)planes->exponent - 8u;
    if ((upper_size(along) | upper_size(down)) >> (drop - 1u) != 0) {
        return false;
    }
    find_words(planes, (uint32_t)light[0] << 8, along, down, drop, &gradients->attributes[0]);
    gradients->shifts[0] = 53;
    gradients->count = 1;
    gradients->weight = constant;
    gradients->weight_min[0] = gradients->weight_min[1] = 1;

    d1 = weights[1] - weights[0];
    d2 = weights[2] - weights[0];
    along = fxl_product(d1, across[0]) + fxl_product(d2, across[1]);
    down = fxl_product(d1, below[0]) + fxl_product(d2, below[1]);
    const unsigned length = 32u - zeros, bits = scale.mantissa + 17u; /* 28 to 31 */
    if (planes->is_thin &&
        (upper_size(along) | upper_size(down)) >> ((unsigned)planes->exponent + length - 35u) !=
            0) {
        return false;
    }
    const uint32_t bias = (uint32_t)(scale.octaves - 2 - number) << (bits - 1u);
    const uint32_t weight = (uint32_t)weights[0];
    const uint32_t code = length > bits ? weight >> (length - bits) : weight << (bits - length);
    find_words(planes, bias + 65536u + code, along, down,
               (unsigned)planes->exponent + length - bits, &depth->gradient);
    depth->one = FXL_DEPTH_IS_LINEAR;
    return true;
}

/* --- attributes ----------------------------------------------------------------------------- */

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

/* weight_min: the rule of gradients.h for the rows of the face's box, by powers of 2. Where that is
 * not enough for segments of 16 pixels all over the face, fxl_gradients_find_least takes its place,
 * which takes longer.
 *
 * Let A be the sum of the coefficients along a row, D the range of an attribute, w and q w the
 * largest weight and the range of the weights, and ' the change a pixel. In the rows of the box |u'
 * w - w' u| <= D A w^2 k, k = 1 + 2 b q: b, the sum of the coefficients down times the rows of the
 * box, is at most 4, or 16 of a face that fills less than a quarter of it. So with weights of at
 * least 3/4 w at both ends of 16 pixels, attributes are off by at most r / 4 of their unit, r =
 * 2^-8 (64/27) k D A |w'| / w. If r <= 2^bits, weights 2^(bits/3) as large suffice for 16 pixels,
 * and 2^((bits - 4)/3) as large for 4. Of what changes by 2^21 a pixel or more no weight suffices:
 * the ends might overflow. */
static void find_least(const fxl_corner_planes *planes, uint32_t attributes, uint32_t weights,
                       uint32_t weight_min[2])
{
    /* 3/4 2^((i - 4)/3), in 1/65536, and k (16/9) / 64, in 2^-32. */
    static const uint32_t parts[12] = {19506, 24576, 30964,  39012,  49152,  61928,
                                       78024, 98304, 123856, 156048, 196608, 247711};
    static const uint32_t growths[2][3] = {{149130809u, 238609295u, 835132530u},
                                           {238609295u, 596523236u, 2982616178u}};
    const int32_t *along = planes->along;
    const int32_t slope = (int32_t)((uint64_t)planes->weight.along >> 32);
    const uint32_t change = (uint32_t)(slope ^ (slope >> 31)) + 1u, range = attributes | 1u;
    const uint32_t sum =
        (uint32_t)(along[0] ^ (along[0] >> 31)) + (uint32_t)(along[1] ^ (along[1] >> 31)) + 2u;
    const uint32_t most = planes->weight_most;
    const uint32_t unit = (uint32_t)((uint64_t)most << planes->gradient_exponent >> 32);
    const uint32_t growth = growths[planes->is_sparse][weights <= most >> 5   ? 0
                                                       : weights <= most >> 3 ? 1
                                                                              : 2];
    const int range_zeros = (int)fxl_leading_zeros(range), sum_zeros = (int)fxl_leading_zeros(sum);
    const int change_zeros = (int)fxl_leading_zeros(change);
    const int unit_zeros = (int)fxl_leading_zeros(unit);
    uint32_t product = fxl_upper_product_unsigned(range << range_zeros, sum << sum_zeros);
    product = fxl_upper_product_unsigned(
                  fxl_upper_product_unsigned(product, change << change_zeros), growth) +
              1u;
    const int zeros = (int)fxl_leading_zeros(product);
    const int step = 64 - range_zeros - sum_zeros - planes->exponent;
    int bits = 62 - range_zeros - sum_zeros - change_zeros - planes->exponent + unit_zeros - zeros;
    bits += product << zeros > unit << unit_zeros;
    bits = bits < -4 ? -4 : bits;
    weight_min[0] = weight_min[1] = (uint32_t)1 << 31;
    if (step <= 21 && bits <= 7) { /* the unit is below 2^30: both are below 2^32 */
        weight_min[0] = (uint32_t)(fxl_product_unsigned(unit, parts[bits + 4]) >> 16) + 1u;
        weight_min[1] =
            (uint32_t)(fxl_product_unsigned(unit, parts[bits < 0 ? 0 : bits]) >> 16) + 1u;
    }
}

/* The attributes are scaled to less than 2^31, and their products with the weights are below 2^29.
 */
static void find_perspective(const fxl_corner_planes *planes, int32_t (*values)[3],
                             fxl_gradients *gradients)
{
    gradients->weight = planes->weight;
    for (uint32_t i = 0; i < gradients->count; i++) {
        const unsigned shift = room_of(values[i]) - 1u;
        for (uint32_t k = 0; k < 3; k++) {
            values[i][k] =
                fxl_upper_product((int32_t)((uint32_t)values[i][k] << shift), planes->weights[k]);
        }
        gradients->shifts[i] = (int8_t)(32 - (int)shift + planes->gradient_exponent -
                                        plane_of(planes, values[i], &gradients->attributes[i]));
    }
}

void fxl_corner_planes_find(fxl_corner_planes *planes, int32_t (*values)[3], uint32_t count,
                            bool is_affine, fxl_gradients *gradients)
{
    uint32_t ranges[FXL_ATTRIBUTES], most = 0, range = 0;
    gradients->count = (uint8_t)count;
    if (!is_affine) {
        range = planes->weight_range;
        for (uint32_t i = 0; i < count; i++) {
            ranges[i] = range_of(values[i]);
            most = ranges[i] > most ? ranges[i] : most;
        }
        is_affine = is_nearly_affine(planes, ranges, count, range);
    }
    locate(planes);
    if (is_affine) {
        find_affine(planes, values, gradients);
    } else {
        find_weight(planes);
        find_perspective(planes, values, gradients);
        find_least(planes, most, range, gradients->weight_min);
        const uint32_t least = planes->weight_most - range;
        if ((uint32_t)((uint64_t)least << planes->gradient_exponent >> 32) <
            gradients->weight_min[0]) {
            fxl_gradients_find_least(gradients, planes->first_row, planes->last_row);
        }
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
            density->pixels =
                fxl_real_of(fxl_product_unsigned(pixels.mantissa, z[i]), pixels.exponent);
        }
    }
}

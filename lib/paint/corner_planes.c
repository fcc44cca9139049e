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

/* Where the face is on the screen. */
/* SPEC 9.1.1 */
static inline void locate(fxl_corner_planes *planes)
{
    if (!planes->is_located) {
        const fxl_screen_point *p = planes->corners->points;
        planes->columns = farthest(p[0].x >> 16, (planes->lens->width + 15) & ~15);
        planes->rows = farthest(p[0].y >> 16, planes->lens->height);
        planes->is_located = true;
    }
}

/* Edges are below 2^23 in 1/65536 pixel, so the area is below 2^47; of a small face it is at
 * least 2^25, of a thin one 2^19. Its upper 31 bits have a reciprocal r within 2^-29. The edges are
 * scaled to less than 2^31, so a product with r is at most 2^62. The longer side of the box
 * is scaled to 2^30 or more, so with r of at least 2^30 its coefficient would be at least 2^28:
 * what is cut off a coefficient is less than 2^-28 of that. */
/* SPEC 9.1.1 */
bool fxl_corner_planes_begin(const fxl_screen_corners *corners, const fxl_lens *lens,
                             bool for_words, fxl_corner_planes *planes)
{
    const fxl_screen_point *p = corners->points;
    const uint32_t width = (uint32_t)corners->width, height = (uint32_t)corners->height;
    const uint32_t range =
        (uint32_t)(for_words ? FXL_WORDS_SIDE_MAX : FXL_SMALL_SIDE_MAX) - FXL_SMALL_SIDE_MIN;
    if (width - FXL_SMALL_SIDE_MIN > range || height - FXL_SMALL_SIDE_MIN > range) {
        return false;
    }
    const int32_t x1 = p[1].x - p[0].x, y1 = p[0].y - p[1].y;
    const int32_t x2 = p[0].x - p[2].x, y2 = p[2].y - p[0].y;
    const int64_t area = fxl_product(x1, y2) - fxl_product(x2, y1);
    const uint64_t box = fxl_product_unsigned(width, height);
    planes->area = fxl_magnitude(area);
    planes->may_be_steep = planes->area << 3 < box;
    if (planes->area << 9 < box || (planes->may_be_steep && !for_words)) {
        return false;
    }
    if (!find_weights(corners, lens, planes)) {
        return false;
    }
    planes->weight_range = range_of(planes->weights);
    planes->weight_most = largest_of(planes->weights);
    /* A side has at most 23 bits, and weights 30. */
    if (fxl_product_unsigned(planes->weight_range, (uint32_t)FXL_SMALL_SLOPES << 16) >
        fxl_product_unsigned(planes->weight_most, width < height ? width : height)) {
        if (!for_words) {
            return false;
        }
        planes->may_be_steep = true;
    }
    planes->is_for_words =
        planes->may_be_steep || width > FXL_SMALL_SIDE_MAX || height > FXL_SMALL_SIDE_MAX;
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
 * than 2^26 of these in a column. *slope becomes the change a pixel along, in units of 2^(32 -
 * planes->exponent), rounded down: from -2^30 to 2^30. */
/* accuracy 5.1.1 */
static int plane_of(const fxl_corner_planes *planes, const int32_t values[3],
                    fxl_gradient *gradient, int32_t *slope)
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
    *slope = along_high;
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
        planes->gradient_exponent =
            plane_of(planes, planes->weights, &planes->weight, &planes->weight_slope);
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
/* SPEC 9.1.1 */
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

/* --- a triangle in one octave or two ---------------------------------------------------------- */

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

/* The mean of what a constant weight takes off light in the triangle, of which corners 1 and 2 have
 * d1 and d2 more than corner 0. With a and b the same differences of weights, and s the sum of the
 * three weights, it is (d1 (2 a - b) + d2 (2 b - a)) / 4 s. Any two weights differ by less than
 * 2^30, so factors are below 2^31; light differs by less than 2^22, so products are below 2^53.
 * Here s is that of weights whose middle one is midway. It costs at most 1/4 of the mean. */
static int32_t mean_of_error(const fxl_corner_planes *planes, int32_t d1, int32_t d2)
{
    const int32_t *weights = planes->weights;
    const int32_t a = weights[1] - weights[0], b = weights[2] - weights[0];
    const int64_t sum = fxl_product(d1, 2 * a - b) + fxl_product(d2, 2 * b - a);
    const uint32_t twice = 2u * planes->weight_most - planes->weight_range;
    return (int32_t)fxl_lower_of_shifted(sum, 24) / (int32_t)((twice + twice / 2u) >> 22);
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
 * changes by less than 2^(mantissa + 17), at most 2^31. Where that is not so, or the face is thin,
 * it is tested. Drops are from 10 to 38; of light, from 6 to 28. */
bool fxl_corner_planes_linear(const fxl_corner_planes *planes, const int32_t light[3],
                              fxl_gradients *gradients, fxl_depth_plane *depth)
{
    static const fxl_gradient constant = {FXL_CONSTANT_WEIGHT, 0, 0};
    const int32_t *weights = planes->weights;
    const fxl_depth_scale scale = fxl_depth_scale_of(planes->lens);
    const unsigned zeros = fxl_leading_zeros(planes->weight_most);
    const int number = planes->weight_exponent + (int)zeros - 32;
    const int crossed =
        (int)fxl_leading_zeros(planes->weight_most - planes->weight_range) - (int)zeros;
    const uint32_t least = planes->weight_most - planes->weight_range;
    const uint64_t error = fxl_product_unsigned(range_of(light), planes->weight_range);
    if (!planes->is_triangle || scale.mantissa > 14 || number < 0 || crossed > 1 ||
        number + crossed >= scale.octaves ||
        error > fxl_product_unsigned(least, 4u * FXL_WORDS_ERROR_LIGHT)) {
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
    const int32_t more = error > fxl_product_unsigned(least, 4u * FXL_AFFINE_ERROR_LIGHT)
                             ? mean_of_error(planes, d1, d2)
                             : 0;
    find_words(planes, (uint32_t)(light[0] + more) << 8, along, down, drop,
               &gradients->attributes[0]);
    gradients->shifts[0] = 53;
    gradients->count = 1;
    gradients->weight = constant;
    gradients->weight_min[0] = gradients->weight_min[1] = 1;

    d1 = weights[1] - weights[0];
    d2 = weights[2] - weights[0];
    along = fxl_product(d1, across[0]) + fxl_product(d2, across[1]);
    down = fxl_product(d1, below[0]) + fxl_product(d2, below[1]);
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
        int32_t slope;
        scale(values[i], shift);
        gradients->shifts[i] =
            (int8_t)(61 - (int)shift -
                     plane_of(planes, values[i], &gradients->attributes[i], &slope));
    }
}

/* The weights that suffice for segments (gradients.h). Of an attribute u and the weight w, each at
 * most 2^30 at the corners, the twist u' w - w' u, where ' is the change a pixel along the row, is
 * the same along a row and linear down the rows: its largest value is at a corner. What is cut off
 * the slopes and the twist is less than 2 units of its upper word.
 *
 * The rows of other vertices may be beyond those of the three corners, by at most as many as all
 * rows of the box are more: so the twist grows by its range over the corners, times that part. As
 * the triangle fills 1/16 of the box, the three corners have at least 1/8 of its rows, 2^11 units:
 * the part is at most 7. An eighth of the sum is below 2^31 such units. */
typedef struct {
    uint32_t growth; /* that part, in 1/16, rounded up; at most 127 */
    fxl_real most;   /* of all attributes; times 2^(64 - planes->exponent) */
} twists;

static inline void begin_twists(const fxl_corner_planes *planes, twists *of)
{
    of->growth = 0;
    of->most.mantissa = 0;
    of->most.exponent = INT16_MIN;
    if (!planes->is_triangle) {
        const fxl_screen_point *p = planes->corners->points;
        int32_t top = p[0].y, bottom = top;
        for (uint32_t i = 1; i < 3; i++) {
            top = p[i].y < top ? p[i].y : top;
            bottom = p[i].y > bottom ? p[i].y : bottom;
        }
        const int32_t rows = bottom - top, more = planes->corners->height - rows;
        if (more > 0) {
            const unsigned zeros = fxl_leading_zeros((uint32_t)rows); /* 9..20 */
            const uint32_t part =
                fxl_divide_half((uint32_t)more << 9, (uint32_t)rows << zeros >> 16);
            of->growth = (part >> (21u - zeros)) + 1u;
        }
    }
}

/* values: u times the weight, times 2^shift. */
static inline void add_twist(const fxl_corner_planes *planes, const int32_t values[3],
                             int32_t slope, int shift, twists *of)
{
    int32_t least = INT32_MAX, most = INT32_MIN; /* upper words, below 2^30 */
    for (uint32_t i = 0; i < 3; i++) {
        const int32_t twist = (int32_t)((uint64_t)(fxl_product(slope, planes->weights[i]) -
                                                   fxl_product(planes->weight_slope, values[i])) >>
                                        32);
        least = twist < least ? twist : least;
        most = twist > most ? twist : most;
    }
    uint32_t number = ((uint32_t)(most > -least ? most : -least) + 2u) / 8u + 1u;
    if (of->growth != 0) {
        number += (((uint32_t)(most - least) + 4u) / 128u + 1u) * of->growth;
    }
    const unsigned zeros = fxl_leading_zeros(number);
    const int exponent = 35 - (int)zeros - shift;
    const uint32_t mantissa = number << zeros;
    if (exponent > of->most.exponent ||
        (exponent == of->most.exponent && mantissa > of->most.mantissa)) {
        of->most.mantissa = mantissa;
        of->most.exponent = exponent;
    }
}

/* A part of a weight, in 1/65536. */
static inline uint32_t weight_part(uint32_t weight, uint32_t part, uint32_t root)
{
    const uint32_t parts = (uint32_t)(fxl_product_unsigned(part, root) >> 16) + 1u;
    return (uint32_t)(fxl_product_unsigned(weight, parts) >> 16) + 1u;
}

/* With T the twist and w the largest weight, the rule of gradients.h asks for weights of 9
 * 2^(-11/3) r^(1/3) of w for 16 pixels, r = 2^-8 (64/27) T |w'| / w^3, and of (r / 16)^(1/3) for 4.
 * Here r is 16/15 of that: attributes are within 0.29 of their unit. r is at most 2^bits x, 1 <= x
 * < 2, and the root of x is below its tangent at 2^(1/2), by less than 1/70. More than w is what no
 * pixel has. Of what changes by 2^21 a pixel or more no weight suffices: the ends might overflow.
 *
 * The upper bits of weight, change and mantissa are 1. What is cut off a product is less than 3
 * units, which are added to it; of a quotient from 2^14 to 2^16 less than 2, with what is cut off
 * its denominator. */
static void find_least(const fxl_corner_planes *planes, const fxl_real *twist,
                       uint32_t weight_min[2])
{
    static const uint32_t parts[7] = {18432, 23223, 29259, 36864, 46446, 58518, 73728};
    const int32_t slope = planes->weight_slope;
    const uint32_t change = (uint32_t)(slope ^ (slope >> 31)) + 1u, most = planes->weight_most;
    const uint32_t unit = (uint32_t)((uint64_t)most << planes->gradient_exponent >> 32);
    const int change_zeros = (int)fxl_leading_zeros(change);
    const int zeros = (int)fxl_leading_zeros(most);
    const uint32_t weight = most << zeros;
    const uint32_t product =
        fxl_upper_product_unsigned(
            fxl_upper_product_unsigned(twist->mantissa, change << change_zeros),
            2714843527u) + /* (16/15) (64/27) in 2^-30, and a unit */
        3u;
    const uint32_t cube =
        fxl_upper_product_unsigned(fxl_upper_product_unsigned(weight, weight), weight);
    const int product_zeros = (int)fxl_leading_zeros(product);
    const int cube_zeros = (int)fxl_leading_zeros(cube);
    const int step = 34 + twist->exponent - planes->exponent + 2 * zeros;
    int bits = 58 + twist->exponent - 2 * planes->exponent - change_zeros + 3 * zeros + cube_zeros -
               product_zeros;
    uint32_t x =
        fxl_divide_half(product << product_zeros >> 1, cube << cube_zeros >> 16) + 2u; /* 2^-15 */
    if (x < 32768u) {
        x *= 2u;
        bits--;
    }
    if (bits < -4) {
        bits = -4;
        x = 32768;
    }
    const uint32_t root = (x * 17339u >> 15) + 49042u;
    weight_min[0] = weight_min[1] = (uint32_t)1 << 31;
    if (step <= 21) {
        if (bits <= 2) {
            weight_min[0] = weight_part(unit, parts[bits + 4], root);
        }
        if (bits <= 6) {
            weight_min[1] = weight_part(unit, parts[bits < 0 ? 0 : bits], root);
        }
    }
}

/* The attributes are scaled to less than 2^31, and their products with the weights are below 2^29.
 */
static void find_perspective(const fxl_corner_planes *planes, int32_t (*values)[3],
                             fxl_gradients *gradients)
{
    twists of;
    begin_twists(planes, &of);
    gradients->weight = planes->weight;
    for (uint32_t i = 0; i < gradients->count; i++) {
        const int shift = (int)room_of(values[i]) - 1;
        int32_t slope;
        for (uint32_t k = 0; k < 3; k++) {
            values[i][k] =
                fxl_upper_product((int32_t)((uint32_t)values[i][k] << shift), planes->weights[k]);
        }
        gradients->shifts[i] =
            (int8_t)(32 - shift + planes->gradient_exponent -
                     plane_of(planes, values[i], &gradients->attributes[i], &slope));
        add_twist(planes, values[i], slope, shift, &of);
    }
    find_least(planes, &of.most, gradients->weight_min);
}

void fxl_corner_planes_find(fxl_corner_planes *planes, int32_t (*values)[3], uint32_t count,
                            bool is_affine, fxl_gradients *gradients)
{
    uint32_t ranges[FXL_ATTRIBUTES];
    gradients->count = (uint8_t)count;
    if (!is_affine) {
        for (uint32_t i = 0; i < count; i++) {
            ranges[i] = range_of(values[i]);
        }
        is_affine = is_nearly_affine(planes, ranges, count, planes->weight_range);
    }
    locate(planes);
    if (is_affine) {
        find_affine(planes, values, gradients);
    } else {
        find_weight(planes);
        find_perspective(planes, values, gradients);
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

/* SPDX-License-Identifier: MIT */
/* The weight, the depth and the attributes of a small face, in 64 bits. */
#include "corner_planes.h"

#include "../math/product.h"
#include "light_row.h"

/* value / 2^drop, rounded down, for 0 <= drop <= 31, by words: cores have no shift of 64 bits. */
static inline int64_t shifted(int64_t value, unsigned drop)
{
    if (FXL_IS_SMALL) {
        return fxl_shifted_down(value, drop);
    }
    const uint32_t high = (uint32_t)((uint64_t)value >> 32);
    const uint32_t low = (uint32_t)value >> drop | high << 1 << (31u - drop);
    return (int64_t)((uint64_t)(uint32_t)((int32_t)high >> drop) << 32 | low);
}

/* How far the pixels of 0 to `end` are at most from one of them, or one beside them, and one more.
 */
static inline uint32_t farthest(int32_t pixel, int32_t end)
{
    return (uint32_t)(2 * pixel > end ? pixel : end - pixel) + 1u;
}

/* Where the face is on the screen. Not inline: it saves flash in three places. */
/* SPEC 9.1.1 */
static __attribute__((noinline)) void locate(fxl_corner_planes *planes)
{
    if (!planes->is_located) {
        const fxl_screen_point *p = planes->corners->points;
        planes->columns = farthest(p[0].x >> 16, (planes->lens->width + 15) & ~15);
        planes->rows = farthest(p[0].y >> 16, planes->lens->height);
        planes->is_located = true;
    }
}

/* --- a value -------------------------------------------------------------------------------- */

/* What a gradient changes from the centre of pixel (0, 0) to corner 0; its steps are rounded down to
 * 2^-16. By their words, a core with long products takes fewer instructions: steps are below 2^62, and
 * x and y below 2^27, so the sum of upper products is below 2^58, and what is shifted wraps as all does. */
static inline int64_t off(const fxl_corner_planes *planes, const fxl_gradient *gradient)
{
    const int64_t along = gradient->along, down = gradient->down;
#if FXL_CORE_ARMV7M
    const int64_t upper = fxl_product((int32_t)(along >> 32), planes->x) +
                          fxl_product((int32_t)(down >> 32), planes->y);
    return (int64_t)((uint64_t)upper << 16) +
           fxl_product((int32_t)((uint32_t)along >> 16), planes->x) +
           fxl_product((int32_t)((uint32_t)down >> 16), planes->y);
#else
    return fxl_product_wide(along >> 16, planes->x) + fxl_product_wide(down >> 16, planes->y);
#endif
}

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
    gradient->at = (int64_t)((uint64_t)(int64_t)values[0] << exponent) - off(planes, gradient);
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

/* --- attributes ----------------------------------------------------------------------------- */

/* Whether a constant weight changes no attribute by more than FXL_AFFINE_ERROR_TEXEL, or
 * FXL_AFFINE_ERROR_LIGHT: light is the last of an odd number. Ranges of attributes are below 2^31, that
 * of the weights below 2^30. */
/* SPEC 9.1.1 */
static bool is_nearly_affine(const fxl_corner_planes *planes, int32_t (*values)[3], uint32_t count)
{
    const uint32_t range = planes->weight_range, least = planes->weight_most - range;
    const unsigned part = planes->is_triangle ? 0 : 3;
    for (uint32_t i = 0; i < count; i++) {
        const uint32_t error =
            i % 2 == 0 && i + 1 == count ? FXL_AFFINE_ERROR_LIGHT : FXL_AFFINE_ERROR_TEXEL;
        if (fxl_product_unsigned(fxl_range_of(values[i]), range) >
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
    FXL_EACH_CORNER
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
        FXL_EACH_CORNER
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
    gradients->count = (uint8_t)count;
    if (is_affine || is_nearly_affine(planes, values, count)) {
        locate(planes);
        find_affine(planes, values, gradients);
    } else {
        find_weight(planes);
        find_perspective(planes, values, gradients);
    }
}

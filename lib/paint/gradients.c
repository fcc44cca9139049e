/* SPDX-License-Identifier: MIT */
/* A point of a face is V = P0 + s E1 + t E2, of three corners P0, P0 + E1, P0 + E2. On the screen
 * it is seen along D = (x - centre, centre - y, focal), and V is a multiple of D. So, by Cramer's
 * rule, with n = E1 x E2:
 *
 *   s = (E2 x P0) . D / (n . D),   t = (P0 x E1) . D / (n . D),
 *   a = a0 + s (a1 - a0) + t (a2 - a0) = A . D / (n . D),
 *   A = a0 n + (a1 - a0) (E2 x P0) + (a2 - a0) (P0 x E1),
 *
 * and n . D is h focal / z, where h = n . P0. */
#include "../math/arith.h"
#include "../math/family.h"
#include "../view/project.h"
#include "../view/view.h"
#include "fixel/surfaces.h"
#include "gradients.h"

/* --- vectors -------------------------------------------------------------------------------- */

/* The bits of a value without its sign: one less than those of its magnitude where that is a power
 * of two below 0. */
static uint64_t bits_of(int64_t value)
{
    return (uint64_t)(value ^ (value >> 63));
}

/* value * 2^shift / 2^32, rounded to nearest. Requires |value * 2^shift| <= 2^62. */
static FXL_ONE_COPY int32_t upper_word(int64_t value, unsigned shift)
{
    return (int32_t)(fxl_signed_64((fxl_bits_64(value) << shift) + 0x80000000u) >> 32);
}

fxl_block_vector fxl_block(int64_t x, int64_t y, int64_t z, int exponent)
{
    const unsigned bits = fxl_bit_length(bits_of(x) | bits_of(y) | bits_of(z));
    const unsigned shift = bits == 0 ? 32 : 62u - bits;
    const fxl_block_vector result = {upper_word(x, shift), upper_word(y, shift),
                                     upper_word(z, shift), exponent + 32 - (int)shift};
    return result;
}

FXL_ONCE fxl_block_vector difference(const fxl_view_point *a, const fxl_view_point *b)
{
    return fxl_block(a->x - b->x, a->y - b->y, a->z - b->z, 0);
}

/* Products are at most 2^60, so differences of two are at most 2^61. */
static fxl_block_vector cross(const fxl_block_vector *a, const fxl_block_vector *b)
{
    return fxl_block((int64_t)a->y * b->z - (int64_t)a->z * b->y,
                     (int64_t)a->z * b->x - (int64_t)a->x * b->z,
                     (int64_t)a->x * b->y - (int64_t)a->y * b->x, a->exponent + b->exponent);
}

static void negate(fxl_block_vector *vector)
{
    vector->x = -vector->x;
    vector->y = -vector->y;
    vector->z = -vector->z;
}

/* factors[0] vectors[0] + factors[1] vectors[1] + factors[2] vectors[2]. The first factor is below
 * 2^30 and the others are below 2^31, so halves of the terms have a sum below 2^59 + 2 * 2^60.
 * Error: that of block, and one of 2^-58 of the largest term for each term. */
/* accuracy 5.1 */
static fxl_block_vector combine(const fxl_block_vector vectors[3], const int32_t factors[3])
{
    int64_t x = 0, y = 0, z = 0;
    int exponent = INT32_MIN;
    for (unsigned i = 0; i < 3; i++) {
        if (factors[i] != 0 && vectors[i].exponent > exponent) {
            exponent = vectors[i].exponent;
        }
    }
    for (unsigned i = 0; i < 3; i++) {
        const fxl_block_vector *vector = &vectors[i];
        if (factors[i] == 0 || exponent - vector->exponent > 61) {
            continue;
        }
        const unsigned drop = (unsigned)(exponent - vector->exponent) + 1;
        x += fxl_shifted_down((int64_t)factors[i] * vector->x, drop);
        y += fxl_shifted_down((int64_t)factors[i] * vector->y, drop);
        z += fxl_shifted_down((int64_t)factors[i] * vector->z, drop);
    }
    return fxl_block(x, y, z, exponent == INT32_MIN ? 0 : exponent + 1);
}

/* --- gradients ------------------------------------------------------------------------------ */

/* The columns and rows of which values are bounded: of pixels, and one more row. */
/* accuracy 5.1 */
static int32_t columns_of(const fxl_lens *lens)
{
    return (int32_t)((lens->width + 15u) & ~15u);
}

static uint64_t largest_value(const fxl_gradient *gradient, const fxl_lens *lens)
{
    const int64_t along = gradient->along * columns_of(lens);
    const int64_t down = gradient->down * lens->height;
    return bits_of(gradient->at) | bits_of(gradient->at + along) | bits_of(gradient->at + down) |
           bits_of(gradient->at + along + down);
}

static FXL_ONE_COPY void shift_up(int64_t *value, unsigned shift)
{
    *value = fxl_signed_64(fxl_bits_64(*value) << shift);
}

/* The focal length is below 2^29 and half of the screen below 2^25 + 2^15, in 16.16, and
 * an off-centre lens's centre is below 2^28: products are below 2^59, so all sums are below 2^61.
 * Exact: shifted to the left alone. */
/* SPEC 9.1 */
int fxl_gradient_of_plane(fxl_block_vector vector, const fxl_view *view, fxl_gradient *gradient)
{
    const fxl_projection *projection = &view->projection;
    gradient->along = (int64_t)vector.x * 65536;
    gradient->down = (int64_t)vector.y * -65536;
    gradient->at = fxl_multiply_s32(vector.z, fxl_view_drawn_focal(view)) +
                   fxl_multiply_s32(vector.x, 32768 - projection->centre_x) +
                   fxl_multiply_s32(vector.y, projection->centre_y - 32768);
    const unsigned bits = fxl_bit_length(largest_value(gradient, &view->lens));
    if (bits == 0) {
        return 0;
    }
    FXL_ASSERT(bits <= 62);
    const unsigned shift = 62 - bits;
    shift_up(&gradient->along, shift);
    shift_up(&gradient->down, shift);
    shift_up(&gradient->at, shift);
    return vector.exponent - (int)(62 - bits);
}

/* --- segments ------------------------------------------------------------------------------- */

/* At least number * 2^exponent, and at most 2^-30 of it more. Requires 0 < number < 2^63. */
/* surfaces 2.1 */
static FXL_ONE_COPY fxl_real bound_of(uint64_t number, int exponent)
{
    const int drop = (int)fxl_bit_length(number) - 32;
    const uint64_t mantissa = (number << (32 - drop) >> 32) + (drop > 0 ? 1 : 0);
    const int carry = (int)(mantissa >> 32);
    const fxl_real bound = {(uint32_t)(mantissa >> carry), exponent + drop + carry};
    return bound;
}

static bool is_above(const fxl_real *a, const fxl_real *b)
{
    return a->exponent != b->exponent ? a->exponent > b->exponent : a->mantissa > b->mantissa;
}

/* The upper word at the beginning of a row. */
FXL_ONCE int32_t upper_at(const fxl_gradient *gradient, int32_t row)
{
    return (int32_t)((gradient->at + row * gradient->down) >> 32);
}

/* Of an attribute u, |u' w - w' u| 2^shift, where ' is the change a pixel along the row: it is
 * linear in the row and the same along it. The slopes are cut to 31 bits; so products are below
 * 2^61. What is cut off the four factors changes the difference by less than 2^33. */
static fxl_real twist_of(const fxl_gradient *u, int shift, const fxl_gradient *w, int32_t height)
{
    const unsigned bits = fxl_bit_length(fxl_magnitude(u->along) | fxl_magnitude(w->along));
    const unsigned drop = bits > 31 ? bits - 31 : 0;
    const int32_t u_slope = (int32_t)fxl_shifted_down(u->along, drop);
    const int32_t w_slope = (int32_t)fxl_shifted_down(w->along, drop);
    const int64_t top =
        fxl_multiply_s32(u_slope, upper_at(w, 0)) - fxl_multiply_s32(w_slope, upper_at(u, 0));
    const int64_t bottom = fxl_multiply_s32(u_slope, upper_at(w, height)) -
                           fxl_multiply_s32(w_slope, upper_at(u, height));
    const uint64_t larger =
        fxl_magnitude(top) > fxl_magnitude(bottom) ? fxl_magnitude(top) : fxl_magnitude(bottom);
    return bound_of(larger + ((uint64_t)1 << 33), (int)drop - 32 + shift);
}

/* The least c with c^3 >= value. Requires 0 < value <= 2^30. */
static uint32_t cube_root_up(uint32_t value)
{
    uint32_t root = 0;
    for (uint32_t bit = 512; bit != 0; bit >>= 1) {
        const uint32_t c = root | bit;
        if (c * c * c < value) {
            root = c;
        }
    }
    return root + 1;
}

/* number * 2^exponent, rounded up; at least 1, and 2^31 where it would be more. Requires
 * 0 < number < 2^16. */
static uint32_t power_up(uint32_t number, int exponent)
{
    if (exponent > 0) {
        return exponent > 30 || number >> (31 - exponent) != 0 ? (uint32_t)1 << 31
                                                               : number << exponent;
    }
    return exponent < -16 ? 1 : ((number - 1) >> -exponent) + 1;
}

/* floor(number / 3) of a number above -600. */
static int third(int number)
{
    return (number + 600) / 3 - 200;
}

/* weight * part / 2^16, rounded up. Requires a part below 2^21, so the product is below 2^53; and a
 * result below 2^32. */
static uint32_t times_part(uint32_t weight, uint32_t part)
{
    return (uint32_t)((fxl_multiply_u32(weight, part) + 65535u) >> 16);
}

/* The least weight, at both ends, of a segment of n = 16 pixels, and of one of n = 4, that is
 * divided at its ends alone. Between ends w0 and w1 >= w0 the linear u is off by at most |u1 - u0|
 * (w1 - w0) / (4 w0) = n^2 twist |w'| / (4 w0 w0 w1), which has to be at most 2^19 / 27: so w0^3
 * has to be at least 27 n^2 2^-21 twist |w'|. And |u1 - u0| = n twist / (w0 w1) has to be at most
 * 2^29, so that an end outside of the face does not overflow: w0^2 at least n 2^-29 twist, of which
 * the root's bound is a power of two. For n = 4 the first weight is that of 16 times 16^(-1/3), and
 * the second one half of it. */
/* accuracy 5.2 */
static void find_least_weights(const fxl_real *twist, const fxl_gradient *weight,
                               uint32_t weight_min[2])
{
    const fxl_real slope = bound_of(fxl_magnitude(weight->along) + 1, -32);
    /* From 2^62 to 2^64, and 27/32 of that. A number of 25 to 30 bits is left for the
     * root. */
    const uint64_t product = fxl_multiply_u32(twist->mantissa, slope.mantissa);
    const uint64_t bend = product - (product >> 3) - (product >> 5); /* 27/32 */
    const int bend_exponent = twist->exponent + slope.exponent + 8 - 16 + 36;
    const int root_exponent = third(bend_exponent);
    const unsigned spare = (unsigned)(bend_exponent - 3 * root_exponent); /* 0..2 */
    const uint32_t root = cube_root_up((uint32_t)(bend >> (36 - spare)) + 1);
    const uint32_t by_bend = power_up(root, root_exponent);
    const int far = twist->exponent + 32 + 4 - 29; /* w0^2 >= 2^far */
    const int far_exponent = (far + 601) / 2 - 300;
    const uint32_t by_far = power_up(1, far_exponent);
    /* 25.4 is 64 times 16^(-1/3), rounded up; the root is at most 2^10. */
    const uint32_t bend_of_4 = power_up(times_part(root, 1664511u), root_exponent - 6);
    const uint32_t far_of_4 = power_up(1, far_exponent - 1);
    weight_min[0] = by_bend > by_far ? by_bend : by_far;
    weight_min[1] = bend_of_4 > far_of_4 ? bend_of_4 : far_of_4;
}

/* A segment of 8 has 4^(-1/3) = 0.62996 of the first weight of 16 and 2^(-1/2) of its second one.
 * Of that of 4 the two are 2^(2/3) and 2^(1/2). So the larger one of 0.62997 of that of 16, which
 * is right if the first one is the larger of 16 and of 4, and 1.41423 of that of 4 is right for
 * both. A weight
 * of 2^31 may be less than what 16 columns ask for: then 1.58746 of that of 4. */
/* accuracy 5.2 */
void fxl_find_least_weights(const fxl_gradients *gradients, uint32_t division, uint32_t least[3])
{
    const uint32_t of_16 = gradients->weight_min[0], of_4 = gradients->weight_min[1];
    const uint32_t by_16 = times_part(of_16, 41286u), by_4 = times_part(of_4, 92683u);
    const uint32_t of_8 = of_16 >> 31 != 0 ? times_part(of_4, 104036u)
                          : by_16 > by_4   ? by_16
                                           : by_4;
    least[0] = least[1] = least[2] = UINT32_MAX;
    if (division == FXL_DIVIDE_16) {
        least[0] = of_16;
        least[1] = of_8;
        least[2] = of_4;
    } else if (division == FXL_DIVIDE_8) {
        least[1] = of_16;
        least[2] = of_8;
    }
}

/* --- a face --------------------------------------------------------------------------------- */

FXL_ONCE bool is_zero(const fxl_gradient *gradient)
{
    return (gradient->at | gradient->along | gradient->down) == 0;
}

/* Finds weight_min, from all else, for all rows of the screen. */
static void find_least(fxl_gradients *gradients, int32_t height)
{
    fxl_real twist = {0, INT16_MIN};
    for (uint32_t i = 0; i < FXL_ATTRIBUTES && i < gradients->count; i++) {
        const fxl_gradient *attribute = &gradients->attributes[i];
        if (!is_zero(attribute)) {
            const fxl_real own =
                twist_of(attribute, gradients->shifts[i], &gradients->weight, height);
            twist = is_above(&own, &twist) ? own : twist;
        }
    }
    gradients->weight_min[0] = gradients->weight_min[1] = 1;
    if (twist.mantissa != 0) {
        find_least_weights(&twist, &gradients->weight, gradients->weight_min);
    }
}

/* The least shift: fxl_texture_level_choose takes up to 8 from it, and a byte holds -128. */
#define SHIFT_LEAST (-112)

/* A shift as a byte holds it, below those of words. That of corners nearly on a line may be another
 * one: fxl_attribute_of takes all from 62 on as one, and all from -32 down. */
static int8_t shift_of(int shift)
{
    return (int8_t)(shift > FXL_SHIFT_MOST ? FXL_SHIFT_MOST
                    : shift < SHIFT_LEAST  ? SHIFT_LEAST
                                           : shift);
}

/* SPEC 9.1 */
void fxl_gradients_find(const fxl_gradient_corners *face, const fxl_view *view,
                        fxl_gradients *gradients)
{
    const fxl_view_point *corners = face->corners;
    const fxl_block_vector first = fxl_block(corners[0].x, corners[0].y, corners[0].z, 0);
    const fxl_block_vector edge_1 = difference(&corners[1], &corners[0]);
    const fxl_block_vector edge_2 = difference(&corners[2], &corners[0]);
    fxl_block_vector vectors[3] = {cross(&edge_1, &edge_2), cross(&edge_2, &first),
                                   cross(&first, &edge_1)};
    /* Three products of at most 2^60: below 2^62. */
    const int64_t volume = fxl_multiply_s32(vectors[0].x, first.x) +
                           fxl_multiply_s32(vectors[0].y, first.y) +
                           fxl_multiply_s32(vectors[0].z, first.z);
    gradients->volume.number = (int64_t)fxl_magnitude(volume);
    gradients->volume.exponent = vectors[0].exponent + first.exponent;
    if (volume < 0) {
        for (unsigned i = 0; i < 3; i++) {
            negate(&vectors[i]);
        }
    }
    const int weight_exponent = fxl_gradient_of_plane(vectors[0], view, &gradients->weight);
    gradients->count = (uint8_t)face->count;
    for (uint32_t i = 0; i < face->count; i++) {
        const int32_t *values = face->values[i];
        const int32_t factors[3] = {values[0], values[1] - values[0], values[2] - values[0]};
        fxl_gradient *attribute = &gradients->attributes[i];
        const int exponent = fxl_gradient_of_plane(combine(vectors, factors), view, attribute);
        gradients->shifts[i] = is_zero(attribute) ? 0 : shift_of(exponent - weight_exponent);
    }
    find_least(gradients, view->lens.height);
}

/* Differences are at most 2^26, so products are at most 2^52. */
static bool on_one_line(const fxl_screen_point points[3])
{
    const int64_t x1 = points[1].x - points[0].x, y1 = points[1].y - points[0].y;
    const int64_t x2 = points[2].x - points[0].x, y2 = points[2].y - points[0].y;
    return x1 * y2 == x2 * y1;
}

/* SPEC 9.3 */
bool fxl_corners_make_affine(fxl_gradient_corners *face, const fxl_view *view)
{
    const fxl_projection *projection = &view->projection;
    fxl_screen_point points[3];
    for (uint32_t i = 0; i < 3; i++) {
        if (fxl_project_visible(projection, &face->corners[i], &points[i]) != FXL_OK ||
            points[i].x < 0 || points[i].x > (int32_t)view->lens.width * 65536 || points[i].y < 0 ||
            points[i].y > (int32_t)view->lens.height * 65536) {
            return false;
        }
    }
    if (on_one_line(points)) {
        return false;
    }
    for (uint32_t i = 0; i < 3; i++) {
        face->corners[i].x = points[i].x - projection->centre_x;
        face->corners[i].y = projection->centre_y - points[i].y;
        face->corners[i].z = fxl_view_drawn_focal(view);
    }
    return true;
}

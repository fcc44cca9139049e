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
#include "gradients.h"

#include "../../src/math/arith.h"
#include "../../src/math/square_root.h"

/* --- vectors -------------------------------------------------------------------------------- */

/* A vector (x, y, z) * 2^exponent. The components are at most 2^30; one is at least 2^29, or all
 * are 0. */
typedef struct {
    int32_t x, y, z;
    int exponent;
} block_vector;

/* value / 2^bits, rounded to nearest, or value * 2^-bits. Requires a result of at most 2^31. */
static int32_t scaled(int64_t value, int bits)
{
    return (int32_t)(bits > 0 ? fxl_round_shift(value, (unsigned)bits) : value * (1 << -bits));
}

/* Requires components below 2^63. Error: half a unit of each component, at most 2^-30 of the
 * largest. */
static block_vector block(int64_t x, int64_t y, int64_t z, int exponent)
{
    const unsigned bits = fxl_bit_length(fxl_magnitude(x) | fxl_magnitude(y) | fxl_magnitude(z));
    const int drop = bits == 0 ? 0 : (int)bits - 30; /* -29..33 */
    const block_vector result = {scaled(x, drop), scaled(y, drop), scaled(z, drop),
                                 exponent + drop};
    return result;
}

static block_vector difference(const fxl_view_point *a, const fxl_view_point *b)
{
    return block(a->x - b->x, a->y - b->y, a->z - b->z, 0);
}

/* Products are at most 2^60, so differences of two are at most 2^61. */
static block_vector cross(const block_vector *a, const block_vector *b)
{
    return block((int64_t)a->y * b->z - (int64_t)a->z * b->y,
                 (int64_t)a->z * b->x - (int64_t)a->x * b->z,
                 (int64_t)a->x * b->y - (int64_t)a->y * b->x, a->exponent + b->exponent);
}

static void negate(block_vector *vector)
{
    vector->x = -vector->x;
    vector->y = -vector->y;
    vector->z = -vector->z;
}

/* factors[0] vectors[0] + factors[1] vectors[1] + factors[2] vectors[2]. The first factor is below
 * 2^30 and the others are below 2^31, so a sum is below 2^60 + 2 * 2^61. Error: that of block, and
 * one of 2^-59 of the largest term for each term that is shifted. */
static block_vector combine(const block_vector vectors[3], const int32_t factors[3])
{
    int64_t x = 0, y = 0, z = 0;
    int exponent = INT32_MIN;
    for (unsigned i = 0; i < 3; i++) {
        if (factors[i] != 0 && vectors[i].exponent > exponent) {
            exponent = vectors[i].exponent;
        }
    }
    for (unsigned i = 0; i < 3; i++) {
        const block_vector *vector = &vectors[i];
        if (factors[i] == 0 || exponent - vector->exponent > 62) {
            continue;
        }
        const unsigned drop = (unsigned)(exponent - vector->exponent);
        x += (int64_t)factors[i] * vector->x >> drop;
        y += (int64_t)factors[i] * vector->y >> drop;
        z += (int64_t)factors[i] * vector->z >> drop;
    }
    return block(x, y, z, exponent == INT32_MIN ? 0 : exponent);
}

/* --- gradients ------------------------------------------------------------------------------ */

/* The columns and rows of which values are bounded: of pixels, and one more row. */
static int32_t columns_of(const fxl_lens *lens)
{
    return (int32_t)((lens->width + 15u) & ~15u);
}

static uint64_t largest_value(const fxl_gradient *gradient, const fxl_lens *lens)
{
    const int64_t along = gradient->along * columns_of(lens);
    const int64_t down = gradient->down * lens->height;
    return fxl_magnitude(gradient->at) | fxl_magnitude(gradient->at + along) |
           fxl_magnitude(gradient->at + down) | fxl_magnitude(gradient->at + along + down);
}

/* vector . D, scaled so that its largest value on the screen is from 2^61 to 2^62. Returns the
 * exponent. The focal length is below 2^29 and half of the screen below 2^25 + 2^15, in 16.16, and
 * an off-centre lens's centre is below 2^28: products are below 2^59, so all sums are below 2^61.
 * Exact: shifted to the left alone. */
static int find_gradient(block_vector vector, const fxl_view *view, fxl_gradient *gradient)
{
    const fxl_projection *projection = &view->projection;
    gradient->along = (int64_t)vector.x * 65536;
    gradient->down = (int64_t)vector.y * -65536;
    gradient->at = fxl_multiply_s32(vector.z, view->lens.focal) +
                   fxl_multiply_s32(vector.x, 32768 - projection->centre_x) +
                   fxl_multiply_s32(vector.y, projection->centre_y - 32768);
    const unsigned bits = fxl_bit_length(largest_value(gradient, &view->lens));
    if (bits == 0) {
        return 0;
    }
    FXL_ASSERT(bits <= 62);
    const int64_t scale = (int64_t)1 << (62 - bits);
    gradient->along *= scale;
    gradient->down *= scale;
    gradient->at *= scale;
    return vector.exponent - (int)(62 - bits);
}

/* --- segments ------------------------------------------------------------------------------- */

/* The least c with c^3 >= value. Requires value <= 2^30 + 1. */
static uint32_t cube_root_up(uint32_t value)
{
    uint32_t root = 0;
    for (uint32_t bit = 1024; bit != 0; bit >>= 1) {
        const uint32_t c = root | bit;
        if (c <= 1024 && c * c * c < value) {
            root = c;
        }
    }
    return root + 1;
}

/* number * 2^exponent, rounded up; UINT32_MAX where it is 2^31 or more. Requires number < 2^31. */
static uint32_t power_up(uint32_t number, int exponent)
{
    if (exponent > 31 || (exponent > 0 && number >> (31 - exponent) != 0)) {
        return UINT32_MAX;
    }
    return exponent >= 0 ? number << exponent : exponent < -31 ? 1 : (number >> -exponent) + 1;
}

/* The exponents that number * 2^exponent needs so that the number has so many bits, or up to
 * step - 1 fewer, and the exponent is a multiple of step. Rounded up. */
static uint32_t aligned(uint64_t number, unsigned bits, int step, int *exponent)
{
    int drop = (int)fxl_bit_length(number) - (int)bits;
    while ((*exponent + drop) % step != 0) {
        drop++;
    }
    *exponent += drop;
    return drop > 0 ? (uint32_t)(number >> drop) + 1 : (uint32_t)(number << -drop);
}

/* A bound of |u' w - w' u| / 2^exponent, where ' is the change a pixel along the row: it is linear
 * in the row and the same along it. slopes: u' and w' in 2^(shift - 32), below 2^31. Products are
 * below 2^61. What the cut bits of the four factors may change is below 2^33. */
static uint64_t largest_twist(const fxl_gradients *gradients, uint32_t attribute,
                              const int32_t slopes[2], const fxl_lens *lens)
{
    const fxl_gradient *u = &gradients->attributes[attribute], *w = &gradients->weight;
    uint64_t largest = 0;
    for (int32_t end = 0; end < 2; end++) {
        const int64_t row = end * (int64_t)lens->height;
        const int32_t u_value = (int32_t)((u->at + row * u->down) >> 32);
        const int32_t w_value = (int32_t)((w->at + row * w->down) >> 32);
        const uint64_t twist = fxl_magnitude(fxl_multiply_s32(slopes[0], w_value) -
                                             fxl_multiply_s32(slopes[1], u_value));
        largest = twist > largest ? twist : largest;
    }
    return largest + ((uint64_t)1 << 33);
}

/* The least weight, at both ends, of a segment of n = 2^log pixels that is divided at its ends
 * alone. Between ends w0 and w1 >= w0 the linear u is off by at most
 *   |u1 - u0| (w1 - w0) / (4 w0) = n^2 |u' w - w' u| |w'| / (4 w0 w0 w1) 2^shift,
 * which has to be at most 2^15; and |u1 - u0| = n |u' w - w' u| / (w0 w1) 2^shift at most 2^29, so
 * that an end outside of the face does not overflow. */
static uint32_t least_weight(const fxl_gradients *gradients, uint32_t attribute, int log,
                             const fxl_lens *lens)
{
    const int64_t u_slope = gradients->attributes[attribute].along;
    const int64_t w_slope = gradients->weight.along;
    const int bits = (int)fxl_bit_length(fxl_magnitude(u_slope) | fxl_magnitude(w_slope));
    const int drop = bits > 31 ? bits - 31 : 0;
    const int32_t slopes[2] = {(int32_t)(u_slope >> drop), (int32_t)(w_slope >> drop)};
    int twist_exponent = drop - 32 + gradients->shifts[attribute];
    uint64_t twist = largest_twist(gradients, attribute, slopes, lens);
    const int spare = (int)fxl_bit_length(twist) - 32;
    twist = (twist >> spare) + 1; /* spare is at least 2; at most 2^32 */
    twist_exponent += spare;
    const uint64_t bend = twist * ((uint32_t)fxl_magnitude(slopes[1]) + 1); /* at most 2^63 */
    int bend_exponent = twist_exponent + drop - 32 - 17 + 2 * log;
    int far_exponent = twist_exponent - 29 + log;
    const uint32_t bend_root = cube_root_up(aligned(bend, 30, 3, &bend_exponent));
    const uint32_t far_root = fxl_square_root(aligned(twist, 30, 2, &far_exponent)) + 1;
    const uint32_t by_bend = power_up(bend_root, bend_exponent / 3);
    const uint32_t by_far = power_up(far_root, far_exponent / 2);
    return by_bend > by_far ? by_bend : by_far;
}

static bool is_zero(const fxl_gradient *gradient)
{
    return (gradient->at | gradient->along | gradient->down) == 0;
}

/* --- a face --------------------------------------------------------------------------------- */

void fxl_gradients_find(const fxl_gradient_corners *face, const fxl_view *view,
                        fxl_gradients *gradients)
{
    const fxl_view_point *corners = face->corners;
    const block_vector first = block(corners[0].x, corners[0].y, corners[0].z, 0);
    const block_vector edge_1 = difference(&corners[1], &corners[0]);
    const block_vector edge_2 = difference(&corners[2], &corners[0]);
    block_vector vectors[3] = {cross(&edge_1, &edge_2), cross(&edge_2, &first),
                               cross(&first, &edge_1)};
    /* Three products of at most 2^60: below 2^62. */
    if (fxl_multiply_s32(vectors[0].x, first.x) + fxl_multiply_s32(vectors[0].y, first.y) +
            fxl_multiply_s32(vectors[0].z, first.z) <
        0) {
        for (unsigned i = 0; i < 3; i++) {
            negate(&vectors[i]);
        }
    }
    const int weight_exponent = find_gradient(vectors[0], view, &gradients->weight);
    gradients->count = (uint8_t)face->count;
    gradients->weight_min[0] = gradients->weight_min[1] = 1;
    for (uint32_t i = 0; i < face->count; i++) {
        const int32_t *values = face->values[i];
        const int32_t factors[3] = {values[0], values[1] - values[0], values[2] - values[0]};
        const int exponent =
            find_gradient(combine(vectors, factors), view, &gradients->attributes[i]);
        gradients->shifts[i] = 0;
        if (is_zero(&gradients->attributes[i])) {
            continue;
        }
        gradients->shifts[i] = (int8_t)(exponent - weight_exponent);
        for (uint32_t n = 0; n < 2; n++) {
            const uint32_t least = least_weight(gradients, i, n == 0 ? 4 : 3, &view->lens);
            if (least > gradients->weight_min[n]) {
                gradients->weight_min[n] = least;
            }
        }
    }
}

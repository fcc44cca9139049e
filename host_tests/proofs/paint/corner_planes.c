/* SPDX-License-Identifier: MIT */
/* Words of texels. */
#include "paint/corner_planes.c"
#include "paint/smooth_outline.h"
#include "proof.h"

/* Any planes of a face that may have words of texels, and weights of it. */
static fxl_corner_planes any_small_planes(void)
{
    fxl_corner_planes planes;
    ASSUME(planes.exponent >= 14 && planes.exponent <= 36);
    ASSUME(WITHIN(planes.x, 1 << 27) && WITHIN(planes.y, 1 << 27));
    for (int i = 0; i < 2; i++) {
        ASSUME(WITHIN(planes.along[i], 1 << 30) && WITHIN(planes.down[i], 1 << 30));
    }
    ASSUME(planes.weight_most < 1u << 30 && planes.weight_range <= planes.weight_most);
    return planes;
}

/* Any three values that has_few_texels takes; light differs by less. */
static void any_few_texels(int32_t values[3])
{
    for (int i = 0; i < 3; i++) {
        values[i] = nondet_s32();
        ASSUME(WITHIN(values[i], (1 << 30) - 1));
        ASSUME(values[i] - values[0] >= -(1 << 23) && values[i] - values[0] < 1 << 23);
    }
}

/* Of what a product is only its range is known. */
int64_t any_product(int32_t a, int32_t b)
{
    const int64_t product = nondet_s64();
    ASSUME(WITHIN(product, (int64_t)1 << 62));
    ASSUME(!WITHIN(a, 1 << 23) || !WITHIN(b, 1 << 30) || WITHIN(product, (int64_t)1 << 53));
    ASSUME(!WITHIN(b, 1 << 27) || WITHIN(product, (int64_t)1 << 58));
    return product;
}

/* Any function of two numbers: that each call with the same two gives the same is all that is known. */
uint64_t __CPROVER_uninterpreted_product(uint32_t a, uint32_t b);

uint64_t any_product_unsigned(uint32_t a, uint32_t b)
{
    return __CPROVER_uninterpreted_product(a, b);
}

/* [[row]]
 * function = "lib/paint/corner_planes.c:find_value"
 * property = "nothing overflows, and all are words, for faces that may have words and values that differ by at most 2^23"
 * checks = 219
 * unwind = 4
 * stands_in = { fxl_multiply_s32 = "any_product" }
 */
void prove_find_value(void)
{
    const fxl_corner_planes planes = any_small_planes();
    int32_t values[3];
    fxl_gradient gradient;
    any_few_texels(values);
    if (find_value(&planes, values, &gradient)) {
        ASSERT("at a pixel", gradient.at == (int32_t)gradient.at);
        ASSERT("changes", gradient.along == (int32_t)gradient.along && gradient.down == (int32_t)gradient.down);
    }
    PROOF_ENDS();
}

/* [[row]]
 * function = "lib/paint/corner_planes.c:is_nearly_linear"
 * property = "nothing overflows, and it is so exactly where the larger range of u and v, and that of light where there is any, are within the rule"
 * checks = 183
 * unwind = 4
 * stands_in = { fxl_multiply_u32 = "any_product_unsigned" }
 * stubs = { fxl_multiply_u32 = "any function of two numbers: the rule is one of such products" }
 */
void prove_is_nearly_linear(void)
{
    const fxl_corner_planes planes = any_small_planes();
    int32_t values[3][3];
    const uint32_t count = nondet_u32();
    ASSUME(count == 2 || count == 3);
    for (int k = 0; k < 3; k++) {
        any_few_texels(values[k]);
    }
    const uint32_t least = planes.weight_most - planes.weight_range;
    const uint32_t u = fxl_range_of(values[0]), v = fxl_range_of(values[1]);
    const bool texels = any_product_unsigned(v > u ? v : u, planes.weight_range) <= any_product_unsigned(least, 4 * 19660);
    const bool light = count == 2 || any_product_unsigned(fxl_range_of(values[2]), planes.weight_range) <= any_product_unsigned(least, 4 * 16384);
    ASSERT("exactly so", is_nearly_linear(&planes, values, count) == (texels && light));
    PROOF_ENDS();
}

/* For is_nearly_linear, find_value and fxl_corner_planes_depth_words. */
bool any_is_nearly_linear(const fxl_corner_planes *planes, int32_t (*values)[3], uint32_t count)
{
    (void)planes, (void)values;
    ASSERT("u, v and perhaps light", count == 2 || count == 3);
    return nondet_bool();
}

bool any_find_value(const fxl_corner_planes *planes, const int32_t values[3], fxl_gradient *gradient)
{
    (void)planes;
    ASSERT("values", WITHIN((int64_t)values[1] - values[0], 1 << 23) && WITHIN((int64_t)values[2] - values[0], 1 << 23));
    gradient->at = nondet_s32();
    gradient->along = nondet_s32();
    gradient->down = nondet_s32();
    return nondet_bool();
}

bool any_depth_words(const fxl_corner_planes *planes, fxl_depth_plane *depth)
{
    (void)planes;
    ANY_CONTENT(depth);
    return nondet_bool();
}

/* [[row]]
 * function = "lib/paint/corner_planes.c:fxl_find_texels"
 * property = "nothing is out of bounds; where it is true the gradients are words of u, v and perhaps light, and of a constant weight"
 * checks = 292
 * unwind = 5
 * stands_in = { is_nearly_linear = "any_is_nearly_linear", find_value = "any_find_value", fxl_corner_planes_depth_words = "any_depth_words" }
 * stubs = { fxl_corner_planes_depth_words = "any depth: it is measured" }
 */
/* [[row]]
 * function = "lib/paint/smooth_outline.h:fxl_has_texel_words"
 * property = "so it is of what fxl_find_texels finds, also where a level of the texture leaves up to 8 bits out"
 * checks = 292
 * unwind = 5
 * stands_in = { is_nearly_linear = "any_is_nearly_linear", find_value = "any_find_value", fxl_corner_planes_depth_words = "any_depth_words" }
 * stubs = { fxl_corner_planes_depth_words = "any depth: it is measured" }
 */
void prove_find_texels(void)
{
    const fxl_corner_planes planes = any_small_planes();
    int32_t values[3][3];
    fxl_gradients gradients;
    fxl_depth_plane depth;
    const uint32_t count = nondet_u32(), less = nondet_u32(), i = nondet_u32();
    ASSUME((count == 2 || count == 3) && less <= 8 && i < count);
    for (int k = 0; k < 3; k++) {
        any_few_texels(values[k]);
    }
    if (fxl_find_texels(&planes, values, count, nondet_bool(), &gradients, &depth)) {
        ASSERT("so many", gradients.count == count && gradients.shifts[i] == FXL_SHIFT_OF_TEXELS);
        ASSERT("words", gradients.attributes[i].along == (int32_t)gradients.attributes[i].along);
        ASSERT("a constant weight", fxl_weight_is_constant(&gradients) && gradients.weight_min[0] == 1);
        gradients.shifts[0] = (int8_t)(gradients.shifts[0] - (int32_t)less);
        ASSERT("of texels", fxl_has_texel_words(&gradients) && !fxl_has_colour_words(&gradients));
    }
    PROOF_ENDS();
}

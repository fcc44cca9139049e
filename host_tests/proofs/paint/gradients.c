/* SPDX-License-Identifier: MIT */
#include "paint/gradients.c"
#define find_least find_least_of_segment
#include "paint/segments.c"
#include "proof.h"

/* [[row]]
 * function = "fxl_block"
 * property = "any components of at most 2^61: nothing overflows, each becomes at most 2^30, and the exponent is in its range"
 * checks = 13
 */
void prove_block(void)
{
    const int64_t x = nondet_s64(), y = nondet_s64(), z = nondet_s64();
    const int exponent = nondet_s32();
    ASSUME(WITHIN(x, (int64_t)1 << 61) && WITHIN(y, (int64_t)1 << 61) && WITHIN(z, (int64_t)1 << 61) && WITHIN(exponent, 1 << 20));
    const fxl_block_vector block = fxl_block(x, y, z, exponent);
    ASSERT("at most 2^30", WITHIN(block.x, 1 << 30) && WITHIN(block.y, 1 << 30) && WITHIN(block.z, 1 << 30));
    ASSERT("its exponent", block.exponent >= exponent - 30 && block.exponent <= exponent + 32);
    PROOF_ENDS();
}

/* [[row]]
 * function = "fxl_find_least_weights"
 * property = "any weights from 1 to 2^31 and any division: no weight is 0"
 * checks = 106
 */
void prove_find_least_weights(void)
{
    fxl_gradients gradients;
    uint32_t least[3];
    ASSUME(gradients.weight_min[0] >= 1 && gradients.weight_min[0] <= (uint32_t)1 << 31);
    ASSUME(gradients.weight_min[1] >= 1 && gradients.weight_min[1] <= (uint32_t)1 << 31);
    fxl_find_least_weights(&gradients, nondet_u32(), least);
    ASSERT("none is 0", least[0] != 0 && least[1] != 0 && least[2] != 0);
    PROOF_ENDS();
}

/* As fxl_attribute_of has it. */
static int drop_by(int shift, uint32_t zeros)
{
    const int drop = 62 - (int)zeros - shift;
    return drop < 0 ? 0 : drop > 63 ? 63 : drop;
}

/* [[row]]
 * function = "shift_of"
 * property = "gradients->shifts: the number itself from -112 to 70, and of any other one that moves a product as far, also less the 8 of a level"
 * checks = 9
 */
void prove_shift_of(void)
{
    const int shift = nondet_s32(), less = nondet_s32();
    const uint32_t zeros = nondet_u32();
    ASSUME(WITHIN(shift, 1 << 20) && zeros <= 31 && less >= 0 && less <= 8);
    const int held = shift_of(shift);
    ASSERT("the number", shift < SHIFT_LEAST || shift > FXL_SHIFT_MOST || held == shift);
    ASSERT("that of no word", held <= FXL_SHIFT_MOST);
    ASSERT("a level's", held - less >= INT8_MIN && drop_by(held - less, zeros) == drop_by(shift - less, zeros));
    PROOF_ENDS();
}

/* [[row]]
 * function = "cube_root_up"
 * property = "from 1 to 2^10, and no cube overflows"
 * checks = 1
 * unwind = 11
 */
void prove_cube_root_up(void)
{
    const uint32_t value = nondet_u32();
    ASSUME(value > 0 && value <= (uint32_t)1 << 30);
    const uint32_t root = cube_root_up(value);
    ASSERT("from 1 to 2^10", root >= 1 && root <= 1024);
    PROOF_ENDS();
}

/* [[row]]
 * function = "power_up"
 * property = "from 1 to 2^31, and no shift is undefined"
 * checks = 9
 */
void prove_power_up(void)
{
    const uint32_t number = nondet_u32();
    const int exponent = nondet_s32();
    ASSUME(number > 0 && number < (uint32_t)1 << 16 && WITHIN(exponent, 1 << 20));
    const uint32_t power = power_up(number, exponent);
    ASSERT("from 1 to 2^31", power >= 1 && power <= (uint32_t)1 << 31);
    PROOF_ENDS();
}

/* [[row]]
 * function = "fxl_gradient_of_plane"
 * property = "any vector of at most 2^30 and any projection of a screen: nothing overflows, and values on the screen have at most 62 bits"
 * checks = 119
 */
void prove_gradient_of_plane(void)
{
    fxl_block_vector vector;
    fxl_view view;
    fxl_gradient gradient;
    ASSUME(WITHIN(vector.x, 1 << 30) && WITHIN(vector.y, 1 << 30) && WITHIN(vector.z, 1 << 30) && WITHIN(vector.exponent, 1 << 20));
    ASSUME(view.projection.factor < (uint32_t)1 << 31 && WITHIN(view.projection.centre_x, 1 << 28) && WITHIN(view.projection.centre_y, 1 << 28));
    ASSUME(view.lens.width <= FXL_SCREEN_MAX && view.lens.height <= FXL_SCREEN_MAX);
    (void)fxl_gradient_of_plane(vector, &view, &gradient);
    PROOF_ENDS();
}

/* [[row]]
 * function = "lib/paint/segments.c:fxl_stipple_of"
 * property = "any opacity from 1 to 16: 16 bits, all of them at 16"
 * checks = 8
 * unwind = 17
 */
void prove_stipple_of(void)
{
    const uint32_t opacity = nondet_u32();
    ASSUME(opacity >= 1 && opacity <= 16);
    const uint32_t pattern = fxl_stipple_of(opacity);
    ASSERT("16 bits, all at 16", pattern >> 16 == 0 && (opacity != 16 || pattern == 0xFFFFu));
    PROOF_ENDS();
}

/* [[row]]
 * function = "lib/paint/segments.h:fxl_reciprocal_of"
 * property = "any weight from 1 to 2^31: 31 bits, and nothing overflows"
 * checks = 7
 */
void prove_reciprocal_of(void)
{
    const uint32_t weight = nondet_u32();
    ASSUME(weight >= 1 && weight < (uint32_t)1 << 31);
    const fxl_reciprocal reciprocal = fxl_reciprocal_of(weight);
    ASSERT("31 bits", reciprocal.value >= 1 << 29 && reciprocal.zeros >= 1 && reciprocal.zeros <= 31);
    PROOF_ENDS();
}

/* [[row]]
 * function = "lib/paint/segments.h:fxl_attribute_of"
 * property = "any value, reciprocal and shift: nothing overflows, and no shift is undefined"
 * checks = 17
 */
void prove_attribute_of(void)
{
    fxl_reciprocal reciprocal;
    const int32_t value = nondet_s32();
    const int shift = nondet_s32();
    ASSUME(reciprocal.value >= 0 && reciprocal.zeros >= 1 && reciprocal.zeros <= 31 && WITHIN(shift, 128) && value > INT32_MIN);
    (void)fxl_attribute_of(value, &reciprocal, shift);
    PROOF_ENDS();
}

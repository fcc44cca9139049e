/* SPDX-License-Identifier: MIT */
#include "paint/segments.c"
#include "proof.h"

/* [[row]]
 * function = "fxl_stipple_of"
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
 * checks = 16
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

/* SPDX-License-Identifier: MIT */
/* The exact division of attributes by the weight. Internal. */
#ifndef FXL_ATTRIBUTE_H
#define FXL_ATTRIBUTE_H

#include "../math/arith.h"

/* A weight's reciprocal: value 2^62 / (weight 2^zeros), from 2^30 to 2^31. */
typedef struct {
    int32_t value;
    unsigned zeros;
} fxl_reciprocal;

/* Requires 1 <= weight < 2^31. The lowest bit of the weight counts as set, so no reciprocal of a
 * weight from 2 on is 2^31. The first estimate divides by the 16 upper bits: it is within 2^-15,
 * relatively. Newton's step squares that: at most 2^-30 too small. Its product is rounded down:
 * less than a unit too large. So the error is below 2^-29. */
static inline fxl_reciprocal fxl_reciprocal_of(uint32_t weight)
{
    fxl_reciprocal reciprocal;
    reciprocal.zeros = fxl_leading_zeros(weight);
    const uint32_t scaled = (weight | 1u) << reciprocal.zeros;
    const uint32_t estimate = fxl_divide_half((uint32_t)INT32_MAX, scaled >> 16); /* below 2^16 */
    const uint32_t value =
        (estimate << 16) - (uint32_t)(fxl_multiply_u32(estimate * estimate, scaled) >> 32);
    reciprocal.value = (int32_t)(value - (value >> 31));
    return reciprocal;
}

/* value * 2^shift / weight, modulo 2^32, rounded down. Requires |value| < 2^30. */
static inline int32_t fxl_attribute_of(int32_t value, const fxl_reciprocal *reciprocal, int shift)
{
    const int drop = 62 - (int)reciprocal->zeros - shift;
    const int64_t product = fxl_multiply_s32(value, reciprocal->value); /* below 2^61 */
    return (int32_t)(uint32_t)(product >> (drop < 0 ? 0 : drop > 63 ? 63 : drop));
}

#endif

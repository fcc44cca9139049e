/* SPDX-License-Identifier: MIT */
/* The exact division of attributes by the weight. Internal. */
#ifndef FXL_ATTRIBUTE_H
#define FXL_ATTRIBUTE_H

#include "../../src/math/arith.h"

/* A weight's reciprocal: value 2^62 / (weight 2^zeros), from 2^30 to 2^31. */
typedef struct {
    int32_t value;
    unsigned zeros;
} fxl_reciprocal;

/* Requires 1 <= weight < 2^30.
 * The first estimate divides by the 16 upper bits: it is too large by less than 2^-15 and too small
 * by less than 2^-16, relatively. Newton's step squares that: below 2^-30. The bits that the step
 * cuts off cost less than 3 * 2^-30. So the error is below 2^-28. */
static inline fxl_reciprocal fxl_reciprocal_of(uint32_t weight)
{
    fxl_reciprocal reciprocal;
    reciprocal.zeros = fxl_leading_zeros(weight);
    const uint32_t scaled = weight << reciprocal.zeros;
    const int32_t estimate = (int32_t)(fxl_divide_half(UINT32_MAX, scaled >> 16) << 14);
    const int32_t product = (int32_t)(fxl_multiply_u32(scaled, (uint32_t)estimate) >> 32);
    const int32_t missing = (int32_t)1073741824 - product; /* within 2^15 */
    reciprocal.value = estimate + ((estimate >> 16) * missing >> 14);
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

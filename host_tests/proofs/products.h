/* SPDX-License-Identifier: MIT */
/* What a function makes of its products and quotients, whatever these are: stands in for them in rows that state a result. Equal
 * operands have equal results, and all that is assumed besides is a range. So what holds here holds for the real ones. */
#ifndef PRODUCTS_H
#define PRODUCTS_H

#include "proof.h"

typedef __int128 wide;
typedef unsigned __int128 wide_unsigned;

uint64_t __CPROVER_uninterpreted_unsigned(uint32_t, uint32_t);
int64_t __CPROVER_uninterpreted_signed(int32_t, int32_t);
int64_t __CPROVER_uninterpreted_mixed(int32_t, uint32_t);
uint64_t __CPROVER_uninterpreted_high(uint64_t, uint64_t);
int32_t __CPROVER_uninterpreted_down(int64_t, uint32_t);

/* For fxl_multiply_u32, fxl_multiply_s32, fxl_multiply_s31 and fxl_multiply_su32. */
uint64_t any_unsigned(uint32_t a, uint32_t b)
{
    const uint64_t product = __CPROVER_uninterpreted_unsigned(a, b);
    ASSUME(product <= (uint64_t)UINT32_MAX * UINT32_MAX);
    return product;
}

int64_t any_signed(int32_t a, int32_t b)
{
    const int64_t product = __CPROVER_uninterpreted_signed(a, b);
    ASSUME(WITHIN(product, (int64_t)1 << 62));
    return product;
}

int64_t any_mixed(int32_t a, uint32_t b)
{
    return __CPROVER_uninterpreted_mixed(a, b);
}

/* For fxl_multiply_high. */
uint64_t any_high(uint64_t a, uint64_t b)
{
    const uint64_t high = __CPROVER_uninterpreted_high(a, b);
    ASSUME(high <= a && high <= b);
    return high;
}

/* For fxl_divide_down and fxl_divide_round: what they require. */
int32_t any_down(int64_t numerator, uint32_t denominator)
{
    ASSERT("a quotient that fits", denominator > 0 && (uint64_t)(numerator ^ (numerator >> 63)) >> 31 < denominator);
    return __CPROVER_uninterpreted_down(numerator, denominator);
}

#endif

/* SPDX-License-Identifier: MIT */
#include "math/arith.c"
#include "proof.h"

void prove_leading_zeros(void)
{
    const uint32_t value = nondet_u32();
    ASSUME(value != 0);
    const unsigned zeros = fxl_leading_zeros(value);
    ASSERT("the highest 1 comes after them", zeros < 32 && value << zeros >> 31 == 1);
    ASSERT("they are 0", zeros == 0 || value >> (32 - zeros) == 0);
    PROOF_ENDS();
}

void prove_bit_length(void)
{
    const uint64_t value = nondet_u64();
    const unsigned length = fxl_bit_length(value);
    ASSERT("length", length <= 64 && (length == 64 || value < (uint64_t)1 << length) &&
                         (length == 0 || value >> (length - 1) != 0));
    PROOF_ENDS();
}

#ifdef CASE
void prove_round_shift(void)
{
    const int64_t value = nondet_s64(), half = (int64_t)1 << (CASE - 1);
    ASSUME(WITHIN(value, (int64_t)1 << 62));
    const int64_t rounded = fxl_round_shift(value, CASE);
    const __int128 off = (__int128)rounded * ((__int128)1 << CASE) - value;
    ASSERT("half up", off <= half && off > -half);
    PROOF_ENDS();
}
#endif

void prove_divide_u64(void)
{
    uint32_t *remainder;
    (void)fxl_divide_u64(nondet_u64(), nondet_u32(), remainder);
    PROOF_ENDS();
}

void prove_fraction(void)
{
    (void)fxl_fraction(nondet_u64(), nondet_u64());
    PROOF_ENDS();
}

void prove_divide_down(void)
{
    (void)fxl_divide_down(nondet_s64(), nondet_u32());
    PROOF_ENDS();
}

void prove_divide_round(void)
{
    (void)fxl_divide_round(nondet_s64(), nondet_u32());
    PROOF_ENDS();
}

void prove_divide_floor(void)
{
    int32_t *remainder;
    (void)fxl_divide_floor(nondet_s32(), nondet_s32(), remainder);
    PROOF_ENDS();
}

void prove_ratio(void)
{
    int32_t *quotient;
    (void)fxl_ratio(nondet_s32(), nondet_s64(), nondet_s64(), nondet_s32(), quotient);
    PROOF_ENDS();
}

void prove_dot(void)
{
    fxl_direction *direction;
    (void)fxl_dot(direction, nondet_s32(), nondet_s32(), nondet_s32());
    PROOF_ENDS();
}

void prove_subtract(void)
{
    fxl_point *a, *b, *difference;
    fxl_subtract(a, b, difference);
    PROOF_ENDS();
}

void prove_point_in_range(void)
{
    fxl_point *point;
    (void)fxl_point_in_range(point);
    PROOF_ENDS();
}

void prove_real_of(void)
{
    const int exponent = nondet_s32();
    const uint64_t number = nondet_u64();
    ASSUME(number > 0 && WITHIN(exponent, 1 << 20));
    const fxl_real real = fxl_real_of(number, exponent);
    ASSERT("its highest bit is 1", real.mantissa >> 31 == 1);
    ASSERT("its exponent", real.exponent >= exponent - 31 && real.exponent <= exponent + 32);
    PROOF_ENDS();
}

void prove_mantissa_ratio(void)
{
    const fxl_real part = {nondet_u32(), 0}, whole = {nondet_u32(), 0};
    ASSUME(part.mantissa >> 31 == 1 && whole.mantissa >> 31 == 1);
    (void)fxl_mantissa_ratio(&part, &whole);
    PROOF_ENDS();
}

void prove_magnitude(void)
{
    const int64_t value = nondet_s64();
    const uint64_t magnitude = fxl_magnitude(value);
    ASSERT("magnitude", magnitude <= (uint64_t)1 << 63 && (value < 0 ? (uint64_t)value + magnitude == 0 : (uint64_t)value == magnitude));
    PROOF_ENDS();
}

void prove_divide_u32(void)
{
    uint32_t *remainder;
    (void)fxl_divide_u32(nondet_u32(), nondet_u32(), remainder);
    PROOF_ENDS();
}

void prove_multiply_high(void)
{
    (void)fxl_multiply_high(nondet_u64(), nondet_u64());
    PROOF_ENDS();
}

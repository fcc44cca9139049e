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

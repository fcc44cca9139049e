/* SPDX-License-Identifier: MIT */
#include "math/arith.c"
#include "proof.h"

/* [[row]]
 * function = "lib/math/core.h:fxl_leading_zeros"
 * property = "the number of zeros above the highest 1, exactly"
 * checks = 5
 */
void prove_leading_zeros(void)
{
    const uint32_t value = nondet_u32();
    ASSUME(value != 0);
    const unsigned zeros = fxl_leading_zeros(value);
    ASSERT("the highest 1 comes after them", zeros < 32 && value << zeros >> 31 == 1);
    ASSERT("they are 0", zeros == 0 || value >> (32 - zeros) == 0);
    PROOF_ENDS();
}

/* [[row]]
 * function = "lib/math/arith.h:fxl_bit_length"
 * property = "the number of bits, exactly"
 * checks = 4
 */
void prove_bit_length(void)
{
    const uint64_t value = nondet_u64();
    const unsigned length = fxl_bit_length(value);
    ASSERT("length", length <= 64 && (length == 64 || value < (uint64_t)1 << length) &&
                         (length == 0 || value >> (length - 1) != 0));
    PROOF_ENDS();
}

/* [[row]]
 * function = "lib/math/arith.h:fxl_round_shift"
 * property = "floor(value / 2^shift + 1/2) for |value| <= 2^62, for each shift"
 * checks = 40
 * cases = [1, 2, 3, 61, 62]
 */
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

/* [[row]]
 * function = "fxl_divide_u64"
 * property = "nothing overflows"
 * checks = 101
 * contract = true
 * equations = true
 */
void prove_divide_u64(void)
{
    uint32_t *remainder;
    (void)fxl_divide_u64(nondet_u64(), nondet_u32(), remainder);
    PROOF_ENDS();
}

/* [[row]]
 * function = "fxl_fraction"
 * property = "nothing overflows"
 * checks = 37
 * contract = true
 */
void prove_fraction(void)
{
    (void)fxl_fraction(nondet_u64(), nondet_u64());
    PROOF_ENDS();
}

/* [[row]]
 * function = "lib/math/arith.h:fxl_divide_down"
 * property = "nothing overflows; a quotient of a coordinate of the screen is below 2^28"
 * checks = 55
 * contract = true
 * uses = ["fxl_divide_u64"]
 */
void prove_divide_down(void)
{
    (void)fxl_divide_down(nondet_s64(), nondet_u32());
    PROOF_ENDS();
}

/* [[row]]
 * function = "lib/math/arith.h:fxl_divide_round"
 * property = "nothing overflows; a quotient of a coordinate of the screen is below 2^28"
 * checks = 30
 * contract = true
 * uses = ["fxl_divide_down"]
 */
void prove_divide_round(void)
{
    (void)fxl_divide_round(nondet_s64(), nondet_u32());
    PROOF_ENDS();
}

/* [[row]]
 * function = "lib/math/arith.h:fxl_divide_floor"
 * property = "nothing overflows, and the remainder is below the denominator"
 * checks = 83
 * contract = true
 * uses = ["fxl_divide_u32"]
 * flags = ["--object-bits", "8"]
 */
void prove_divide_floor(void)
{
    int32_t *remainder;
    (void)fxl_divide_floor(nondet_s32(), nondet_s32(), remainder);
    PROOF_ENDS();
}

/* [[row]]
 * function = "fxl_ratio"
 * property = "nothing overflows, and each quotient fits"
 * checks = 71
 * contract = true
 * uses = ["fxl_divide_round"]
 */
void prove_ratio(void)
{
    int32_t *quotient;
    (void)fxl_ratio(nondet_s32(), nondet_s64(), nondet_s64(), nondet_s32(), quotient);
    PROOF_ENDS();
}

/* [[row]]
 * function = "lib/math/arith.h:fxl_dot"
 * property = "nothing overflows; below 7 2^59, and below 7 2^58 for coordinates below 2^29"
 * checks = 81
 * contract = true
 */
void prove_dot(void)
{
    fxl_direction *direction;
    (void)fxl_dot(direction, nondet_s32(), nondet_s32(), nondet_s32());
    PROOF_ENDS();
}

/* [[row]]
 * function = "lib/math/arith.h:fxl_subtract"
 * property = "differences of points of the world are below 2^30"
 * checks = 173
 * contract = true
 * uses = ["fxl_point_in_range"]
 */
void prove_subtract(void)
{
    fxl_point *a, *b, *difference;
    fxl_subtract(a, b, difference);
    PROOF_ENDS();
}

/* [[row]]
 * function = "lib/math/arith.h:fxl_point_in_range"
 * property = "what it says, for every point"
 * checks = 78
 * contract = true
 */
void prove_point_in_range(void)
{
    fxl_point *point;
    (void)fxl_point_in_range(point);
    PROOF_ENDS();
}

/* [[row]]
 * function = "lib/math/arith.h:fxl_real_of"
 * property = "the mantissa's highest bit is 1"
 * checks = 10
 */
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

/* [[row]]
 * function = "lib/math/arith.h:fxl_mantissa_ratio"
 * property = "the quotient fits, and nothing overflows"
 * checks = 61
 * uses = ["fxl_divide_u64"]
 */
void prove_mantissa_ratio(void)
{
    const fxl_real part = {nondet_u32(), 0}, whole = {nondet_u32(), 0};
    ASSUME(part.mantissa >> 31 == 1 && whole.mantissa >> 31 == 1);
    (void)fxl_mantissa_ratio(&part, &whole);
    PROOF_ENDS();
}

/* [[row]]
 * function = "lib/math/arith.h:fxl_magnitude"
 * property = "the magnitude of every value, exactly"
 * checks = 1
 */
void prove_magnitude(void)
{
    const int64_t value = nondet_s64();
    const uint64_t magnitude = fxl_magnitude(value);
    ASSERT("magnitude", magnitude <= (uint64_t)1 << 63 && (value < 0 ? (uint64_t)value + magnitude == 0 : (uint64_t)value == magnitude));
    PROOF_ENDS();
}

/* [[row]]
 * function = "lib/math/core.h:fxl_divide_u32"
 * property = "nothing overflows"
 * checks = 37
 * contract = true
 * equations = true
 */
void prove_divide_u32(void)
{
    uint32_t *remainder;
    (void)fxl_divide_u32(nondet_u32(), nondet_u32(), remainder);
    PROOF_ENDS();
}

/* [[row]]
 * function = "lib/math/core.h:fxl_multiply_high"
 * property = "nothing is undefined"
 * checks = 7
 * contract = true
 * equations = true
 */
void prove_multiply_high(void)
{
    (void)fxl_multiply_high(nondet_u64(), nondet_u64());
    PROOF_ENDS();
}

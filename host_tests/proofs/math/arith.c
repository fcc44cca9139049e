/* SPDX-License-Identifier: MIT */
#include "math/arith.c"
#include "products.h"

/* [[row]]
 * function = "lib/math/core.h:fxl_leading_zeros"
 * property = "the number of zeros above the highest 1, exactly"
 * checks = 6
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
 * checks = 6
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
 * checks = 112
 * contract = true
 * equations = true
 * unreached = { fxl_fraction = "of FXL_COMPACT alone", fxl_multiply_u32 = "the same" }
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
 * narrows = "it does not end in 120 s of CPU time with the check"
 */
void prove_fraction(void)
{
    (void)fxl_fraction(nondet_u64(), nondet_u64());
    PROOF_ENDS();
}

/* [[row]]
 * function = "lib/math/arith.h:fxl_divide_down"
 * property = "nothing overflows; a quotient of a coordinate of the screen is below 2^28"
 * checks = 60
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
 * checks = 36
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
 * checks = 88
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
 * checks = 80
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
 * checks = 13
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
 * checks = 3
 */
void prove_magnitude(void)
{
    const int64_t value = nondet_s64();
    const uint64_t magnitude = fxl_magnitude(value);
    ASSERT("magnitude", magnitude <= (uint64_t)1 << 63 && (value < 0 ? fxl_bits_64(value) + magnitude == 0 : (uint64_t)value == magnitude));
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
 * checks = 9
 * contract = true
 * equations = true
 */
void prove_multiply_high(void)
{
    (void)fxl_multiply_high(nondet_u64(), nondet_u64());
    PROOF_ENDS();
}

/* --- ranges of products --------------------------------------------------------------------------------- */

/* [[row]]
 * id = "fxl_multiply_s32, its range"
 * function = "lib/math/core.h:fxl_multiply_s32"
 * property = "at most 2^62; 2^53 of factors up to 2^23 and 2^30, and 2^58 where the second is at most 2^27"
 * checks = 4
 */
void prove_multiply_s32_range(void)
{
    const int32_t a = nondet_s32(), b = nondet_s32();
    const int64_t product = fxl_multiply_s32(a, b);
    ASSERT("at most 2^62", WITHIN(product, (int64_t)1 << 62));
    ASSERT("at most 2^53", !WITHIN(a, 1 << 23) || !WITHIN(b, 1 << 30) || WITHIN(product, (int64_t)1 << 53));
    ASSERT("at most 2^58", !WITHIN(b, 1 << 27) || WITHIN(product, (int64_t)1 << 58));
    PROOF_ENDS();
}

/* [[row]]
 * id = "fxl_multiply_s64, its range"
 * function = "lib/math/core.h:fxl_multiply_s64"
 * property = "of factors that are not below 0: at most 2^55 of up to 2^24 and 2^31, and 2^57 of up to 2^25 and 2^32"
 * checks = 2
 */
void prove_multiply_s64_range(void)
{
    const int64_t a = nondet_s64(), b = nondet_s64(), product = fxl_multiply_s64(a, b);
    ASSUME(a >= 0 && b >= 0);
    ASSERT("at most 2^55", a > 1 << 24 || b > (int64_t)1 << 31 || (product >= 0 && product <= (int64_t)1 << 55));
    ASSERT("at most 2^57", a > 1 << 25 || b > (int64_t)1 << 32 || (product >= 0 && product <= (int64_t)1 << 57));
    PROOF_ENDS();
}

/* --- results, of products and quotients that may be any ------------------------------------------------- */


/* [[row]]
 * id = "fxl_multiply_high, its result"
 * function = "lib/math/core.h:fxl_multiply_high"
 * property = "the upper 64 bits of the sum of the four products of the halves, each where it belongs"
 * checks = 6
 * stands_in = { fxl_multiply_u32 = "any_unsigned" }
 * stubs = { fxl_multiply_u32 = "C's product of two words" }
 */
void prove_multiply_high_result(void)
{
    const uint64_t a = nondet_u64(), b = nondet_u64();
    const uint32_t a_high = (uint32_t)(a >> 32), b_high = (uint32_t)(b >> 32), a_low = fxl_low_32(a), b_low = fxl_low_32(b);
    const wide_unsigned sum = ((wide_unsigned)any_unsigned(a_high, b_high) << 64) + ((wide_unsigned)any_unsigned(a_high, b_low) << 32) +
                              ((wide_unsigned)any_unsigned(a_low, b_high) << 32) + any_unsigned(a_low, b_low);
    ASSERT("the upper half of the product", fxl_multiply_high(a, b) == (uint64_t)(sum >> 64));
    PROOF_ENDS();
}

uint32_t __CPROVER_uninterpreted_quotient(uint64_t, uint32_t);

/* For fxl_divide_u64. */
uint32_t any_quotient(uint64_t numerator, uint32_t denominator, uint32_t *remainder)
{
    const uint32_t quotient = __CPROVER_uninterpreted_quotient(numerator, denominator);
    ASSERT("a quotient that fits", numerator >> 32 < denominator);
    ASSUME(numerator >> 31 >= denominator || quotient >> 31 == 0);
    *remainder = nondet_u32();
    return quotient;
}

/* [[row]]
 * id = "fxl_divide_down, its result"
 * function = "lib/math/arith.h:fxl_divide_down"
 * property = "the quotient of the numerator; -1 less that of -1 less the numerator where the numerator is below 0"
 * checks = 19
 * stands_in = { fxl_divide_u64 = "any_quotient" }
 */
void prove_divide_down_result(void)
{
    const int64_t numerator = nondet_s64();
    const uint32_t denominator = nondet_u32();
    uint32_t rest;
    ASSUME(denominator > 0 && (uint64_t)(numerator ^ (numerator >> 63)) >> 31 < denominator);
    const uint32_t magnitude = any_quotient(numerator < 0 ? (uint64_t)(-1 - numerator) : (uint64_t)numerator, denominator, &rest);
    const int32_t quotient = fxl_divide_down(numerator, denominator);
    ASSERT("floor", quotient == (numerator < 0 ? -1 - (int32_t)magnitude : (int32_t)magnitude));
    PROOF_ENDS();
}

/* [[row]]
 * id = "fxl_divide_round, its result"
 * function = "lib/math/arith.h:fxl_divide_round"
 * property = "the floor of the numerator and half the denominator, over the denominator"
 * checks = 10
 * stands_in = { fxl_divide_down = "any_down" }
 */
void prove_divide_round_result(void)
{
    const int64_t numerator = nondet_s64();
    const uint32_t denominator = nondet_u32();
    ASSUME(denominator > 0 && WITHIN(numerator, (int64_t)((uint64_t)denominator << 31) - denominator));
    ASSERT("the nearest", fxl_divide_round(numerator, denominator) == any_down(numerator + denominator / 2, denominator));
    PROOF_ENDS();
}

uint32_t __CPROVER_uninterpreted_quotient_32(uint32_t, uint32_t);
uint32_t __CPROVER_uninterpreted_rest_32(uint32_t, uint32_t);

/* For fxl_divide_u32: its contract. */
uint32_t any_quotient_32(uint32_t numerator, uint32_t denominator, uint32_t *remainder)
{
    const uint32_t quotient = __CPROVER_uninterpreted_quotient_32(numerator, denominator);
    *remainder = __CPROVER_uninterpreted_rest_32(numerator, denominator);
    ASSERT("a divisor", denominator > 0);
    ASSUME(*remainder < denominator && *remainder <= numerator && quotient <= numerator);
    return quotient;
}

/* [[row]]
 * id = "fxl_divide_floor, its result"
 * function = "lib/math/arith.h:fxl_divide_floor"
 * property = "quotient and remainder of the magnitude; below 0 those that make the numerator and whose remainder is not below 0"
 * checks = 45
 * stands_in = { fxl_divide_u32 = "any_quotient_32" }
 */
void prove_divide_floor_result(void)
{
    const int32_t numerator = nondet_s32(), denominator = nondet_s32();
    uint32_t rest;
    int32_t remainder;
    ASSUME(denominator > 0 && numerator > INT32_MIN);
    const int32_t magnitude = (int32_t)any_quotient_32(numerator < 0 ? (uint32_t)-numerator : (uint32_t)numerator, (uint32_t)denominator, &rest);
    const int32_t quotient = fxl_divide_floor(numerator, denominator, &remainder);
    /* -n = magnitude d + rest, so n = -magnitude d - rest = (-magnitude - 1) d + d - rest */
    const bool lower = numerator < 0 && rest != 0;
    ASSERT("the quotient", quotient == (numerator < 0 ? -magnitude : magnitude) - lower);
    ASSERT("the remainder", remainder == (lower ? denominator - (int32_t)rest : (int32_t)rest));
    PROOF_ENDS();
}

/* [[row]]
 * id = "fxl_dot, its result"
 * function = "lib/math/arith.h:fxl_dot"
 * property = "the sum of the three products, each of its own component"
 * checks = 23
 * stands_in = { fxl_multiply_s31 = "any_signed" }
 * stubs = { fxl_multiply_s31 = "C's product of two words" }
 */
void prove_dot_result(void)
{
    fxl_direction direction;
    const int32_t x = nondet_s32(), y = nondet_s32(), z = nondet_s32();
    const int64_t a = any_signed(direction.x, x), b = any_signed(direction.y, y), c = any_signed(direction.z, z);
    ASSUME(WITHIN(a, (int64_t)1 << 60) && WITHIN(b, (int64_t)1 << 60) && WITHIN(c, (int64_t)1 << 60));
    ASSERT("the sum", fxl_dot(&direction, x, y, z) == a + b + c);
    PROOF_ENDS();
}

/* SPDX-License-Identifier: MIT */
/* Formulas of equations.smt2 and roundings.gappa beside the functions that they were written from, on inputs that a generator
 * draws, of all lengths, and the ends of their ranges. PREFIX_NAME is what a formula defines as NAME, of the variables here. */
#include "math/arith.c"
#include "math/plane.c"

#include "enumeration.h"
#include "formula.h"

/* [[row]]
 * id = "divide_digit beside its formula"
 * function = "divide_digit"
 * property = "each round of the loop keeps the invariant, and digit and remainder are the formula's, of a million digits"
 * checks = 1000000
 * formula = "divide_digit exact"
 */
void enumerate_digit(void)
{
    for (uint32_t i = 0; i < SAMPLES; i++) {
        const uint32_t divisor = ((uint32_t)1 << 31) + (uint32_t)up_to(INT32_MAX), rest = (uint32_t)up_to(divisor - 1), half = (uint32_t)up_to(65535);
        uint32_t remainder = rest;
        const uint32_t found = divide_digit(&remainder, divisor, half);
        const wide U = divisor >> 16, L = divisor & 65535, R = rest, h = half;
        wide d = R / U, left = R % U, P = d * L;
        HOLDS(rest, digit_contract && digit_state && digit_invariant);
        while (digit_goes_on) {
            d -= 1;
            left += U;
            P -= L;
            HOLDS(rest, digit_state && digit_invariant);
        }
        TRY(rest, found == d && remainder == digit_rest && digit_rest >= 0 && digit_rest < digit_whole);
    }
}

/* [[row]]
 * id = "fxl_divide_u32 beside its formula"
 * function = "lib/math/core.h:fxl_divide_u32"
 * property = "quotient and remainder are the formula's, of a million quotients"
 * checks = 1000000
 * formula = "fxl_divide_u32 remainder"
 */
/* [[row]]
 * id = "fxl_divide_u32 without a divider, beside its formula"
 * function = "lib/math/core.h:fxl_divide_u32"
 * property = "the same of the text for cores without a divider"
 * checks = 1000000
 * formula = "fxl_divide_u32 remainder"
 * flags = ["-DFXL_CORE_HAS=0"]
 */
void enumerate_word(void)
{
    for (uint32_t i = 0; i < SAMPLES; i++) {
        const wide n = (wide)up_to(UINT32_MAX), d = (wide)up_to(UINT32_MAX - 1) + 1;
        uint32_t remainder;
        const uint32_t found = fxl_divide_u32((uint32_t)n, (uint32_t)d, &remainder);
        TRY(n, found == word_quotient && remainder == word_r && word_claim);
    }
}

/* [[row]]
 * id = "fxl_divide_u64 beside its formula"
 * function = "fxl_divide_u64"
 * property = "quotient and remainder are those of two digits of the shifted numerator, of a million quotients"
 * checks = 1000000
 * formula = "fxl_divide_u64 exact"
 */
void enumerate_digits(void)
{
    for (uint32_t i = 0; i < SAMPLES; i++) {
        const uint32_t denominator = (uint32_t)up_to(UINT32_MAX - 1) + 1;
        const uint64_t numerator = up_to(((uint64_t)denominator << 32) - 1);
        uint32_t remainder;
        const uint32_t found = fxl_divide_u64(numerator, denominator, &remainder);
        const wide n = numerator, D = denominator, S = (wide)1 << __builtin_clz(denominator), W = S * D;
        const wide H = n * S >> 32, M = n * S >> 16 & 65535, L = n * S & 65535;
        const wide q1 = (65536 * H + M) / W, r1 = digits_rest_of_upper, q2 = (65536 * r1 + L) / W, r2 = digits_rest_of_lower;
        HOLDS(numerator, digits_contract && n * S == digits_shifted && H < W && r2 % S == 0);
        TRY(numerator, found == digits_quotient && remainder == r2 / S && remainder < D);
    }
}

/* [[row]]
 * id = "fraction_digit beside its formula"
 * function = "fraction_digit"
 * property = "the estimate is right or one too small, and digit and remainder are the formula's, of a million digits"
 * checks = 1000000
 * formula = "fraction_digit exact"
 */
void enumerate_part(void)
{
    for (uint32_t i = 0; i < SAMPLES; i++) {
        const unsigned bits = 21 + i % 2;
        const uint64_t any = ((uint64_t)1 << 62) + up_to(((uint64_t)1 << 62) - 1), part = any >> bits;
        /* of every other one nothing is left */
        const bool is_even = i / 2 % 2 == 0;
        const uint64_t whole = is_even ? part << bits : any, rest = is_even ? part * up_to(((uint64_t)1 << bits) - 1) : up_to(whole - 1);
        const uint32_t reciprocal = reciprocal_below((uint32_t)(whole >> 32) + 1);
        uint64_t remainder = rest;
        const uint32_t found = fraction_digit(&remainder, whole, reciprocal, bits);
        const wide W = whole, R = rest, P = R << bits, d = ((rest >> 31) * reciprocal) >> (61 - bits), Q = d * W;
        TRY(rest, part_contract && part_estimate && found == part_digit && remainder == part_after && part_after < W);
    }
}

/* [[row]]
 * id = "fxl_multiply_su32 beside its formula"
 * function = "lib/math/core.h:fxl_multiply_su32"
 * property = "the product, and its bound, of a million pairs"
 * checks = 1000000
 * formula = "fxl_multiply_su32 bound"
 */
void enumerate_su32(void)
{
    for (uint32_t i = 0; i < SAMPLES; i++) {
        const wide a = any_word(), b = (wide)up_to(UINT32_MAX);
        TRY(a, fxl_multiply_su32((int32_t)a, (uint32_t)b) == su32_product && su32_within_word);
    }
}

/* [[row]]
 * id = "fxl_multiply_s32 beside its formula"
 * function = "lib/math/core.h:fxl_multiply_s32"
 * property = "the same"
 * checks = 1000000
 * formula = "fxl_multiply_s32 bound"
 */
void enumerate_s32(void)
{
    for (uint32_t i = 0; i < SAMPLES; i++) {
        const wide a = any_word(), b = any_word();
        TRY(a, fxl_multiply_s32((int32_t)a, (int32_t)b) == s32_product && s32_within_half && (b < -(1 << 29) || b > 1 << 29 || s32_within_2_29));
    }
}

/* [[row]]
 * id = "fxl_multiply_s64 beside its formula"
 * function = "lib/math/core.h:fxl_multiply_s64"
 * property = "the product, of a million pairs of the ranges that the formula has"
 * checks = 1000000
 * formula = "fxl_multiply_s64 bound"
 */
void enumerate_s64(void)
{
    for (uint32_t i = 0; i < SAMPLES; i++) {
        const wide c = (wide)up_to((uint64_t)1 << (24 + i % 2)), d = (wide)up_to((uint64_t)1 << (31 + i % 2));
        TRY(c, fxl_multiply_s64((int64_t)c, (int64_t)d) == s64_positive_product && s64_positive_product <= (wide)1 << (55 + 2 * (i % 2)));
    }
}

/* [[row]]
 * id = "fxl_multiply_high beside its formula"
 * function = "lib/math/core.h:fxl_multiply_high"
 * property = "the sum of the products of halves, and the upper half of the product, of a million pairs"
 * checks = 1000000
 * formula = "fxl_multiply_high exact"
 */
void enumerate_high(void)
{
    for (uint32_t i = 0; i < SAMPLES; i++) {
        const uint64_t a = up_to(UINT64_MAX), b = up_to(UINT64_MAX);
        const wide ah = a >> 32, al = a & UINT32_MAX, bh = b >> 32, bl = b & UINT32_MAX, HH = ah * bh, HL = ah * bl, LH = al * bh, LL = al * bl;
        TRY(a, fxl_multiply_high(a, b) == high_result && high_result == (wide)((wide_unsigned)a * b >> 64));
    }
}

/* [[row]]
 * id = "normalise beside its formula"
 * function = "lib/math/plane.c:normalise"
 * property = "components are those of the formula, of a million vectors, whose longest coordinate has any length up to 61 bits"
 * checks = 1000000
 * formula = "normalise bound"
 */
void enumerate_unit(void)
{
    for (uint32_t i = 0; i < SAMPLES; i++) {
        const int64_t limit = (int64_t)((uint64_t)1 << (i % 61 + 1)) - 1;
        const wide_vector v = {between(limit), between(limit), between(limit)};
        const int64_t given[3] = {v.x, v.y, v.z};
        uint64_t longest = 0;
        wide scaled[3], q = 0;
        for (int j = 0; j < 3; j++) {
            longest |= (uint64_t)llabs(given[j]);
        }
        fxl_direction found = {0, 0, 0};
        const bool is_one = normalise(&v, &found);
        HOLDS(i, is_one == (longest != 0));
        const int up = longest == 0 ? 0 : __builtin_clzll(longest) - 34;
        for (int j = 0; j < 3; j++) {
            scaled[j] = up >= 0 ? given[j] * ((wide)1 << up) : floor_of(given[j] + ((wide)1 << (-up - 1)), (wide)1 << -up);
            q += scaled[j] * scaled[j];
        }
        const wide twice = fxl_square_root((uint64_t)(4 * q)), components[3] = {found.x, found.y, found.z};
        for (int j = 0; j < 3 && is_one; j++) {
            const wide s = scaled[j], unit = components[j];
            HOLDS(i, unit_shorter && unit_component);
        }
        tried += 1;
    }
}

/* [[row]]
 * id = "fxl_square_root beside its formula"
 * function = "lib/math/plane.h:fxl_square_root"
 * property = "each round keeps the invariant, and the root is the one that is found, of a million values"
 * checks = 1000000
 * formula = "fxl_square_root bound"
 */
void enumerate_root(void)
{
    for (uint32_t i = 0; i < SAMPLES; i++) {
        const wide near = (wide)up_to(UINT32_MAX - 1), N = i % 2 ? (wide)up_to(UINT64_MAX - UINT32_MAX - 1) : near * near + near + i / 2 % 2;
        wide r = 0, value = N, root = 0;
        for (wide B = (wide)1 << 31; B != 0; B /= 2) {
            HOLDS(N, root_invariant);
            const bool up = root_goes_up;
            value -= up ? root + B * B : 0;
            r += up ? B : 0;
            root = r * B;
        }
        TRY(N, fxl_square_root((uint64_t)N) == root_found && root == r);
    }
}

/* [[row]]
 * id = "fxl_ratio beside its formula"
 * function = "fxl_ratio"
 * property = "the quotient of the formula, which is as near as it claims, of a million ratios with a depth of more than 31 bits"
 * checks = 1000000
 * formula = "ratio by Gappa"
 */
void enumerate_ratio(void)
{
    const int32_t limit = (1 << 29) - 1;
    for (uint32_t i = 0; i < SAMPLES; i++) {
        const int32_t factor = (int32_t)up_to((1 << 29) - 2) + 1;
        const int64_t depth = ((int64_t)1 << 31) + (int64_t)up_to(((uint64_t)1 << 61) - ((uint64_t)1 << 31) - 1);
        const wide most = (wide)depth * (limit - 1) / factor, widest = ((int64_t)1 << 61) - 1;
        const int64_t side = between((int64_t)(most < widest ? most : widest));
        const int shift = 33 - __builtin_clzll((uint64_t)depth);
        const real F = factor, X = (real)side / ((wide)1 << shift), Z = (real)depth / ((wide)1 << shift);
        int32_t quotient = 0;
        const bool fits = fxl_ratio(factor, side, depth, limit, &quotient);
        TRY(side, ratio_assumed && ratio_holds && fits && quotient == ratio_q);
    }
}

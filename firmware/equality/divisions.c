/* SPDX-License-Identifier: MIT */

#include "math/arith.h"
#include "equality.h"
#include "sides.h"

static void compare(uint32_t numerator, uint32_t denominator)
{
    uint32_t core_rest, portable_rest;
    if (denominator == 0) {
        return;
    }
    uint32_t core = core_divide_u32(numerator, denominator, &core_rest);
    uint32_t portable = portable_divide_u32(numerator, denominator, &portable_rest);
    equality_case(core == portable && core_rest == portable_rest);
}

void test_divide(uint32_t rounds)
{
    for (uint32_t i = 0; i < BOUNDARY_32_COUNT; i++) {
        for (uint32_t j = 0; j < BOUNDARY_32_COUNT; j++) {
            compare(boundary_32(i), boundary_32(j));
        }
    }
    for (uint32_t i = 0; i < rounds; i++) {
        uint32_t denominator = any_32() >> (any_32() & 31u);
        denominator |= denominator == 0;
        /* Every other one beside a multiple. */
        uint32_t numerator = any_32() >> (any_32() & 31u);
        compare(any_32() & 64u ? numerator : denominator * (numerator & 0xFFFFu) - (numerator & 1u),
                denominator);
    }
}

static void compare_half(uint32_t numerator, uint32_t denominator)
{
    equality_case(core_divide_half(numerator, denominator) ==
                  portable_divide_half(numerator, denominator));
}

/* Every denominator with the ends of the range, then random ones. */
void test_divide_half(uint32_t rounds)
{
    for (uint32_t denominator = 1u << 15; denominator <= 1u << 16; denominator++) {
        compare_half(0, denominator);
        compare_half(denominator - 1, denominator);
        compare_half(denominator, denominator);
        compare_half(UINT32_MAX, denominator);
        compare_half(UINT32_MAX >> 1, denominator);
        compare_half(UINT32_MAX / denominator * denominator, denominator);
        compare_half(UINT32_MAX / denominator * denominator - 1, denominator);
    }
    for (uint32_t i = 0; i < rounds; i++) {
        uint32_t denominator = (1u << 15) + (any_32() >> 5) % ((1u << 15) + 1u);
        uint32_t numerator = any_32();
        compare_half(numerator & 1u ? numerator
                                    : numerator - numerator % denominator - (numerator >> 1 & 1u),
                     denominator);
    }
}

static void compare_wide(uint32_t quotient, uint32_t denominator, uint32_t rest)
{
    if (denominator == 0) {
        return;
    }
    rest %= denominator;
    uint64_t numerator = (uint64_t)quotient * denominator + rest;
    uint32_t core_rest, portable_rest;
    uint32_t core = fxl_divide_u64(numerator, denominator, &core_rest);
    uint32_t portable = portable_divide_u64(numerator, denominator, &portable_rest);
    equality_case(core == quotient && core_rest == rest && portable == quotient &&
                  portable_rest == rest);
}

void test_divide_wide(uint32_t rounds)
{
    for (uint32_t i = 0; i < BOUNDARY_32_COUNT; i++) {
        for (uint32_t j = 0; j < BOUNDARY_32_COUNT; j++) {
            compare_wide(boundary_32(i), boundary_32(j), 0);
            compare_wide(boundary_32(i), boundary_32(j), boundary_32(j) - 1u);
        }
    }
    for (uint32_t i = 0; i < rounds; i++) {
        uint32_t denominator = any_32() >> (any_32() & 31u);
        denominator |= denominator == 0;
        compare_wide(any_32() >> (any_32() & 31u), denominator, any_32());
    }
}

/* floor(2^64 part / whole) bit by bit; whole is below 2^63. */
static uint64_t fraction_by_bits(uint64_t part, uint64_t whole)
{
    uint64_t fraction = 0;
    for (int i = 0; i < 64; i++) {
        part <<= 1;
        fraction <<= 1;
        if (part >= whole) {
            part -= whole;
            fraction |= 1;
        }
    }
    return fraction;
}

static void compare_fraction(uint64_t part, uint64_t whole, bool by_bits)
{
    if (part >= whole || whole >> 63 != 0) {
        return;
    }
    uint64_t core = fxl_fraction(part, whole);
    equality_case(core == portable_fraction(part, whole) &&
                  (!by_bits || core == fraction_by_bits(part, whole)));
}

void test_fraction(uint32_t rounds)
{
    for (uint32_t bits = 0; bits < 63; bits++) {
        for (uint64_t about = 0; about < 5; about++) {
            uint64_t whole = ((uint64_t)1 << bits) + about - 2;
            compare_fraction(0, whole, true);
            compare_fraction(1, whole, true);
            compare_fraction(whole / 2, whole, true);
            compare_fraction(whole / 3, whole, true);
            compare_fraction(whole - 2, whole, true);
            compare_fraction(whole - 1, whole, true);
        }
    }
    for (uint32_t i = 0; i < rounds; i++) {
        uint64_t whole = any_length() >> 1 | 1u;
        uint64_t part = any_64() >> 1;
        /* Shifted below whole: about half as large, or any part of it. */
        while (part >= whole) {
            part >>= 1 + (any_32() >> 9 & 3u);
        }
        compare_fraction(any_32() & 128u ? part : whole - 1u - part, whole, (i & 31u) == 0);
    }
}

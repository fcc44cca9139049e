/* SPDX-License-Identifier: MIT */

#include "equality.h"
#include "sides.h"

static void compare_products(uint32_t a, uint32_t b)
{
    equality_case(core_multiply_u32(a, b) == portable_multiply_u32(a, b));
    equality_case(core_multiply_s32((int32_t)a, (int32_t)b) ==
                  portable_multiply_s32((int32_t)a, (int32_t)b));
    equality_case(core_multiply_su32((int32_t)a, b) == portable_multiply_su32((int32_t)a, b));
}

/* Factors of 31 bits: 2^30 + 2^16 and 2^30 - 1 at the most. */
static void compare_short(uint32_t a, uint32_t b)
{
    const int32_t most = (1 << 30) + (1 << 16);
    int32_t first = (int32_t)a, second = (int32_t)b / 2;
    first = first > most ? most : first < -most ? -most : first;
    second = second == -(1 << 30) ? 1 - (1 << 30) : second;
    equality_case(core_multiply_s31(first, second) == portable_multiply_s31(first, second));
}

void test_short_products(uint32_t rounds)
{
    for (uint32_t i = 0; i < BOUNDARY_32_COUNT; i++) {
        for (uint32_t j = 0; j < BOUNDARY_32_COUNT; j++) {
            compare_short(boundary_32(i), boundary_32(j));
            compare_short(boundary_32(i) + (1u << 16), boundary_32(j));
        }
    }
    for (uint32_t i = 0; i < rounds; i++) {
        compare_short(any_32() >> (any_32() & 31u), any_32());
    }
}

void test_products(uint32_t rounds)
{
    for (uint32_t i = 0; i < BOUNDARY_32_COUNT; i++) {
        for (uint32_t j = 0; j < BOUNDARY_32_COUNT; j++) {
            compare_products(boundary_32(i), boundary_32(j));
        }
    }
    for (uint32_t i = 0; i < rounds; i++) {
        compare_products(any_32() >> (any_32() & 31u), any_32());
    }
}

static void compare_wide(uint64_t a, uint64_t b)
{
    equality_case(core_multiply_s64((int64_t)a, (int64_t)b) ==
                  portable_multiply_s64((int64_t)a, (int64_t)b));
    equality_case(core_multiply_s64_u16((int64_t)a, (uint32_t)(b & 0xFFFFu)) ==
                  portable_multiply_s64((int64_t)a, (int64_t)(b & 0xFFFFu)));
}

void test_wide_products(uint32_t rounds)
{
    for (uint32_t i = 0; i < BOUNDARY_32_COUNT; i++) {
        for (uint32_t j = 0; j < BOUNDARY_32_COUNT; j++) {
            compare_wide((uint64_t)boundary_32(i) << 32 | boundary_32(j), boundary_32(i));
            compare_wide(boundary_32(i), (uint64_t)boundary_32(j) << 31);
        }
    }
    for (uint32_t i = 0; i < rounds; i++) {
        compare_wide(any_length(), any_64());
    }
}

static void compare_high(uint64_t a, uint64_t b)
{
    equality_case(core_multiply_high(a, b) == portable_multiply_high(a, b));
}

void test_high_products(uint32_t rounds)
{
    for (uint32_t i = 0; i < BOUNDARY_32_COUNT; i++) {
        for (uint32_t j = 0; j < BOUNDARY_32_COUNT; j++) {
            uint64_t a = (uint64_t)boundary_32(i) << 32, b = (uint64_t)boundary_32(j) << 32;
            compare_high(a | boundary_32(j), b | boundary_32(i));
            compare_high(a | UINT32_MAX, b | UINT32_MAX);
            compare_high(0u - a, 0u - b - 1u);
        }
    }
    for (uint32_t i = 0; i < rounds; i++) {
        compare_high(any_length(), any_64());
    }
}

void test_leading_zeros(uint32_t rounds)
{
    for (uint32_t i = 1; i < BOUNDARY_32_COUNT; i++) {
        uint32_t value = boundary_32(i) | (boundary_32(i) == 0);
        equality_case(core_leading_zeros(value) == portable_leading_zeros(value));
    }
    for (uint32_t i = 0; i < rounds; i++) {
        uint32_t value = any_32() >> (any_32() & 31u);
        value |= value == 0;
        equality_case(core_leading_zeros(value) == portable_leading_zeros(value));
    }
}

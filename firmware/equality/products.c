/* SPDX-License-Identifier: MIT */
#include "products.h"

#include "equality.h"
#include "sides.h"

static void compare_products(uint32_t a, uint32_t b)
{
    equality_case(core_multiply_u32(a, b) == portable_multiply_u32(a, b));
    equality_case(core_multiply_s32((int32_t)a, (int32_t)b) ==
                  portable_multiply_s32((int32_t)a, (int32_t)b));
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

void test_leading_zeros(uint32_t rounds)
{
    for (uint32_t i = 1; i < BOUNDARY_32_COUNT; i++) {
        uint32_t value = boundary_32(i) | (boundary_32(i) == 0);
        equality_case(core_leading_zeros(value) == portable_leading_zeros(value));
    }
    for (uint32_t i = 0; i < rounds; i++) {
        uint32_t value = any_32() >> (any_32() & 31u) | (any_32() & 1u);
        if (value != 0) {
            equality_case(core_leading_zeros(value) == portable_leading_zeros(value));
        }
    }
}

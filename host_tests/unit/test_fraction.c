/* SPDX-License-Identifier: MIT */
/* A part of a whole, to the last of 64 bits. */
#include "math/arith.h"
#include "math/plane.h"
#include "raster/edge_divide.h"
#include "unit.h"
#include "wide.h"

/* 0 <= 2^64 part - fraction whole < whole. */
static void expect_fraction(uint64_t part, uint64_t whole)
{
    uint64_t fraction = fxl_fraction(part, whole);
    wide half = wide_product((int64_t)(fraction >> 1), (int64_t)whole);
    wide taken = wide_sum(half, half);
    if (fraction & 1) {
        taken = wide_sum(taken, (wide){0, whole});
    }
    wide left = wide_difference((wide){(int64_t)part, 0}, taken);
    TEST_ASSERT_EQUAL_HEX64(0, left.high);
    TEST_ASSERT_TRUE(left.low < whole);
}

void test_small_fractions(void)
{
    for (uint64_t whole = 1; whole < 50; whole++) {
        for (uint64_t part = 0; part < whole; part++) {
            expect_fraction(part, whole);
        }
    }
}

/* Where digits are 0 or all ones, and where estimates go wrong. */
void test_fractions_at_the_ends_of_words(void)
{
    const uint64_t one = 1;
    for (int a = 0; a < 63; a++) {
        for (int b = 0; b <= a; b++) {
            for (uint64_t i = 0; i < 9; i++) {
                uint64_t whole = (one << a) + (one << b) * (i % 3) - i / 3;
                if (whole == 0 || whole >> 63 != 0) {
                    continue;
                }
                expect_fraction(whole - 1, whole);
                expect_fraction(whole / 2, whole);
                expect_fraction(whole > (one << b) ? whole - (one << b) : 0, whole);
            }
        }
    }
}

static uint64_t any_whole(void)
{
    uint64_t whole = (uint64_t)unit_random() << 32 | unit_random();
    switch (unit_random() % 4) {
    case 0:
        whole |= UINT32_MAX;
        break;
    case 1:
        whole &= ~(uint64_t)UINT32_MAX;
        break;
    default:
        break;
    }
    return (whole >> unit_between(1, 62)) + 1;
}

void test_any_fraction(void)
{
    for (int i = 0; i < UNIT_REPEAT; i++) {
        uint64_t whole = any_whole();
        uint64_t part = ((uint64_t)unit_random() << 32 | unit_random()) % whole;
        expect_fraction(part, whole);
        expect_fraction(whole - 1 - part % (whole < 4 ? whole : 4), whole);
    }
}

static void expect_quotient(uint32_t quotient, uint32_t rest, uint32_t denominator)
{
    uint32_t left = 12345;
    TEST_ASSERT_EQUAL_HEX32(
        quotient, fxl_divide_u64((uint64_t)quotient * denominator + rest, denominator, &left));
    TEST_ASSERT_EQUAL_HEX32(rest, left);
}

/* Any quotient and remainder come back from what they were made of; the largest remainder is where
 * an estimate that is too large by one is hardest to tell. */
void test_quotients_and_remainders(void)
{
    for (int i = 0; i < UNIT_REPEAT; i++) {
        const uint32_t denominator = (unit_random() >> unit_random() % 32) | 1u;
        const uint32_t quotient = unit_random() >> unit_random() % 32;
        expect_quotient(quotient, denominator - 1, denominator);
        expect_quotient(quotient, 0, denominator);
        expect_quotient(quotient, unit_random() % denominator, denominator);
        expect_quotient(quotient | 0xFFFFu, denominator - 1, denominator);
        expect_quotient(quotient, UINT32_MAX - 1, UINT32_MAX);
        expect_quotient(quotient, 0x80000000u, 0x80000001u);
    }
}

/* place fill-rule: pictures; columns of edges; corners on centres */
/* whole.fraction is floor(2^32 dividend / height) + 1: more than the exact quotient, by 2^-32 at
 * most. In 64 bits: height whole.fraction is more than 2^32 dividend, by height at most. */
static void expect_edge_quotient(int32_t dividend, uint32_t height)
{
    const fxl_edge_divider divider = fxl_edge_divider_of(height);
    int32_t whole;
    uint32_t fraction;
    fxl_edge_divide(&divider, dividend, &whole, &fraction);
    const int64_t quotient = (int64_t)whole * ((int64_t)1 << 32) + fraction;
    const wide over = wide_difference(wide_product(quotient, (int64_t)height),
                                      wide_product(dividend, (int64_t)1 << 32));
    int64_t more;
    TEST_ASSERT_TRUE(wide_narrow(over, &more));
    TEST_ASSERT_TRUE(more > 0 && more <= (int64_t)height);
    /* The largest power of two that is not above 2^32 / height, or where that is one, its half. */
    const uint64_t power = (uint64_t)1 << fxl_edge_divider_shift(&divider), all = (uint64_t)1 << 32;
    TEST_ASSERT_TRUE(power * height <= all && 2 * power * height >= all);
}

void test_quotients_of_edges(void)
{
    for (int i = 0; i < UNIT_REPEAT; i++) {
        const uint32_t height =
            (uint32_t)unit_between(1, FXL_EDGE_HEIGHT_MAX) >> unit_random() % 26;
        const int32_t dividend = unit_between(-FXL_EDGE_DIVIDEND_MAX, FXL_EDGE_DIVIDEND_MAX);
        const uint32_t divisor = height > 0 ? height : 1;
        const int32_t times = dividend / (int32_t)divisor * (int32_t)divisor;
        expect_edge_quotient(dividend, divisor);
        expect_edge_quotient(times, divisor); /* no remainder */
        expect_edge_quotient(times - (times > 0), divisor);
    }
    expect_edge_quotient(FXL_EDGE_DIVIDEND_MAX, FXL_EDGE_HEIGHT_MAX);
    expect_edge_quotient(-FXL_EDGE_DIVIDEND_MAX, FXL_EDGE_HEIGHT_MAX);
    expect_edge_quotient(0, 1);
}

/* The nearest whole number: from n n - n + 1 to n n + n it is n. */
void test_square_roots(void)
{
    for (int i = 0; i < UNIT_REPEAT; i++) {
        const uint64_t n = i < 100 ? (uint64_t)i : (unit_random() >> unit_random() % 32) & ~1u;
        TEST_ASSERT_EQUAL_HEX32(n, fxl_square_root(n * n));
        TEST_ASSERT_EQUAL_HEX32(n, fxl_square_root(n * n + n));
        TEST_ASSERT_EQUAL_HEX32(n + 1, fxl_square_root(n * n + n + 1));
        TEST_ASSERT_EQUAL_HEX32(n, fxl_square_root(n == 0 ? 0 : n * n - n + 1));
    }
}

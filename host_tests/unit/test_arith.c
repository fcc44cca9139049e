/* SPDX-License-Identifier: MIT */
/* Divisions and the square root by what they promise, up to the ends of their ranges. */
#include "../../lib/math/arith.h"
#include "../../lib/math/plane.h"
#include "unit.h"

void setUp(void)
{
}

void tearDown(void)
{
}

/* A quotient below 2^31 and a denominator of any length. */
static uint32_t any_denominator(void)
{
    const uint32_t denominator = unit_random() >> unit_between(0, 31);
    return denominator == 0 ? 1 : denominator;
}

static void expect_down(int64_t numerator, uint32_t denominator)
{
    const int64_t rest =
        numerator - (int64_t)fxl_divide_down(numerator, denominator) * (int64_t)denominator;
    TEST_ASSERT_TRUE(rest >= 0 && rest < (int64_t)denominator);
}

void test_a_quotient_is_rounded_down(void)
{
    for (int i = 0; i < UNIT_REPEAT; i++) {
        const uint32_t denominator = any_denominator();
        const int64_t whole = (int64_t)(int32_t)unit_random() * denominator;
        expect_down(whole, denominator);
        expect_down(whole < 0 ? whole + (int64_t)(unit_random() % denominator) : whole - 1,
                    denominator);
    }
    expect_down((((int64_t)1 << 31) - 1) * UINT32_MAX, UINT32_MAX);
    expect_down(-((int64_t)1 << 31) * UINT32_MAX, UINT32_MAX);
}

/* Halves are rounded up, also of negative numbers. */
/* SPEC 2.2 */
void test_a_quotient_is_rounded_to_the_nearest(void)
{
    for (int i = 0; i < UNIT_REPEAT; i++) {
        const uint32_t denominator = any_denominator();
        const int64_t part = unit_random() % denominator;
        const int32_t whole = (int32_t)unit_random() / 2;
        TEST_ASSERT_EQUAL_INT32(whole + (2 * part >= (int64_t)denominator),
                                fxl_divide_round((int64_t)whole * denominator + part, denominator));
    }
}

void test_a_quotient_has_its_remainder(void)
{
    for (int i = 0; i < UNIT_REPEAT; i++) {
        const int32_t denominator = (int32_t)(any_denominator() >> 1) + 1;
        const int32_t numerator = (int32_t)unit_random() >> unit_between(0, 31);
        int32_t rest;
        const int32_t quotient = fxl_divide_floor(numerator, denominator, &rest);
        TEST_ASSERT_TRUE(rest >= 0 && rest < denominator);
        TEST_ASSERT_TRUE((int64_t)quotient * denominator + rest == numerator);
    }
}

/* (root - 1/2)^2 <= value <= (root + 1/2)^2, of which root^2 is the whole part of the middle. */
static void expect_root(uint64_t value)
{
    const uint64_t root = fxl_square_root(value);
    TEST_ASSERT_TRUE(value <= root * root + root);
    TEST_ASSERT_TRUE(root == 0 ? value == 0 : value > root * root - root);
}

void test_a_root_is_the_nearest(void)
{
    for (int i = 0; i < UNIT_REPEAT / 4; i++) {
        const uint64_t root = (unit_random() >> unit_between(0, 31)) & 0xFFFFFFFEu;
        const uint64_t between = root * root + root; /* the last that is nearer to root */
        expect_root(root * root);
        expect_root(between);
        expect_root(between + 1);
        TEST_ASSERT_TRUE(fxl_square_root(between) == root);
        TEST_ASSERT_TRUE(fxl_square_root(between + 1) == root + 1);
    }
    expect_root(UINT64_MAX - ((uint64_t)1 << 32));
}

/* Of numbers of all lengths. Double's own error is far below the unit by which both bounds are
 * wider than those of math/arith.h. */
void test_a_ratio_keeps_its_bounds(void)
{
    uint32_t found = 0, refused = 0;
    for (int i = 0; i < UNIT_REPEAT; i++) {
        const int32_t factor = 1 + (int32_t)(fxl_magnitude(unit_wide(29)) >> 1);
        const int32_t limit = 1 + (int32_t)(fxl_magnitude(unit_wide(29)) >> 1);
        const int64_t depth = 1 + (int64_t)(fxl_magnitude(unit_wide(61)) >> unit_between(1, 60));
        const int64_t side = unit_wide((unsigned)unit_between(1, 61));
        const double exact = (double)factor * (double)side / (double)depth;
        const double size = exact < 0 ? -exact : exact, slack = 1 + size / 2147483648.0;
        int32_t quotient = 5;
        if (fxl_ratio(factor, side, depth, limit, &quotient)) {
            TEST_ASSERT_TRUE(size <= limit + slack);
            TEST_ASSERT_NEAR(exact, quotient, slack - 0.499);
            found++;
        } else {
            TEST_ASSERT_TRUE(size >= limit - slack && quotient == 5);
            refused++;
        }
    }
    TEST_ASSERT_TRUE(found > UNIT_REPEAT / 4 && refused > UNIT_REPEAT / 4);
}

void test_bits_are_counted(void)
{
    TEST_ASSERT_EQUAL_UINT32(0, fxl_bit_length(0));
    for (unsigned bit = 0; bit < 64; bit++) {
        const uint64_t power = (uint64_t)1 << bit;
        TEST_ASSERT_EQUAL_UINT32(bit + 1, fxl_bit_length(power));
        TEST_ASSERT_EQUAL_UINT32(bit, fxl_bit_length(power - 1));
    }
    TEST_ASSERT_TRUE(fxl_magnitude(INT64_MIN) == (uint64_t)1 << 63);
    TEST_ASSERT_TRUE(fxl_magnitude(-7) == 7 && fxl_magnitude(7) == 7);
    TEST_ASSERT_TRUE(fxl_within(5, 5) && fxl_within(-5, 5));
    TEST_ASSERT_FALSE(fxl_within(6, 5) || fxl_within(-6, 5));
}

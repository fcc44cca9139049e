/* SPDX-License-Identifier: MIT */
/* Products, divisions, roots and fractions: of the library, and the numbers that the exact checks
 * rest on. */
#include "unit.h"
#include "math/arith.h"
#include "math/plane.h"
#include "raster/edge_divide.h"
#include "wide.h"

/* Products, divisions, roots and fractions. */

/* Divisions and the square root by what they promise, up to the ends of their ranges. */

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

/* A part of a whole, to the last of 64 bits. */

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

/* The numbers that the exact checks rest on. */

static void expect_wide(int64_t high, uint64_t low, wide actual)
{
    TEST_ASSERT_EQUAL_HEX64(high, actual.high);
    TEST_ASSERT_EQUAL_HEX64(low, actual.low);
}

void test_products(void)
{
    const int64_t end = INT64_MAX;
    expect_wide(0, 0, wide_product(0, -5));
    expect_wide(-1, (uint64_t)-35, wide_product(7, -5));
    expect_wide(0, 35, wide_product(-7, -5));
    expect_wide((int64_t)1 << 60, 0, wide_product((int64_t)1 << 62, (int64_t)1 << 62));
    expect_wide(-((int64_t)1 << 60), 0, wide_product((int64_t)1 << 62, -((int64_t)1 << 62)));
    /* (2^63 - 1)^2 = 2^126 - 2^64 + 1 */
    expect_wide(((int64_t)1 << 62) - 1, 1, wide_product(end, end));
    expect_wide(-((int64_t)1 << 62), UINT64_MAX, wide_product(end, -end));
    /* (2^32 + 1)(2^32 - 1) = 2^64 - 1: every carry */
    expect_wide(0, UINT64_MAX, wide_product(((int64_t)1 << 32) + 1, ((int64_t)1 << 32) - 1));
}

void test_a_square_of_a_sum(void)
{
    for (int i = 0; i < UNIT_REPEAT; i++) {
        int64_t a = unit_wide(61), b = unit_wide(61);
        wide left = wide_product(a + b, a + b), cross = wide_product(a, b);
        wide right = wide_sum(wide_product(a, a), wide_product(b, b));
        right = wide_sum(right, wide_sum(cross, cross));
        TEST_ASSERT_EQUAL(0, wide_compare(left, right));
        expect_wide(0, 0, wide_difference(left, right));
        TEST_ASSERT_EQUAL(b < 0 ? -1 : b > 0,
                          wide_compare(wide_sum(left, (wide){-(b < 0), (uint64_t)b}), right));
    }
}

void test_order_and_narrowing(void)
{
    int64_t narrow;
    TEST_ASSERT_EQUAL(-1, wide_compare(wide_product(-1, 1), wide_product(0, 1)));
    TEST_ASSERT_EQUAL(1, wide_compare((wide){1, 0}, (wide){0, UINT64_MAX}));
    TEST_ASSERT_TRUE(wide_narrow(wide_product(INT64_MAX, -1), &narrow));
    TEST_ASSERT_EQUAL_INT64(-INT64_MAX, narrow);
    TEST_ASSERT_FALSE(wide_narrow((wide){0, (uint64_t)1 << 63}, &narrow));
    TEST_ASSERT_FALSE(wide_narrow((wide){-1, 5}, &narrow));
}

/* a b - c b = (a - c) b; and the compiler's own 128 bits, where it has them. */
void test_a_difference_of_products(void)
{
    for (int i = 0; i < UNIT_REPEAT; i++) {
        int64_t a = unit_wide(62), b = unit_wide((unsigned)unit_between(1, 62)), c = unit_wide(62);
        wide ours = wide_difference(wide_product(a, b), wide_product(c, b));
        TEST_ASSERT_EQUAL(0, wide_compare(wide_product(a - c, b), ours));
#ifdef __SIZEOF_INT128__
        __extension__ __int128 sum = (__int128)a * b - (__int128)c * b;
        expect_wide((int64_t)(sum >> 64), (uint64_t)sum, ours);
#endif
    }
}

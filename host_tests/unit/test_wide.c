/* SPDX-License-Identifier: MIT */
/* The numbers that the exact checks rest on. */
#include "unit.h"
#include "wide.h"

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

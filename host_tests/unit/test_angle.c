/* SPDX-License-Identifier: MIT */
#include <math.h>

#include "unit.h"

static double true_sine(fxl_angle angle)
{
    return sin((double)angle * (3.14159265358979323846 / 2147483648.0)) * 1073741824.0;
}

/* SPEC 1.2a, 2.1c */
void test_quarters_are_exact(void)
{
    TEST_ASSERT_EQUAL_INT32(0, fxl_sin(0));
    TEST_ASSERT_EQUAL_INT32(FXL_Q2_30_ONE, fxl_sin(FXL_ANGLE_QUARTER));
    TEST_ASSERT_EQUAL_INT32(0, fxl_sin(2u * FXL_ANGLE_QUARTER));
    TEST_ASSERT_EQUAL_INT32(-FXL_Q2_30_ONE, fxl_sin(3u * FXL_ANGLE_QUARTER));
    TEST_ASSERT_EQUAL_INT32(FXL_Q2_30_ONE, fxl_cos(0));
    TEST_ASSERT_EQUAL_INT32(0, fxl_cos(FXL_ANGLE_QUARTER));
    TEST_ASSERT_EQUAL_INT32(-FXL_Q2_30_ONE, fxl_cos(2u * FXL_ANGLE_QUARTER));
}

/* SPEC 1.2a, 2.1f */
void test_sine_is_within_one_unit(void)
{
    for (int i = 0; i < 10 * UNIT_REPEAT; i++) {
        fxl_angle angle = unit_random();
        TEST_ASSERT_NEAR(fxl_sin(angle), true_sine(angle), 1.0 + 1e-6);
    }
}

/* Where an approximation is pieced together: around every 1024th of a turn. */
void test_sine_is_within_one_unit_at_the_seams(void)
{
    for (uint32_t seam = 0; seam < 1024; seam++) {
        for (int32_t near = -2; near <= 2; near++) {
            fxl_angle angle = seam * 0x400000u + (uint32_t)near;
            TEST_ASSERT_NEAR(fxl_sin(angle), true_sine(angle), 1.0 + 1e-6);
        }
    }
}

void test_sine_is_odd_and_cosine_even(void)
{
    for (int i = 0; i < UNIT_REPEAT; i++) {
        fxl_angle angle = unit_random();
        TEST_ASSERT_EQUAL_INT32(-fxl_sin(angle), fxl_sin(0u - angle));
        TEST_ASSERT_EQUAL_INT32(fxl_cos(angle), fxl_cos(0u - angle));
    }
}

/* SPEC 1.2b */
void test_cosine_is_the_sine_a_quarter_later(void)
{
    for (int i = 0; i < UNIT_REPEAT; i++) {
        fxl_angle angle = unit_random();
        TEST_ASSERT_EQUAL_INT32(fxl_sin(angle + FXL_ANGLE_QUARTER), fxl_cos(angle));
    }
}

void test_nothing_exceeds_one(void)
{
    for (uint32_t i = 0; i < 4096; i++) {
        fxl_q2_30 sine = fxl_sin(FXL_ANGLE_QUARTER - 2048u + i);
        TEST_ASSERT_TRUE(sine <= FXL_Q2_30_ONE && sine >= FXL_Q2_30_ONE - 1);
    }
}

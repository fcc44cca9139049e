/* SPDX-License-Identifier: MIT */
#include <math.h>

#include "unit.h"

static fxl_status try_lens(uint16_t width, uint16_t height, fxl_angle fov, fxl_q16_16 near,
                           fxl_q16_16 far, fxl_q16_16 inset)
{
    fxl_lens lens, before;
    memset(&lens, 0x5A, sizeof lens);
    memcpy(&before, &lens, sizeof before);
    fxl_status status = fxl_lens_from_fov(width, height, fov, near, far, inset, &lens);
    if (status != FXL_OK) {
        TEST_ASSERT_EQUAL_MEMORY(&before, &lens, sizeof before);
    }
    return status;
}

void test_ninety_degrees_is_half_the_width(void)
{
    fxl_lens lens = unit_lens(320, 240);
    TEST_ASSERT_NEAR(lens.focal, Q16(160), 1);
    TEST_ASSERT_EQUAL(320, lens.width);
    TEST_ASSERT_EQUAL(240, lens.height);
    TEST_ASSERT_EQUAL_INT32(Q16(0.0625), lens.near);
    TEST_ASSERT_EQUAL_INT32(Q16(1000), lens.far);
    TEST_ASSERT_EQUAL_INT32(4, lens.inset);
}

void test_focal_is_within_its_bound(void)
{
    const fxl_angle ends[] = {FXL_FOV_MIN, FXL_FOV_MAX, FXL_FOV_MIN + 1, FXL_FOV_MAX - 1};
    for (int i = 0; i < UNIT_REPEAT / 10; i++) {
        uint16_t width = (uint16_t)unit_between(1, FXL_SCREEN_MAX);
        fxl_angle fov = (fxl_angle)unit_between((int32_t)FXL_FOV_MIN, (int32_t)FXL_FOV_MAX);
        fxl_lens lens;
        if (i < 4) {
            fov = ends[i];
            width = FXL_SCREEN_MAX;
        }
        TEST_ASSERT_EQUAL(FXL_OK, fxl_lens_from_fov(width, 1, fov, Q16(1), Q16(2), 0, &lens));
        double focal = width / 2.0 / tan(fov * (3.14159265358979323846 / 4294967296.0)) * 65536.0;
        TEST_ASSERT_NEAR(lens.focal, focal, 1 + focal / 268435456.0);
    }
}

void test_the_ends_of_every_range_are_taken(void)
{
    TEST_ASSERT_EQUAL(FXL_OK, try_lens(1, 1, FXL_FOV_MIN, FXL_NEAR_MIN, FXL_FAR_MAX, 0));
    TEST_ASSERT_EQUAL(FXL_OK, try_lens(FXL_SCREEN_MAX, FXL_SCREEN_MAX, FXL_FOV_MAX, FXL_NEAR_MIN,
                                       FXL_FAR_MAX, FXL_INSET_MAX));
    TEST_ASSERT_EQUAL(FXL_OK, try_lens(1, 1, FXL_FOV_MIN, 1000, 1021, 10));
}

void test_what_is_out_of_range_is_refused(void)
{
    const fxl_angle fov = FXL_ANGLE_QUARTER;
    TEST_ASSERT_EQUAL(FXL_E_RANGE, try_lens(0, 9, fov, 999, 99999, 0));
    TEST_ASSERT_EQUAL(FXL_E_RANGE, try_lens(9, 0, fov, 999, 99999, 0));
    TEST_ASSERT_EQUAL(FXL_E_RANGE, try_lens(FXL_SCREEN_MAX + 1, 9, fov, 999, 99999, 0));
    TEST_ASSERT_EQUAL(FXL_E_RANGE, try_lens(9, FXL_SCREEN_MAX + 1, fov, 999, 99999, 0));
    TEST_ASSERT_EQUAL(FXL_E_RANGE, try_lens(9, 9, FXL_FOV_MIN - 1, 999, 99999, 0));
    TEST_ASSERT_EQUAL(FXL_E_RANGE, try_lens(9, 9, FXL_FOV_MAX + 1, 999, 99999, 0));
    TEST_ASSERT_EQUAL(FXL_E_RANGE, try_lens(9, 9, fov, FXL_NEAR_MIN - 1, 99999, 0));
    TEST_ASSERT_EQUAL(FXL_E_RANGE, try_lens(9, 9, fov, -999, 99999, 0));
    TEST_ASSERT_EQUAL(FXL_E_RANGE, try_lens(9, 9, fov, 999, FXL_FAR_MAX + 1, 0));
    TEST_ASSERT_EQUAL(FXL_E_RANGE, try_lens(9, 9, fov, 999, 99999, -1));
    TEST_ASSERT_EQUAL(FXL_E_RANGE, try_lens(9, 9, fov, 999, FXL_FAR_MAX, FXL_INSET_MAX + 1));
    TEST_ASSERT_EQUAL(FXL_E_RANGE, try_lens(9, 9, fov, 1000, 1020, 10));
    TEST_ASSERT_EQUAL(FXL_E_RANGE, try_lens(9, 9, fov, INT32_MAX, 99999, FXL_INSET_MAX));
}

void test_null_is_refused(void)
{
    TEST_ASSERT_EQUAL(FXL_E_ARGUMENT,
                      fxl_lens_from_fov(9, 9, FXL_ANGLE_QUARTER, 999, 99999, 0, NULL));
}

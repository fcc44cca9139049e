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

/* SPEC 2.1 */
void test_ninety_degrees_is_half_the_width(void)
{
    fxl_lens lens = unit_lens(320, 240);
    TEST_ASSERT_NEAR(lens.focal, Q16(160), 1);
    TEST_ASSERT_EQUAL(320, lens.width);
    TEST_ASSERT_EQUAL(240, lens.height);
    TEST_ASSERT_EQUAL_INT32(Q16(0.0625), lens.near_z);
    TEST_ASSERT_EQUAL_INT32(Q16(1000), lens.far_z);
    TEST_ASSERT_EQUAL_INT32(4, lens.inset);
}

/* SPEC 4.2, accuracy 1.1 */
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
        TEST_ASSERT_NEAR(lens.focal, focal, 0.5 + focal / 268435456.0);
    }
}

/* SPEC 3.1 */
void test_the_ends_of_every_range_are_taken(void)
{
    TEST_ASSERT_EQUAL(FXL_OK, try_lens(1, 1, FXL_FOV_MIN, FXL_NEAR_MIN, FXL_FAR_MAX, 0));
    TEST_ASSERT_EQUAL(FXL_OK, try_lens(FXL_SCREEN_MAX, FXL_SCREEN_MAX, FXL_FOV_MAX, FXL_NEAR_MIN,
                                       FXL_FAR_MAX, FXL_INSET_MAX));
    TEST_ASSERT_EQUAL(FXL_OK, try_lens(1, 1, FXL_FOV_MIN, 1000, 1021, 10));
    TEST_ASSERT_EQUAL_HEX32(FXL_DEGREES(10), FXL_FOV_MIN);
    TEST_ASSERT_EQUAL_HEX32(FXL_DEGREES(150), FXL_FOV_MAX);
}

/* SPEC 3.1 */
void test_what_is_out_of_range_is_refused(void)
{
    const fxl_angle fov = FXL_ANGLE_QUARTER;
    TEST_ASSERT_EQUAL(FXL_E_RANGE, try_lens(0, 9, fov, 999, 99999, 0));
    TEST_ASSERT_EQUAL(FXL_E_RANGE, try_lens(9, 0, fov, 999, 99999, 0));
    TEST_ASSERT_EQUAL(FXL_E_RANGE, try_lens(FXL_SCREEN_MAX + 1, 9, fov, 999, 99999, 0));
    TEST_ASSERT_EQUAL(FXL_E_RANGE, try_lens(9, FXL_SCREEN_MAX + 1, fov, 999, 99999, 0));
    TEST_ASSERT_EQUAL(FXL_E_RANGE, try_lens(FXL_SCREEN_MAX + 1, 1, fov, 999, 99999, 0));
    TEST_ASSERT_EQUAL(FXL_E_RANGE, try_lens(1, FXL_SCREEN_MAX + 1, fov, 999, 99999, 0));
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
    TEST_ASSERT_FALSE(fxl_lens_is_valid(NULL));
}

/* What a lens would be with one member changed. */
static bool is_valid_with(int member, int32_t value)
{
    fxl_lens lens = {.width = 320,
                     .height = 240,
                     .focal = Q16(160),
                     .near_z = Q16(1),
                     .far_z = Q16(1) + 1000,
                     .inset = 4};
    lens.width = member == 0 ? (uint16_t)value : lens.width;
    lens.height = member == 1 ? (uint16_t)value : lens.height;
    lens.focal = member == 2 ? value : lens.focal;
    lens.near_z = member == 3 ? value : lens.near_z;
    lens.far_z = member == 4 ? value : lens.far_z;
    lens.inset = member == 5 ? value : lens.inset;
    lens.centre_x = lens.width * 32768;
    lens.centre_y = lens.height * 32768;
    /* The focal length of 90 degrees is that of the width. */
    lens.focal = member == 0 ? Q16(0.5) * (lens.width > 0 ? lens.width : 1) : lens.focal;
    return fxl_lens_is_valid(&lens);
}

/* Every member has a least and a most; the focal length is measured by the width, and twice the
 * inset by the depth. */
void test_the_ends_of_a_valid_lens(void)
{
    static const struct {
        int member;
        int32_t least, most;
    } ends[] = {{0, 1, FXL_SCREEN_MAX},
                {1, 1, FXL_SCREEN_MAX},
                {2, 320 * 0x2240, 320 * 0x5B800}, /* widths times 0.1338 and 5.719 */
                {3, FXL_NEAR_MIN, Q16(1) + 1000 - 9},
                {4, Q16(1) + 9, FXL_FAR_MAX},
                {5, 0, 499}};
    for (size_t i = 0; i < sizeof ends / sizeof ends[0]; i++) {
        TEST_ASSERT_TRUE(is_valid_with(ends[i].member, ends[i].least));
        TEST_ASSERT_TRUE(is_valid_with(ends[i].member, ends[i].most));
        TEST_ASSERT_FALSE(is_valid_with(ends[i].member, ends[i].least - 1));
        TEST_ASSERT_FALSE(is_valid_with(ends[i].member, ends[i].most + 1));
    }
    TEST_ASSERT_FALSE(is_valid_with(2, INT32_MIN));
    TEST_ASSERT_FALSE(is_valid_with(2, INT32_MAX));
    fxl_lens lens = unit_lens(320, 240);
    lens.inset = FXL_INSET_MAX;
    TEST_ASSERT_TRUE(fxl_lens_is_valid(&lens));
    lens.inset = FXL_INSET_MAX + 1;
    TEST_ASSERT_FALSE(fxl_lens_is_valid(&lens));
}

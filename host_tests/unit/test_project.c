/* SPDX-License-Identifier: MIT */
#include "unit.h"

static fxl_screen_point project(const fxl_lens *lens, int32_t x, int32_t y, int32_t z)
{
    fxl_view_point view = {x, y, z, 0};
    fxl_screen_point screen;
    TEST_ASSERT_EQUAL(FXL_OK, fxl_project_point(lens, &view, &screen));
    return screen;
}

void test_straight_ahead_is_the_middle(void)
{
    fxl_lens lens = unit_lens(320, 240);
    fxl_screen_point screen = project(&lens, 0, 0, 1 << 30);
    TEST_ASSERT_EQUAL_INT32(Q16(160), screen.x);
    TEST_ASSERT_EQUAL_INT32(Q16(120), screen.y);
    lens = unit_lens(63, 1);
    screen = project(&lens, 0, 0, 1); /* the smallest depth there is */
    TEST_ASSERT_EQUAL_INT32(Q16(31.5), screen.x);
    TEST_ASSERT_EQUAL_INT32(Q16(0.5), screen.y);
}

void test_right_is_right_and_up_is_up(void)
{
    fxl_lens lens = unit_lens(320, 240);
    lens.focal = Q16(160);
    fxl_screen_point screen = project(&lens, 1 << 29, 0, 1 << 30);
    TEST_ASSERT_EQUAL_INT32(Q16(240), screen.x);
    screen = project(&lens, 0, 1 << 29, 1 << 30);
    TEST_ASSERT_EQUAL_INT32(Q16(40), screen.y);
}

/* 5852 pixels of focal length are below 2^29 units; times 2^31, below 2^60. */
static void expect_nearest(int64_t focal, int32_t side, int32_t depth, int32_t offset)
{
    int64_t twice_error = 2 * ((int64_t)offset * depth - focal * side);
    TEST_ASSERT_TRUE(twice_error <= depth && twice_error >= -(int64_t)depth);
}

void test_rounding_is_to_nearest(void)
{
    int projected = 0;
    for (int i = 0; i < UNIT_REPEAT; i++) {
        fxl_lens lens;
        fxl_angle fov = (fxl_angle)unit_between((int32_t)FXL_FOV_MIN, (int32_t)FXL_FOV_MAX);
        fxl_screen_point screen;
        TEST_ASSERT_EQUAL(FXL_OK, fxl_lens_from_fov((uint16_t)unit_between(1, FXL_SCREEN_MAX),
                                                    (uint16_t)unit_between(1, FXL_SCREEN_MAX), fov,
                                                    Q16(1), Q16(2), 0, &lens));
        fxl_view_point view = {unit_between(-INT32_MAX, INT32_MAX),
                               unit_between(-INT32_MAX, INT32_MAX), unit_between(1, INT32_MAX),
                               (int8_t)unit_between(-15, 30)};
        if (fxl_project_point(&lens, &view, &screen) != FXL_OK) {
            continue;
        }
        projected++;
        expect_nearest(lens.focal, view.x, view.z, screen.x - lens.width * 32768);
        expect_nearest(lens.focal, view.y, view.z, lens.height * 32768 - screen.y);
    }
    TEST_ASSERT_TRUE_MESSAGE(projected > UNIT_REPEAT / 4, "too few were on the screen");
}

/* Offsets of 1/2 and -1/2 unit, from the middle: halves go upward. */
void test_halves_go_upward(void)
{
    fxl_lens lens = unit_lens(2, 2);
    lens.focal = Q16(1);
    TEST_ASSERT_EQUAL_INT32(Q16(1) + 1, project(&lens, 1 << 13, 0, 1 << 30).x);
    TEST_ASSERT_EQUAL_INT32(Q16(1), project(&lens, -(1 << 13), 0, 1 << 30).x);
}

void test_the_exponent_cancels(void)
{
    fxl_lens lens = unit_lens(320, 240);
    fxl_view_point view = {123456789, -98765432, 1234567890, -15};
    fxl_screen_point first, screen;
    TEST_ASSERT_EQUAL(FXL_OK, fxl_project_point(&lens, &view, &first));
    view.exponent = 30;
    TEST_ASSERT_EQUAL(FXL_OK, fxl_project_point(&lens, &view, &screen));
    TEST_ASSERT_EQUAL_MEMORY(&first, &screen, sizeof first);
}

static void expect_refused(const fxl_lens *lens, int32_t x, int32_t y, int32_t z)
{
    fxl_view_point view = {x, y, z, 0};
    fxl_screen_point screen = {12345, 54321};
    TEST_ASSERT_EQUAL(FXL_E_RANGE, fxl_project_point(lens, &view, &screen));
    TEST_ASSERT_EQUAL_INT32(12345, screen.x);
    TEST_ASSERT_EQUAL_INT32(54321, screen.y);
}

void test_what_is_off_range_is_refused(void)
{
    fxl_lens lens = unit_lens(320, 240);
    lens.focal = Q16(160);
    expect_refused(&lens, 0, 0, 0);
    expect_refused(&lens, 5, 5, -1);
    expect_refused(&lens, 0, 0, -INT32_MAX);
    expect_refused(&lens, INT32_MAX, 0, 1);
    expect_refused(&lens, -INT32_MAX, 0, 1);
    expect_refused(&lens, 0, INT32_MAX, 1);
    expect_refused(&lens, 0, -INT32_MAX, 1);
}

/* 160 + 3935 = 4095, and a unit more; 160 - 4255 = -4095, and a unit less. */
void test_the_range_ends_at_4095(void)
{
    fxl_lens lens = unit_lens(320, 320);
    lens.focal = Q16(1);
    TEST_ASSERT_EQUAL_INT32(Q16(4095), project(&lens, 3935 << 16, 0, 1 << 16).x);
    TEST_ASSERT_EQUAL_INT32(Q16(-4095), project(&lens, -(4255 << 16), 0, 1 << 16).x);
    TEST_ASSERT_EQUAL_INT32(Q16(4095), project(&lens, 0, -(3935 << 16), 1 << 16).y);
    TEST_ASSERT_EQUAL_INT32(Q16(-4095), project(&lens, 0, 4255 << 16, 1 << 16).y);
    expect_refused(&lens, (3935 << 16) + 1, 0, 1 << 16);
    expect_refused(&lens, -(4255 << 16) - 1, 0, 1 << 16);
    expect_refused(&lens, 0, -(3935 << 16) - 1, 1 << 16);
    expect_refused(&lens, 0, (4255 << 16) + 1, 1 << 16);
}

void test_a_polygon_is_its_points(void)
{
    fxl_lens lens = unit_lens(320, 240);
    fxl_view_polygon view = {.colour = 9, .count = 3};
    view.points[0] = (fxl_view_point){100, 200, 1 << 30, 0};
    view.points[1] = (fxl_view_point){-(1 << 29), 1 << 28, 1 << 30, 4};
    view.points[2] = (fxl_view_point){77777777, 1 << 25, 1 << 29, -3};
    fxl_screen_polygon screen;
    TEST_ASSERT_EQUAL(FXL_OK, fxl_project_polygon(&lens, &view, &screen));
    TEST_ASSERT_EQUAL(9, screen.colour);
    TEST_ASSERT_EQUAL(3, screen.count);
    for (int i = 0; i < 3; i++) {
        fxl_screen_point point;
        TEST_ASSERT_EQUAL(FXL_OK, fxl_project_point(&lens, &view.points[i], &point));
        TEST_ASSERT_EQUAL_MEMORY(&point, &screen.points[i], sizeof point);
    }
    view.points[2].z = 0;
    TEST_ASSERT_EQUAL(FXL_E_RANGE, fxl_project_polygon(&lens, &view, &screen));
    TEST_ASSERT_EQUAL(0, screen.count);
}

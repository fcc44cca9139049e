/* SPDX-License-Identifier: MIT */
#include "unit.h"

/* Each product is below 2^60 and each sum below 2^61, see SPEC.md, section 3. */
static int64_t dot(fxl_direction n, fxl_point p)
{
    return (int64_t)n.x * p.x + (int64_t)n.y * p.y + (int64_t)n.z * p.z;
}

void test_inside_is_where_the_normal_points(void)
{
    fxl_direction up = {0, FXL_Q2_30_ONE, 0};
    fxl_point on = {Q16(5), Q16(2), Q16(-7)};
    fxl_plane plane = fxl_plane_from_point(&on, &up, 0);
    fxl_point above = {Q16(-1), Q16(2) + 1, Q16(4)}, below = {Q16(9), Q16(2) - 1, 0};
    TEST_ASSERT_EQUAL_INT64((int64_t)1 << 30, fxl_plane_distance(&plane, &above));
    TEST_ASSERT_EQUAL_INT64(-((int64_t)1 << 30), fxl_plane_distance(&plane, &below));
    TEST_ASSERT_EQUAL_INT64(0, fxl_plane_distance(&plane, &on));
}

void test_inset_moves_the_plane_inside(void)
{
    fxl_direction left = {-FXL_Q2_30_ONE, 0, 0};
    fxl_point on = {Q16(3), 0, 0};
    fxl_plane plane = fxl_plane_from_point(&on, &left, Q16(0.5));
    fxl_point moved = {Q16(2.5), 0, 0};
    TEST_ASSERT_EQUAL_INT64(0, fxl_plane_distance(&plane, &moved));
    TEST_ASSERT_EQUAL_INT64(-((int64_t)Q16(0.5) << 30), fxl_plane_distance(&plane, &on));
}

void test_distance_is_exact(void)
{
    for (int i = 0; i < UNIT_REPEAT; i++) {
        fxl_point on = unit_point(FXL_COORDINATE_MAX), at = unit_point(FXL_COORDINATE_MAX);
        fxl_direction normal = unit_direction();
        fxl_q16_16 inset = unit_between(0, FXL_INSET_MAX);
        fxl_plane plane = fxl_plane_from_point(&on, &normal, inset);
        int64_t distance = dot(normal, at) - dot(normal, on) - ((int64_t)inset << 30);
        TEST_ASSERT_EQUAL_INT64(distance, fxl_plane_distance(&plane, &at));
    }
}

/* SPEC 3.3 */
void test_the_farthest_corners_do_not_overflow(void)
{
    const fxl_q16_16 end = FXL_COORDINATE_MAX;
    fxl_direction normal = {619925131, 619925131, 619925132}; /* 1/sqrt 3, rounded */
    fxl_point low = {-end, -end, -end}, high = {end, end, end};
    fxl_plane plane = fxl_plane_from_point(&low, &normal, 0);
    TEST_ASSERT_EQUAL_INT64(2 * dot(normal, high), fxl_plane_distance(&plane, &high));
    plane = fxl_plane_from_point(&high, &normal, FXL_INSET_MAX);
    TEST_ASSERT_EQUAL_INT64(-2 * dot(normal, high) - ((int64_t)FXL_INSET_MAX << 30),
                            fxl_plane_distance(&plane, &low));
}

/* SPDX-License-Identifier: MIT */
/* Planes: from a point and a normal, from three points, and the distance from one. */
#include <math.h>

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

/* SPEC 3.3a-c */
void test_the_farthest_corners_do_not_overflow(void)
{
    const fxl_q16_16 end = FXL_COORDINATE_MAX;
    fxl_direction normal = {619925131, 619925131, 619925132}; /* 1/sqrt 3, rounded */
    fxl_point low = {-end, -end, -end}, high = {end, end, end};
    TEST_ASSERT_TRUE(2 * (int64_t)end < (int64_t)1 << 30);
    TEST_ASSERT_TRUE(2 * dot(normal, high) < (int64_t)1 << 61);
    fxl_plane plane = fxl_plane_from_point(&low, &normal, 0);
    TEST_ASSERT_EQUAL_INT64(2 * dot(normal, high), fxl_plane_distance(&plane, &high));
    plane = fxl_plane_from_point(&high, &normal, FXL_INSET_MAX);
    TEST_ASSERT_EQUAL_INT64(-2 * dot(normal, high) - ((int64_t)FXL_INSET_MAX << 30),
                            fxl_plane_distance(&plane, &low));
}

/* clippers 3.4i */
void test_the_normal_points_to_where_they_run_clockwise(void)
{
    const fxl_point a = {Q16(1), Q16(2), Q16(7)}, right = {Q16(4), Q16(2), Q16(7)},
                    up = {Q16(1), Q16(3), Q16(7)};
    fxl_plane plane;
    TEST_ASSERT_EQUAL(FXL_OK, fxl_plane_from_points(&a, &up, &right, &plane));
    TEST_ASSERT_EQUAL_INT32(0, plane.normal.x);
    TEST_ASSERT_EQUAL_INT32(0, plane.normal.y);
    TEST_ASSERT_EQUAL_INT32(-FXL_Q2_30_ONE, plane.normal.z); /* towards an eye at the origin */
    TEST_ASSERT_EQUAL_INT64(-((int64_t)Q16(7) << 30), plane.distance);
    TEST_ASSERT_EQUAL(FXL_OK, fxl_plane_from_points(&a, &right, &up, &plane));
    TEST_ASSERT_EQUAL_INT32(FXL_Q2_30_ONE, plane.normal.z);
}

static void expect_refused(fxl_status wanted, const fxl_point *a, const fxl_point *b,
                           const fxl_point *c)
{
    fxl_plane plane, before;
    memset(&plane, 0x5A, sizeof plane);
    before = plane;
    TEST_ASSERT_EQUAL(wanted, fxl_plane_from_points(a, b, c, &plane));
    TEST_ASSERT_EQUAL_MEMORY(&before, &plane, sizeof plane);
}

void test_points_that_make_no_plane_are_refused(void)
{
    const fxl_q16_16 end = FXL_COORDINATE_MAX;
    const fxl_point a = {0, 0, 0}, b = {1, 2, 3}, c = {3, 6, 9}, beside = {3, 6, 10};
    const fxl_point corner = {end, end, end}, opposite = {-end, -end, -end};
    fxl_plane plane;
    expect_refused(FXL_E_DEGENERATE, &a, &b, &c);
    expect_refused(FXL_E_DEGENERATE, &a, &a, &b);
    expect_refused(FXL_E_DEGENERATE, &b, &b, &b);
    expect_refused(FXL_E_DEGENERATE, &corner, &a, &opposite);
    TEST_ASSERT_EQUAL(FXL_OK, fxl_plane_from_points(&a, &b, &beside, &plane));
    expect_refused(FXL_E_ARGUMENT, NULL, &b, &c);
    expect_refused(FXL_E_ARGUMENT, &a, NULL, &c);
    expect_refused(FXL_E_ARGUMENT, &a, &b, NULL);
    TEST_ASSERT_EQUAL(FXL_E_ARGUMENT, fxl_plane_from_points(&a, &b, &beside, NULL));
    for (int i = 0; i < 9; i++) { /* each coordinate of each point, one unit beyond */
        fxl_point points[3] = {{0, 0, 0}, {0, 1, 0}, {1, 0, 0}};
        fxl_point *at = &points[i / 3];
        *(i % 3 == 0 ? &at->x : i % 3 == 1 ? &at->y : &at->z) = i % 2 ? end + 1 : -end - 1;
        expect_refused(FXL_E_RANGE, &points[0], &points[1], &points[2]);
    }
}

/* The cross product is exact in 64 bits: its terms are below 2^60. A double is within 2^-52 of it
 * and of its length. */
static void expect_bound(const fxl_point *a, const fxl_point *b, const fxl_point *c)
{
    const int64_t ux = b->x - a->x, uy = b->y - a->y, uz = b->z - a->z;
    const int64_t vx = c->x - a->x, vy = c->y - a->y, vz = c->z - a->z;
    const int64_t x = uy * vz - uz * vy, y = uz * vx - ux * vz, z = ux * vy - uy * vx;
    fxl_plane plane;
    if (x == 0 && y == 0 && z == 0) {
        TEST_ASSERT_EQUAL(FXL_E_DEGENERATE, fxl_plane_from_points(a, b, c, &plane));
        return;
    }
    TEST_ASSERT_EQUAL(FXL_OK, fxl_plane_from_points(a, b, c, &plane));
    const double length =
        sqrt((double)x * (double)x + (double)y * (double)y + (double)z * (double)z);
    TEST_ASSERT_NEAR(plane.normal.x, (double)x / length * 1073741824.0, 2.5);
    TEST_ASSERT_NEAR(plane.normal.y, (double)y / length * 1073741824.0, 2.5);
    TEST_ASSERT_NEAR(plane.normal.z, (double)z / length * 1073741824.0, 2.5);
    TEST_ASSERT_EQUAL_INT64(0, fxl_plane_distance(&plane, a));
    const int64_t near = (int64_t)1 << (46 - 13);
    TEST_ASSERT_TRUE(fxl_plane_distance(&plane, b) <= near &&
                     fxl_plane_distance(&plane, b) >= -near);
    TEST_ASSERT_TRUE(fxl_plane_distance(&plane, c) <= near &&
                     fxl_plane_distance(&plane, c) >= -near);
}

/* clippers 3.4f, 3.4h, 3.4j */
void test_any_three_points(void)
{
    for (int i = 0; i < UNIT_REPEAT / 4; i++) {
        const fxl_q16_16 limit = i % 3 == 0   ? FXL_COORDINATE_MAX
                                 : i % 3 == 1 ? Q16(10)
                                              : unit_between(1, 50); /* on a line, now and then */
        const fxl_point a = unit_point(limit), b = unit_point(limit), c = unit_point(limit);
        expect_bound(&a, &b, &c);
    }
}

/* Points that lie nearly on a line, from one end of the world to the other. */
void test_slender_triangles(void)
{
    for (int i = 0; i < UNIT_REPEAT / 8; i++) {
        const fxl_q16_16 limit = FXL_COORDINATE_MAX - 1;
        const fxl_point a = unit_point(limit), b = unit_point(limit);
        const fxl_point c = {(a.x + b.x) / 2 + unit_between(-1, 1), (a.y + b.y) / 2,
                             (a.z + b.z) / 2};
        expect_bound(&a, &b, &c);
    }
}

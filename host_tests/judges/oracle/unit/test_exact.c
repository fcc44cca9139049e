/* SPDX-License-Identifier: MIT */
/* Tests the oracle's own parts against results known by hand. */
#include <math.h>
#include <stddef.h>

#include "oracle/clip.h"
#include "oracle/cover.h"
#include "unity.h"

#define UNIT ((int64_t)1 << 32) /* 1/65536 pixel */

void setUp(void)
{
}

void tearDown(void)
{
}

static void expect_near(double expected, double got)
{
    TEST_ASSERT_TRUE(got >= expected - 1e-9 && got <= expected * (1 + 1.0 / 64) + 0x1p-9);
}

static void square(int64_t x, int64_t y, int64_t side, oracle_spot spots[4])
{
    for (int i = 0; i < 4; i++) {
        spots[i].x = (x + (i == 1 || i == 2 ? side : 0)) * UNIT;
        spots[i].y = (y + (i >= 2 ? side : 0)) * UNIT;
    }
}

void test_hausdorff_of_squares(void)
{
    oracle_spot a[4], b[4];
    square(0, 0, 1 << 26, a);
    square(3, 0, 1 << 26, b);
    expect_near(3, oracle_hausdorff(a, 4, b, 4));
    expect_near(0, oracle_hausdorff(a, 4, a, 4));
    /* One outline within the other: the largest distance is at a corner. */
    square(100, 100, 800, a);
    square(0, 0, 1000, b);
    expect_near(100 * sqrt(2), oracle_hausdorff(a, 4, b, 4));
    expect_near(100 * sqrt(2), oracle_hausdorff(b, 4, a, 4));
}

void test_hausdorff_inside_an_edge(void)
{
    /* The corners of a are on b; the middle of a's long edge is not. */
    const oracle_spot a[3] = {{0, 0}, {1000 * UNIT, 0}, {0, 500 * UNIT}};
    const oracle_spot b[4] = {{0, 0}, {500 * UNIT, -200 * UNIT}, {1000 * UNIT, 0}, {0, 500 * UNIT}};
    expect_near(200, oracle_hausdorff(a, 3, b, 4));
    /* And with the dent the other way a's edge is the farther one. */
    const oracle_spot c[4] = {{0, 0}, {500 * UNIT, 40 * UNIT}, {1000 * UNIT, 0}, {0, 500 * UNIT}};
    expect_near(500 * sin(atan(40.0 / 500)),
                oracle_from_segment(&(oracle_spot){500 * UNIT, 0}, &c[0], &c[1]));
    expect_near(40, oracle_hausdorff(a, 3, c, 4));
}

void test_stroke(void)
{
    const oracle_spot thin[4] = {{0, 0}, {900 * UNIT, UNIT}, {1000 * UNIT, 0}, {500 * UNIT, -UNIT}};
    expect_near(1, oracle_from_stroke(thin, 4));
}

static fxl_view straight_view(void)
{
    fxl_view view;
    fxl_pose pose = {{0, 0, 0}, 0, 0, 0};
    fxl_camera_from_pose(&pose, &view.camera);
    fxl_lens_from_fov(64, 64, FXL_ANGLE_QUARTER, 65536, 100 * 65536, 0, &view.lens);
    fxl_view_frustum_from_lens(&view.lens, &view.view_frustum);
    return view;
}

static fxl_polygon world_polygon(int count, const int32_t (*vertices)[3])
{
    fxl_polygon polygon = {.colour = 1, .count = (uint8_t)count};
    for (int i = 0; i < count; i++) {
        polygon.vertices[i].position =
            (fxl_point){vertices[i][0] * 65536, vertices[i][1] * 65536, vertices[i][2] * 65536};
    }
    return polygon;
}

void test_clip_to_the_whole_screen(void)
{
    fxl_view view = straight_view();
    fxl_polygon polygon = world_polygon(
        4,
        (const int32_t[4][3]){{-500, 500, 32}, {500, 500, 32}, {500, -500, 32}, {-500, -500, 32}});
    oracle_outline outline;
    const oracle_space space = oracle_space_of_view(&view);
    oracle_spot screen[4];
    oracle_clip(&space, &polygon, &outline);
    square(0, 0, 64 * 65536, screen);
    TEST_ASSERT_EQUAL(4, outline.count);
    expect_near(0, oracle_hausdorff(outline.spots, outline.count, screen, 4));
}

/* A floor at y = -1 from z = -50 to 50. The near plane cuts it at z = 1, on the screen's lower
 * edge; its far ends lie at z = 50. */
void test_clip_of_a_floor(void)
{
    fxl_view view = straight_view();
    fxl_polygon polygon = world_polygon(
        4, (const int32_t[4][3]){{-25, -1, 50}, {25, -1, 50}, {25, -1, -50}, {-25, -1, -50}});
    const oracle_spot exact[4] = {{16LL << 48, (32LL << 48) + ((32LL << 48) / 50)},
                                  {48LL << 48, (32LL << 48) + ((32LL << 48) / 50)},
                                  {64LL << 48, (32LL << 48) + ((32LL << 48) / 25)},
                                  {64LL << 48, 64LL << 48}};
    const oracle_spot whole[6] = {exact[0], exact[1],        exact[2],
                                  exact[3], {0, 64LL << 48}, {0, exact[2].y}};
    oracle_outline outline;
    const oracle_space space = oracle_space_of_view(&view);
    oracle_clip(&space, &polygon, &outline);
    expect_near(0, oracle_hausdorff(outline.spots, outline.count, whole, 6));
}

void test_clip_of_what_is_behind(void)
{
    fxl_view view = straight_view();
    fxl_polygon polygon =
        world_polygon(3, (const int32_t[3][3]){{-25, -1, -50}, {25, -1, -50}, {25, 9, -50}});
    oracle_outline outline;
    const oracle_space space = oracle_space_of_view(&view);
    oracle_clip(&space, &polygon, &outline);
    TEST_ASSERT_EQUAL(0, outline.count);
}

/* place fill-rule: pictures of cover.c */
void test_cover_rows_top_left(void)
{
    /* Vertices on centres: (0.5, 0.5) to (3.5, 2.5). The right and bottom edges are excluded. */
    const oracle_spot box[4] = {{32768, 32768}, {229376, 32768}, {229376, 163840}, {32768, 163840}};
    static const char *const rows[4] = {"111.", "111.", "....", "...."};
    for (int y = 0; y < 4; y++) {
        uint8_t row[4] = {0};
        oracle_cover_row(box, 4, 0, y, 4, row);
        for (int x = 0; x < 4; x++) {
            TEST_ASSERT_EQUAL(rows[y][x] == '1', row[x]);
            TEST_ASSERT_EQUAL(rows[y][x] == '1', oracle_winding(box, 4, 0, x, y) != 0);
        }
    }
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(test_hausdorff_of_squares);
    RUN_TEST(test_hausdorff_inside_an_edge);
    RUN_TEST(test_stroke);
    RUN_TEST(test_clip_to_the_whole_screen);
    RUN_TEST(test_clip_of_a_floor);
    RUN_TEST(test_clip_of_what_is_behind);
    RUN_TEST(test_cover_rows_top_left);
    return UNITY_END();
}

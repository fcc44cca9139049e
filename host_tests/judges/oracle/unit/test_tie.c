/* SPDX-License-Identifier: MIT */
/* Tests the tie test against cases known by hand, and against plain integers where depth and
 * focal length make screen coordinates integers. */
#include <stddef.h>

#include "oracle/random.h"
#include "oracle/tie.h"
#include "unity.h"

enum {
    ONE = 65536,
    ROUNDS = 20000
};

#define EIGHTH UINT32_C(0x20000000)

void setUp(void)
{
}

void tearDown(void)
{
}

/* 8 pixels wide, 90 degrees. */
static oracle_tie_view small_view(void)
{
    return (oracle_tie_view){.width = 8,
                             .height = 9,
                             .focal = 4 * ONE,
                             .near = ONE / 4,
                             .far = 1000 * ONE,
                             .centre = {4 * ONE, 9 * ONE / 2}};
}

void test_an_upright_edge_at_an_eighth_of_a_turn(void)
{
    /* X / Z = (x - z) / (x + z) = 1/8: half a pixel right of the middle. */
    const int32_t edge[3][3] = {
        {9 * ONE, -3 * ONE, 7 * ONE}, {9 * ONE, 3 * ONE, 7 * ONE}, {20 * ONE, 0, 7 * ONE}};
    oracle_tie_view view = small_view();
    view.yaw = EIGHTH;
    TEST_ASSERT_TRUE(oracle_tied(&view, edge[0], 3, 4, 4));
    TEST_ASSERT_FALSE(oracle_tied(&view, edge[0], 3, 3, 4));
    TEST_ASSERT_FALSE_MESSAGE(oracle_tied(&view, edge[0], 3, 4, 0), "above the edge's end");
    int32_t off[3][3] = {
        {9 * ONE + 1, -3 * ONE, 7 * ONE}, {9 * ONE + 1, 3 * ONE, 7 * ONE}, {20 * ONE, 0, 7 * ONE}};
    TEST_ASSERT_FALSE(oracle_tied(&view, off[0], 3, 4, 4));
    view.yaw += 1;
    TEST_ASSERT_FALSE(oracle_tied(&view, edge[0], 3, 4, 4));
}

void test_the_horizon_at_any_yaw(void)
{
    const int32_t edge[3][3] = {
        {-90 * ONE, 0, 30 * ONE}, {70 * ONE, 0, 40 * ONE}, {0, -50 * ONE, 35 * ONE}};
    oracle_tie_view view = small_view();
    view.yaw = 12345;
    for (int column = 0; column < 8; column++) {
        TEST_ASSERT_TRUE(oracle_tied(&view, edge[0], 3, column, 4));
        TEST_ASSERT_FALSE(oracle_tied(&view, edge[0], 3, column, 3));
    }
    view.pitch = 1;
    TEST_ASSERT_FALSE(oracle_tied(&view, edge[0], 3, 2, 4));
    view.pitch = 0;
    view.roll = 1;
    TEST_ASSERT_FALSE(oracle_tied(&view, edge[0], 3, 2, 4));
}

void test_nothing_behind_or_too_near_or_too_far_is_tied(void)
{
    oracle_tie_view view = small_view();
    for (int i = 0; i < 3; i++) {
        const int32_t depths[3] = {-8 * ONE, ONE / 8, 2000 * ONE};
        int32_t z = depths[i];
        const int32_t edge[3][3] = {{-90 * ONE, 0, z}, {90 * ONE, 0, z}, {0, -50 * ONE, z}};
        TEST_ASSERT_FALSE(oracle_tied(&view, edge[0], 3, 2, 4));
    }
}

/* The axes of the view, as axes of the world, for a pose of quarter turns. */
static void to_world(const oracle_tie_view *view, const int32_t v[3], int32_t world[3])
{
    static const int sines[4] = {0, 1, 0, -1};
    int y = (int)(view->yaw >> 30), p = (int)(view->pitch >> 30), r = (int)(view->roll >> 30);
    int sy = sines[y], cy = sines[(y + 1) & 3], sp = sines[p], cp = sines[(p + 1) & 3];
    int sr = sines[r], cr = sines[(r + 1) & 3];
    int rows[3][3] = {{cr * cy - sr * sp * sy, sr * cp, -cr * sy - sr * sp * cy},
                      {-sr * cy - cr * sp * sy, cr * cp, sr * sy - cr * sp * cy},
                      {cp * sy, sp, cp * cy}};
    for (int k = 0; k < 3; k++) {
        world[k] = view->eye[k] + v[0] * rows[0][k] + v[1] * rows[1][k] + v[2] * rows[2][k];
    }
}

/* At the depth of the focal length one unit of the world is one pixel. */
void test_quarter_turns_against_plain_integers(void)
{
    oracle_random random = oracle_random_start("test_tie", 1, 0);
    int tied = 0;
    for (int round = 0; round < ROUNDS; round++) {
        oracle_tie_view view = small_view();
        view.yaw = oracle_below(&random, 4) << 30;
        view.pitch = oracle_below(&random, 4) << 30;
        view.roll = oracle_below(&random, 4) << 30;
        for (int i = 0; i < 3; i++) {
            view.eye[i] = (int32_t)oracle_between(&random, -ONE, ONE);
        }
        int64_t spots[3][2]; /* in half pixels from the middle, y up */
        int32_t vertices[3][3];
        for (int i = 0; i < 3; i++) {
            spots[i][0] = oracle_between(&random, -10, 10);
            spots[i][1] = oracle_between(&random, -10, 10);
            int32_t scale = (int32_t)oracle_between(&random, 1, 4);
            int32_t v[3] = {(int32_t)spots[i][0] * scale * ONE / 2,
                            (int32_t)spots[i][1] * scale * ONE / 2, 4 * scale * ONE};
            to_world(&view, v, vertices[i]);
        }
        int column = (int)oracle_below(&random, 8), row = (int)oracle_below(&random, 9);
        int64_t x = 2 * column + 1 - 8, y = 9 - 2 * row - 1;
        bool expected = false;
        for (int i = 0; i < 3; i++) {
            const int64_t *a = spots[i], *b = spots[(i + 1) % 3];
            int64_t cross = (b[0] - a[0]) * (y - a[1]) - (b[1] - a[1]) * (x - a[0]);
            int64_t before = (x - a[0]) * (x - b[0]) + (y - a[1]) * (y - b[1]);
            bool point = a[0] == b[0] && a[1] == b[1];
            expected = expected || (!point && cross == 0 && before <= 0);
        }
        tied += expected;
        TEST_ASSERT_EQUAL(expected, oracle_tied(&view, vertices[0], 3, column, row));
    }
    TEST_ASSERT_GREATER_THAN(ROUNDS / 100, tied);
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(test_an_upright_edge_at_an_eighth_of_a_turn);
    RUN_TEST(test_the_horizon_at_any_yaw);
    RUN_TEST(test_nothing_behind_or_too_near_or_too_far_is_tied);
    RUN_TEST(test_quarter_turns_against_plain_integers);
    return UNITY_END();
}

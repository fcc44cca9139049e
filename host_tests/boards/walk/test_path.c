/* SPDX-License-Identifier: MIT */
/* Where the eye is in each frame. */
#include <string.h>

#include "path.h"

#include "fixel/player.h"
#include "scene_bytes.h"
#include "unity.h"

static const fxl_pose poses[3] = {
    {{65536, 0, 0}, 0, 0, 0}, {{131072, 5, 0}, 1, 2, 3}, {{0, -7, 65536}, 4, 5, 6}};
static const fxl_path_segment strides[2] = {{FXL_KEY_FORWARD, 2},
                                            {FXL_KEY_RIGHT | FXL_KEY_FORWARD, 1}};

static scene_bytes bytes;
static fxl_scene_image image;
static walk_path path;

void setUp(void)
{
}

void tearDown(void)
{
}

static void begin(bool with_poses, bool live)
{
    scene_bytes_make(&bytes, 1, with_poses ? poses : NULL, with_poses ? NULL : strides,
                     with_poses ? 3 : 2);
    TEST_ASSERT_EQUAL(FXL_OK, fxl_scene_open(bytes.words, bytes.size, &image, NULL));
    walk_path_begin(&path, &image, live);
}

static void assert_pose(const fxl_pose *expected)
{
    TEST_ASSERT_EQUAL_MEMORY(expected, &path.viewer.pose, sizeof *expected);
}

void test_poses_are_given_as_they_are(void)
{
    int i;

    begin(true, false);
    for (i = 0; i < 3; i++) {
        TEST_ASSERT_FALSE(walk_path_wants_keys(&path));
        TEST_ASSERT_EQUAL(FXL_OK, walk_path_next(&path, FXL_KEY_ALL));
        assert_pose(&poses[i]);
    }
}

void test_after_the_poses_the_keys_decide(void)
{
    fxl_player expected;
    int i;

    begin(true, false);
    for (i = 0; i < 3; i++) {
        TEST_ASSERT_EQUAL(FXL_OK, walk_path_next(&path, 0));
    }
    expected = path.viewer;
    TEST_ASSERT_TRUE(walk_path_wants_keys(&path));
    TEST_ASSERT_EQUAL(FXL_OK, fxl_player_step(&expected, FXL_KEY_LEFT | FXL_KEY_FORWARD,
                                              &image.motion_limits, NULL));
    TEST_ASSERT_EQUAL(FXL_OK, walk_path_next(&path, FXL_KEY_LEFT | FXL_KEY_FORWARD));
    assert_pose(&expected.pose);
    TEST_ASSERT_NOT_EQUAL(poses[2].position.z, path.viewer.pose.position.z);
}

void test_strides_walk_and_each_frame_shows_the_pose_after_its_step(void)
{
    static const uint32_t keys[3] = {FXL_KEY_FORWARD, FXL_KEY_FORWARD,
                                     FXL_KEY_FORWARD | FXL_KEY_RIGHT};
    fxl_player expected;
    int i;

    begin(false, false);
    expected = image.start;
    for (i = 0; i < 3; i++) {
        TEST_ASSERT_FALSE(walk_path_wants_keys(&path));
        TEST_ASSERT_EQUAL(FXL_OK, fxl_player_step(&expected, keys[i], &image.motion_limits, NULL));
        TEST_ASSERT_EQUAL(FXL_OK, walk_path_next(&path, FXL_KEY_BACK));
        assert_pose(&expected.pose);
    }
    TEST_ASSERT_TRUE(walk_path_wants_keys(&path));
    TEST_ASSERT_EQUAL(FXL_OK, fxl_player_step(&expected, FXL_KEY_BACK, &image.motion_limits, NULL));
    TEST_ASSERT_EQUAL(FXL_OK, walk_path_next(&path, FXL_KEY_BACK));
    assert_pose(&expected.pose);
}

void test_a_live_path_starts_with_the_keys(void)
{
    fxl_player expected;

    begin(true, true);
    expected = image.start;
    TEST_ASSERT_TRUE(walk_path_wants_keys(&path));
    TEST_ASSERT_EQUAL(FXL_OK,
                      fxl_player_step(&expected, FXL_KEY_FORWARD, &image.motion_limits, NULL));
    TEST_ASSERT_EQUAL(FXL_OK, walk_path_next(&path, FXL_KEY_FORWARD));
    assert_pose(&expected.pose);
}

void test_keys_that_do_not_exist_are_refused_and_the_viewer_stays(void)
{
    fxl_player before;

    begin(true, true);
    before = path.viewer;
    TEST_ASSERT_EQUAL(FXL_E_RANGE, walk_path_next(&path, FXL_KEY_ALL + 1u));
    TEST_ASSERT_EQUAL_MEMORY(&before.pose, &path.viewer.pose, sizeof before.pose);
}

/* SPDX-License-Identifier: MIT */
/* Turned instances and motions in a scene image: version 5, a header of 208 bytes. */
#include "expect_scene.h"

enum {
    MORE = 48, /* what the header is longer */
    AT_BEAMS = HEADER_SIZE,
    AT_CLUSTERS = HEADER_SIZE + 16,
    AT_TURNS = HEADER_SIZE + 24,
    AT_MOTIONS = HEADER_SIZE + 32,
    AT_MOTION_KEYS = HEADER_SIZE + 40,
    TURN = 40,
    MOTION = 76,
    MOTION_KEY = 32
};

/* Tiny's image with two turns and one motion. */
static tiny_image *make(void)
{
    static const fxl_turn turns[2] = {{FXL_ORIENTATION_NONE, FXL_UNITS(2)}, FXL_TURN_NONE};
    static const fxl_motion motion = {
        .yaw_step = 7, .scale_low = 65536, .scale_high = 65536, .key_count = 1};
    static const fxl_motion_key key = {.scale = 65536};
    tiny_image *image = tiny_image_widen(5, HEADER_SIZE + MORE);
    tiny_add_table(image, AT_TURNS, turns, 2, TURN);
    tiny_add_table(image, AT_MOTIONS, &motion, 1, MOTION);
    tiny_add_table(image, AT_MOTION_KEYS, &key, 1, MOTION_KEY);
    tiny_seal(image);
    return image;
}

static void turn_word(fxl_status status, uint32_t offset, uint32_t value)
{
    expect_image_word(status, make(), offset, value);
}

static void turn_half(fxl_status status, uint32_t offset, uint16_t value)
{
    expect_image_half(status, make(), offset, value);
}

static void entry_word(fxl_status status, uint32_t table, uint32_t at, uint32_t value)
{
    expect_image_entry_word(status, make(), table, at, value);
}

void test_turns_are_used_in_place(void)
{
    tiny_image *image = make();
    fxl_scene_image opened;
    TEST_ASSERT_EQUAL(FXL_OK, fxl_scene_open(image->words, image->size, &opened, NULL));
    TEST_ASSERT_EQUAL_UINT32(1, opened.scene.first_turned);
    TEST_ASSERT_EQUAL_INT32(FXL_UNITS(2), opened.scene.turns[0].scale);
    TEST_ASSERT_EQUAL_UINT32(1, opened.motion.motion_count);
    TEST_ASSERT_EQUAL_UINT32(7, opened.motion.motions[0].yaw_step);
    TEST_ASSERT_EQUAL_UINT32(1, opened.motion.key_count);
    TEST_ASSERT_EQUAL_INT32(65536, opened.motion.keys[0].scale);
    TEST_ASSERT_NULL(opened.scene.clusters);
    TEST_ASSERT_NULL(opened.scene.beams);
    image = tiny_image_make(false);
    TEST_ASSERT_EQUAL(FXL_OK, fxl_scene_open(image->words, image->size, &opened, NULL));
    TEST_ASSERT_NULL(opened.scene.turns);
    TEST_ASSERT_EQUAL_UINT32(0, opened.motion.motion_count);
}

void test_a_scene_may_have_turns_alone(void)
{
    tiny_image *image = make();
    memset(tiny_at(image, AT_MOTIONS), 0, 16);
    expect_opening(FXL_OK, image);
    /* One is that of the last instance. */
    fxl_scene_image opened;
    tiny_put32(tiny_at(image, AT_TURNS + 4), 1);
    tiny_seal(image);
    TEST_ASSERT_EQUAL(FXL_OK, fxl_scene_open(image->words, image->size, &opened, NULL));
    TEST_ASSERT_EQUAL_UINT32(TINY_INSTANCES - 1, opened.scene.first_turned);
    TEST_ASSERT_EQUAL_INT32(FXL_UNITS(2), opened.scene.turns[0].scale);
}

void test_every_instance_may_be_turned(void)
{
    static const fxl_turn turns[TINY_INSTANCES] = {FXL_TURN_NONE, FXL_TURN_NONE, FXL_TURN_NONE};
    tiny_image *image = tiny_image_widen(5, HEADER_SIZE + MORE);
    fxl_scene_image opened;
    tiny_add_table(image, AT_TURNS, turns, TINY_INSTANCES, TURN);
    tiny_seal(image);
    TEST_ASSERT_EQUAL(FXL_OK, fxl_scene_open(image->words, image->size, &opened, NULL));
    TEST_ASSERT_EQUAL_UINT32(0, opened.scene.first_turned);
}

void test_the_header_of_turns_has_its_size(void)
{
    turn_half(FXL_E_SIZE, AT_HEADER_SIZE, HEADER_SIZE);
    turn_half(FXL_E_SIZE, AT_HEADER_SIZE, HEADER_SIZE + 24);
    turn_half(FXL_E_SIZE, AT_VERSION, 4);
    turn_half(FXL_E_SIZE, AT_VERSION, 6);
    turn_half(FXL_E_VERSION, AT_VERSION, 8);
}

void test_tables_of_turns_are_checked(void)
{
    turn_word(FXL_E_COUNT, AT_TURNS + 4, 0);
    turn_word(FXL_E_COUNT, AT_TURNS + 4, 4);
    turn_word(FXL_E_COUNT, AT_TURNS + 4, 65536);
    turn_word(FXL_E_ALIGNMENT, AT_TURNS, 2);
    turn_word(FXL_E_OFFSET, AT_TURNS, 0);
    turn_word(FXL_E_COUNT, AT_MOTIONS + 4, 0);
    turn_word(FXL_E_OFFSET, AT_MOTIONS, 4);
    turn_word(FXL_E_OFFSET, AT_MOTION_KEYS, 4);
    turn_word(FXL_E_COUNT, AT_MOTION_KEYS + 4, 1000001);
    turn_word(FXL_E_COUNT, AT_BEAMS, 208);
    turn_word(FXL_E_COUNT, AT_CLUSTERS, 208);
}

void test_there_are_no_more_motions_than_turns(void)
{
    tiny_image *image = make();
    tiny_put32(tiny_at(image, AT_MOTIONS), tiny_get(image, AT_PALETTE));
    tiny_put32(tiny_at(image, AT_MOTIONS + 4), 3);
    expect_opening(FXL_E_COUNT, image);
}

void test_entries_are_checked(void)
{
    entry_word(FXL_E_TURN, AT_TURNS, 4, 5);
    entry_word(FXL_E_RANGE, AT_TURNS, 36, 0);
    entry_word(FXL_E_RESERVED, AT_MOTIONS, 72, 1);
    entry_word(FXL_E_INDEX, AT_MOTIONS, 64, 1);
    entry_word(FXL_E_RANGE, AT_MOTION_KEYS, 4, 1);
    entry_word(FXL_E_INDEX, AT_MOTION_KEYS, 0, 1);
    entry_word(FXL_OK, AT_MOTION_KEYS, 16, 0xFFFFFFFFu);
}

/* SPDX-License-Identifier: MIT */
/* Turned instances and motions in a scene image: sections of placements, of motions and of their
 * keys.
 */
#include "expect_scene.h"

enum {
    AT_PLACEMENTS = AT_MORE,
    AT_MOTIONS = AT_PLACEMENTS + SECTION_BYTES,
    AT_MOTION_KEYS = AT_MOTIONS + SECTION_BYTES,
    PLACEMENT = 40,
    MOTION = 76,
    MOTION_KEY = 32
};

/* Tiny's image with two placements and one motion. */
static tiny_image *make(void)
{
    static const fxl_placement placements[2] = {{FXL_ORIENTATION_NONE, FXL_UNITS(2)},
                                                FXL_PLACEMENT_NONE};
    static const fxl_motion motion = {
        .yaw_step = 7, .scale_low = 65536, .scale_high = 65536, .key_count = 1};
    static const fxl_motion_key key = {.scale = 65536};
    tiny_image *image = tiny_image_make(false);
    tiny_set_section(image, SECTION_PLACEMENTS, placements, 2, PLACEMENT);
    tiny_set_section(image, SECTION_MOTIONS, &motion, 1, MOTION);
    tiny_set_section(image, SECTION_KEYS_OF_MOTIONS, &key, 1, MOTION_KEY);
    tiny_seal(image);
    return image;
}

static void placement_word(fxl_status status, uint32_t offset, uint32_t value)
{
    expect_image_word(status, make(), offset, value);
}

static void entry_word(fxl_status status, uint32_t table, uint32_t at, uint32_t value)
{
    expect_image_entry_word(status, make(), table, at, value);
}

/* formats 1.2w-y */
void test_placements_are_used_in_place(void)
{
    tiny_image *image = make();
    fxl_scene_image opened;
    TEST_ASSERT_EQUAL(FXL_OK, fxl_scene_open(image->words, image->size, &opened, NULL));
    TEST_ASSERT_EQUAL_UINT32(1, opened.scene.first_turned);
    TEST_ASSERT_EQUAL_INT32(FXL_UNITS(2), opened.scene.placements[0].scale);
    TEST_ASSERT_EQUAL_UINT32(1, opened.motion.motion_count);
    TEST_ASSERT_EQUAL_UINT32(7, opened.motion.motions[0].yaw_step);
    TEST_ASSERT_EQUAL_UINT32(1, opened.motion.key_count);
    TEST_ASSERT_EQUAL_INT32(65536, opened.motion.keys[0].scale);
    TEST_ASSERT_NULL(opened.scene.clusters);
    TEST_ASSERT_NULL(opened.scene.beams);
    image = tiny_image_make(false);
    TEST_ASSERT_EQUAL(FXL_OK, fxl_scene_open(image->words, image->size, &opened, NULL));
    TEST_ASSERT_NULL(opened.scene.placements);
    TEST_ASSERT_EQUAL_UINT32(0, opened.motion.motion_count);
}

/* formats 1.9a */
void test_a_scene_may_have_placements_alone(void)
{
    tiny_image *image = make();
    static const fxl_placement one = {FXL_ORIENTATION_NONE, FXL_UNITS(2)};
    tiny_set_section(image, SECTION_MOTIONS, NULL, 0, 0);
    tiny_set_section(image, SECTION_KEYS_OF_MOTIONS, NULL, 0, 0);
    expect_opening(FXL_OK, image);
    /* One is that of the last instance. */
    fxl_scene_image opened;
    tiny_set_section(image, SECTION_PLACEMENTS, &one, 1, PLACEMENT);
    tiny_seal(image);
    TEST_ASSERT_EQUAL(FXL_OK, fxl_scene_open(image->words, image->size, &opened, NULL));
    TEST_ASSERT_EQUAL_UINT32(TINY_INSTANCES - 1, opened.scene.first_turned);
    TEST_ASSERT_EQUAL_INT32(FXL_UNITS(2), opened.scene.placements[0].scale);
}

void test_every_instance_may_be_turned(void)
{
    static const fxl_placement placements[TINY_INSTANCES] = {FXL_PLACEMENT_NONE, FXL_PLACEMENT_NONE,
                                                             FXL_PLACEMENT_NONE};
    tiny_image *image = tiny_image_make(false);
    fxl_scene_image opened;
    tiny_set_section(image, SECTION_PLACEMENTS, placements, TINY_INSTANCES, PLACEMENT);
    tiny_seal(image);
    TEST_ASSERT_EQUAL(FXL_OK, fxl_scene_open(image->words, image->size, &opened, NULL));
    TEST_ASSERT_EQUAL_UINT32(0, opened.scene.first_turned);
}

/* formats 1.2au */
void test_motions_their_keys_and_placements_go_together(void)
{
    static const uint16_t kinds[] = {SECTION_PLACEMENTS, SECTION_MOTIONS, SECTION_KEYS_OF_MOTIONS};
    for (int i = 0; i < 3; i++) {
        tiny_image *image = make();
        tiny_set_section(image, kinds[i], NULL, 0, 0);
        expect_opening(FXL_E_COUNT, image);
    }
}

/* formats 1.9, 1.2w-y */
void test_tables_of_placements_are_checked(void)
{
    placement_word(FXL_E_COUNT, AT_PLACEMENTS + 4, 0);
    placement_word(FXL_E_OFFSET, AT_PLACEMENTS + 4, 4);
    placement_word(FXL_E_COUNT, AT_PLACEMENTS + 4, 65536);
    placement_word(FXL_E_ALIGNMENT, AT_PLACEMENTS, 2);
    placement_word(FXL_E_OFFSET, AT_PLACEMENTS, 0);
    placement_word(FXL_E_COUNT, AT_MOTIONS + 4, 0);
    placement_word(FXL_E_OFFSET, AT_MOTIONS, 4);
    placement_word(FXL_E_OFFSET, AT_MOTION_KEYS, 4);
    placement_word(FXL_E_COUNT, AT_MOTION_KEYS + 4, 1000001);
}

/* formats 1.2aw */
void test_there_are_no_more_motions_than_placements(void)
{
    tiny_image *image = make();
    static const fxl_motion motions[3];
    tiny_set_section(image, SECTION_MOTIONS, motions, 3, MOTION);
    expect_opening(FXL_E_COUNT, image);
    image = make();
    static const fxl_placement placements[TINY_INSTANCES + 1];
    tiny_set_section(image, SECTION_PLACEMENTS, placements, TINY_INSTANCES + 1,
                     PLACEMENT); /* nor more placements */
    expect_opening(FXL_E_COUNT, image);
}

/* At the end of the world a small instance is within it, though its vertices would not be if they
 * were not placed. */
/* formats 1.9c */
void test_vertices_that_are_placed_are_not_checked_one_by_one(void)
{
    tiny_image *image = make();
    tiny_put32(tiny_entry(image, AT_PLACEMENTS, 0, PLACEMENT) + 36, FXL_SCALE_MIN);
    tiny_put32(tiny_entry(image, AT_INSTANCES, 1, INSTANCE),
               (uint32_t)(FXL_COORDINATE_MAX - FXL_PLACEMENT_SLACK - TINY_RADIUS / 256 - 1));
    expect_opening(FXL_OK, image);
    image = make();
    tiny_put32(tiny_entry(image, AT_INSTANCES, 0, INSTANCE), (uint32_t)FXL_COORDINATE_MAX - 65535);
    expect_opening(FXL_E_RANGE, image); /* it has no placement */
}

/* formats 1.9b */
void test_entries_are_checked(void)
{
    entry_word(FXL_E_PLACEMENT, AT_PLACEMENTS, 4, 5);
    entry_word(FXL_E_RANGE, AT_PLACEMENTS, 36, 0);
    entry_word(FXL_E_RESERVED, AT_MOTIONS, 72, 1);
    entry_word(FXL_E_INDEX, AT_MOTIONS, 64, 1);
    entry_word(FXL_E_RANGE, AT_MOTION_KEYS, 4, 1);
    entry_word(FXL_E_INDEX, AT_MOTION_KEYS, 0, 1);
    entry_word(FXL_OK, AT_MOTION_KEYS, 16, 0xFFFFFFFFu);
    /* Instance 1 has a scale of 2: its sphere reaches to the end of the world, and a unit beyond.
     */
    const uint32_t inner = (uint32_t)(FXL_COORDINATE_MAX - FXL_PLACEMENT_SLACK - 2 * TINY_RADIUS);
    entry_word(FXL_OK, AT_INSTANCES, 16, inner);
    entry_word(FXL_E_RANGE, AT_INSTANCES, 16, inner + 1);
}

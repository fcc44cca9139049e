/* SPDX-License-Identifier: MIT */
/* The checks of placements and of motions, each boundary from both sides. */
#include "tiny.h"

enum {
    MOTIONS = 3,
    KEYS = 4
};

static fxl_motion motions[MOTIONS];
static fxl_motion_key keys[KEYS];
static fxl_placement placements[TINY_INSTANCES];
static fxl_motion_set set;
static fxl_scene scene;

static const fxl_placement still = FXL_PLACEMENT_NONE;

/* Every instance of tiny's scene has a placement, a motion and a key; the last has two keys. */
static void make(void)
{
    scene = tiny_make()->scene;
    scene.placements = placements;
    scene.first_turned = 0;
    for (uint32_t i = 0; i < MOTIONS; i++) {
        placements[i] = still;
        motions[i] = (fxl_motion){.extent = {FXL_UNITS(9), FXL_UNITS(9), FXL_UNITS(9)},
                                  .scale_low = 32768,
                                  .scale_high = FXL_UNITS(2),
                                  .first_key = i,
                                  .key_count = 1 + i / 2};
    }
    for (uint32_t i = 0; i < KEYS; i++) {
        keys[i] = (fxl_motion_key){.frame = i / 3 * 5, .scale = FXL_Q16_16_ONE};
    }
    set = (fxl_motion_set){motions, MOTIONS, keys, KEYS};
}

static void expect_scene(fxl_status status, const char *what, uint32_t index)
{
    fxl_scene_fault fault = {"-", 99};
    TEST_ASSERT_EQUAL_STRING(fxl_status_text(status),
                             fxl_status_text(fxl_scene_check_all(&scene, &fault)));
    TEST_ASSERT_EQUAL_STRING(what, fault.what);
    TEST_ASSERT_EQUAL_UINT32(index, fault.index);
}

static void expect(fxl_status status, const char *what, uint32_t index)
{
    fxl_scene_fault fault = {"-", 99};
    TEST_ASSERT_EQUAL_STRING(fxl_status_text(status),
                             fxl_status_text(fxl_motion_check(&set, &scene, &fault)));
    TEST_ASSERT_EQUAL_STRING(status == FXL_OK ? "-" : what, fault.what);
    TEST_ASSERT_EQUAL_UINT32(status == FXL_OK ? 99 : index, fault.index);
    make();
}

/* The member of a motion or a key, a value, and the status that names the motion or the key. */
#define MOTION(number, member, value, status) \
    UNIT_FIELD(motions[number].member, value), status, "motion", number
#define KEY(number, member, value, status) \
    UNIT_FIELD(keys[number].member, value), status, "motion key", number

static void expect_fine(void)
{
    expect(FXL_OK, NULL, 0);
}

void test_a_scene_with_placements_is_fine(void)
{
    make();
    expect_scene(FXL_OK, "-", 99);
    expect_fine();
    set.motion_count = set.key_count = 0;
    set.motions = NULL;
    set.keys = NULL;
    expect_fine();
    set.motion_count = set.key_count = 0;
    set.keys = NULL; /* none of each, and a table of motions */
    expect_fine();
}

void test_missing_tables_are_refused(void)
{
    fxl_scene_fault fault;
    make();
    TEST_ASSERT_EQUAL(FXL_E_ARGUMENT, fxl_scene_check_all(NULL, &fault));
    TEST_ASSERT_EQUAL(FXL_E_ARGUMENT, fxl_motion_check(NULL, &scene, &fault));
    TEST_ASSERT_EQUAL(FXL_E_ARGUMENT, fxl_motion_check(&set, NULL, &fault));
    set.motions = NULL;
    expect(FXL_E_ARGUMENT, "motion table", 0);
    set.keys = NULL;
    expect(FXL_E_ARGUMENT, "motion table", 0);
    set.motions = NULL; /* a single one */
    set.motion_count = 1;
    expect(FXL_E_ARGUMENT, "motion table", 0);
    set.keys = NULL;
    set.key_count = 1;
    expect(FXL_E_ARGUMENT, "motion table", 0);
    set.keys = NULL;
    set.key_count = 0; /* so that the first motion's key is none of them */
    expect(FXL_E_INDEX, "motion", 0);
    set.motions = (const fxl_motion *)((uintptr_t)motions + 1);
    expect(FXL_E_ALIGNMENT, "motion table", 0);
    set.keys = (const fxl_motion_key *)((uintptr_t)keys + 2);
    expect(FXL_E_ALIGNMENT, "motion table", 0);
    scene.first_turned = 1;
    expect(FXL_E_COUNT, "motion table", 0);
    scene.first_turned = TINY_INSTANCES + 1;
    expect_scene(FXL_E_INDEX, "placement table", 0);
    scene.placements = NULL;
    expect(FXL_E_COUNT, "motion table", 0);
}

/* formats 1.10b */
void test_motions_take_the_keys_in_turn(void)
{
    make();
    const unit_field fields[] = {
        {MOTION(1, first_key, 2, FXL_E_INDEX)},
        {MOTION(1, key_count, 0, FXL_E_INDEX)},
        {MOTION(2, key_count, 3, FXL_E_INDEX)},
        {UNIT_FIELD(motions[2].key_count, 1), FXL_E_COUNT, "motion key table", 0},
    };
    unit_expect_fields(fields, sizeof fields / sizeof fields[0], expect);
}

/* formats 1.10f, motion 2.1b */
void test_keys_are_in_order(void)
{
    make();
    const unit_field fields[] = {
        {KEY(0, frame, 1, FXL_E_INDEX)},
        {KEY(3, frame, 0, FXL_E_INDEX)},
        {KEY(3, frame, 1000000, FXL_OK)},
        {KEY(3, frame, 1000001, FXL_E_INDEX)},
    };
    unit_expect_fields(fields, sizeof fields / sizeof fields[0], expect);
}

/* formats 1.10d */
void test_reserved_fields_are_checked(void)
{
    make();
    const unit_field fields[] = {
        {MOTION(1, reserved, 1, FXL_E_RESERVED)},
        {MOTION(1, repeats, 1, FXL_OK)},
        {MOTION(1, repeats, 2, FXL_E_RESERVED)},
        {MOTION(1, parent, 1, FXL_OK)},
        {MOTION(1, parent, 2, FXL_E_RESERVED)}, /* itself */
    };
    unit_expect_fields(fields, sizeof fields / sizeof fields[0], expect);
}

/* motion 4.1a-b, formats 1.10g */
void test_a_key_is_within_the_extent(void)
{
    make();
    keys[3].centre = (fxl_point){FXL_UNITS(9), -FXL_UNITS(9), FXL_UNITS(9)};
    expect_fine();
    const unit_field fields[] = {
        {KEY(3, centre.x, FXL_UNITS(9) + 1, FXL_E_RANGE)},
        {KEY(3, centre.y, -FXL_UNITS(9) - 1, FXL_E_RANGE)},
        {KEY(2, centre.z, INT32_MIN, FXL_E_RANGE)},
        {KEY(2, scale, 32767, FXL_E_RANGE)},
        {KEY(2, scale, FXL_UNITS(2), FXL_OK)},
        {KEY(2, scale, FXL_UNITS(2) + 1, FXL_E_RANGE)},
    };
    unit_expect_fields(fields, sizeof fields / sizeof fields[0], expect);
}

/* formats 1.10e */
void test_numbers_of_a_motion_are_in_range(void)
{
    make();
    const unit_field fields[] = {
        {MOTION(0, radius, -1, FXL_E_RANGE)},
        {MOTION(0, extent.x, -1, FXL_E_RANGE)},
        {MOTION(0, extent.y, -1, FXL_E_RANGE)},
        {MOTION(0, extent.z, INT32_MIN, FXL_E_RANGE)},
        {MOTION(0, extent.y, 1 << 30, FXL_E_RANGE)},
        {MOTION(0, extent.z, 1 << 30, FXL_E_RANGE)},
        {MOTION(0, radius, INT32_MAX, FXL_E_RANGE)},
        {MOTION(0, axis.x, (1 << 30) - 1, FXL_OK)},
        {MOTION(0, axis.y, 1 << 30, FXL_E_RANGE)},
        {MOTION(0, axis.z, INT32_MIN, FXL_E_RANGE)},
        {MOTION(0, scale_low, FXL_SCALE_MIN - 1, FXL_E_RANGE)},
        {MOTION(0, scale_high, FXL_SCALE_MAX + 1, FXL_E_RANGE)},
    };
    unit_expect_fields(fields, sizeof fields / sizeof fields[0], expect);
}

/* A motion without a parent reaches its extent, its circle, its sphere and the slack. */
/* motion 4.2d-f */
void test_no_frame_leaves_the_world(void)
{
    const fxl_q16_16 room = FXL_COORDINATE_MAX - 2 * TINY_RADIUS - FXL_PLACEMENT_SLACK;
    make();
    const unit_field fields[] = {
        {MOTION(0, extent.y, room, FXL_OK)},
        {MOTION(0, extent.y, room + 1, FXL_E_RANGE)},
        {MOTION(0, radius, room - FXL_UNITS(9), FXL_OK)},
        {MOTION(0, radius, room - FXL_UNITS(9) + 1, FXL_E_RANGE)},
    };
    unit_expect_fields(fields, sizeof fields / sizeof fields[0], expect);
}

/* A circle adds to x and to z, each by itself, and not to y. */
/* motion 4.2b */
void test_the_circle_of_a_motion_reaches_along_x_and_z(void)
{
    const fxl_q16_16 room = FXL_COORDINATE_MAX - 2 * TINY_RADIUS - FXL_PLACEMENT_SLACK;
    make();
    fxl_q16_16 *const extents[] = {&motions[0].extent.x, &motions[0].extent.y,
                                   &motions[0].extent.z};
    for (int axis = 0; axis < 3; axis++) {
        make();
        motions[0].radius = FXL_UNITS(30);
        *extents[axis] = room - (axis == 1 ? 0 : FXL_UNITS(30));
        expect_fine();
        motions[0].radius = FXL_UNITS(30);
        *extents[axis] = room - (axis == 1 ? 0 : FXL_UNITS(30)) + 1;
        expect(FXL_E_RANGE, "motion", 0);
    }
}

/* With a parent the places add up, times the parent's scale. */
/* motion 4.2c-e, formats 1.10h */
void test_a_chain_stays_in_the_world(void)
{
    make();
    motions[0].extent = (fxl_point){0, 0, 0};
    motions[0].scale_high = FXL_UNITS(2);
    motions[1].parent = 1;
    motions[1].extent = (fxl_point){FXL_UNITS(300), FXL_UNITS(400), FXL_UNITS(1200)};
    motions[1].scale_high = FXL_Q16_16_ONE;
    /* 2 * (1300 + 1/65536), and 2 * radius, each with the slack */
    const fxl_q16_16 room =
        FXL_COORDINATE_MAX - FXL_UNITS(2600) - 2 - 2 * FXL_PLACEMENT_SLACK - 2 * TINY_RADIUS;
    motions[0].extent.z = room;
    const fxl_motion first = motions[0], second = motions[1];
    expect_fine();
    motions[0] = first;
    motions[1] = second;
    motions[0].extent.z = room + 1;
    expect(FXL_E_RANGE, "motion", 1);
}

/* motion 4.3 */
void test_the_scales_of_a_chain_are_in_range(void)
{
    make();
    motions[1].parent = 1;
    motions[0].scale_high = FXL_UNITS(16);
    motions[1].scale_high = FXL_UNITS(16);
    expect_fine();
    motions[1].parent = 1;
    motions[0].scale_high = FXL_UNITS(16);
    motions[1].scale_high = FXL_UNITS(16) + 16;
    expect(FXL_E_RANGE, "motion", 1);
    motions[1].parent = 1;
    motions[0].scale_low = 4096;
    motions[1].scale_low = 4096;
    expect_fine();
    motions[1].parent = 1;
    motions[0].scale_low = 4096;
    motions[1].scale_low = 4080;
    expect(FXL_E_RANGE, "motion", 1);
}

/* Eight parents are allowed, nine are not: a scene of ten instances of one model. */
/* formats 1.10d, motion 2.5d */
void test_a_chain_has_at_most_eight_parents(void)
{
    static fxl_instance many[10];
    static fxl_placement many_placements[10];
    static fxl_motion many_motions[10];
    static fxl_motion_key many_keys[10];
    make();
    for (uint32_t i = 0; i < 10; i++) {
        many[i] = scene.instances[0];
        many_placements[i] = still;
        many_motions[i] = (fxl_motion){.scale_low = FXL_Q16_16_ONE,
                                       .scale_high = FXL_Q16_16_ONE,
                                       .first_key = i,
                                       .key_count = 1,
                                       .parent = (uint16_t)i};
        many_keys[i] = (fxl_motion_key){.scale = FXL_Q16_16_ONE};
    }
    scene.instances = many;
    scene.placements = many_placements;
    scene.instance_count = 9;
    set = (fxl_motion_set){many_motions, 9, many_keys, 9};
    fxl_scene_fault fault = {"-", 99};
    TEST_ASSERT_EQUAL(FXL_OK, fxl_motion_check(&set, &scene, &fault));
    scene.instance_count = 10;
    set = (fxl_motion_set){many_motions, 10, many_keys, 10};
    expect(FXL_E_COUNT, "motion", 9);
}

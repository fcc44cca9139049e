/* SPDX-License-Identifier: MIT */
/* The player of motions, against long double. */
#include <math.h>

#include "exact_placement.h"
#include "unit.h"
#include "tiny.h"

enum {
    MOTIONS = 2,
    KEYS = 4,
    FRAMES = 40
};

static fxl_motion motions[MOTIONS];
static fxl_motion_key keys[KEYS];
static fxl_instance instances[TINY_INSTANCES];
static fxl_placement placements[MOTIONS];
static const fxl_placement still[MOTIONS] = {FXL_PLACEMENT_NONE, FXL_PLACEMENT_NONE};
static const fxl_motion_memory memory = {instances, TINY_INSTANCES, placements, MOTIONS};

/* Two motions of a key each: that of instance 1, and that of instance 2. */
static fxl_motion_set make(void)
{
    for (uint32_t i = 0; i < MOTIONS; i++) {
        motions[i] = (fxl_motion){.scale_low = FXL_Q16_16_ONE,
                                  .scale_high = FXL_Q16_16_ONE,
                                  .first_key = i,
                                  .key_count = 1};
    }
    for (uint32_t i = 0; i < KEYS; i++) {
        keys[i] = (fxl_motion_key){.scale = FXL_Q16_16_ONE};
    }
    return (fxl_motion_set){motions, MOTIONS, keys, MOTIONS};
}

/* One motion, of instance 2, with so many keys. */
static fxl_motion_set make_track(uint32_t count)
{
    fxl_motion_set set = make();
    motions[0].key_count = count;
    set.motion_count = 1;
    set.key_count = count;
    return set;
}

static fxl_motion_player begin(const fxl_motion_set *set, fxl_scene *scene)
{
    static fxl_motion_player player;
    *scene = tiny_make()->scene;
    scene->placements = still;
    scene->first_turned = 1;
    /* Extents are not the player's; what the loader checks is what these tests play. */
    for (uint32_t i = 0; i < set->motion_count; i++) {
        motions[i].extent = (fxl_point){FXL_UNITS(100), FXL_UNITS(100), FXL_UNITS(100)};
        motions[i].scale_low = 32768;
        motions[i].scale_high = FXL_UNITS(4);
    }
    TEST_ASSERT_EQUAL(FXL_OK, fxl_scene_check_all(scene, NULL));
    TEST_ASSERT_EQUAL(FXL_OK, fxl_motion_check(set, scene, NULL));
    TEST_ASSERT_EQUAL(FXL_OK, fxl_motion_begin(&player, set, scene, &memory));
    return player;
}

/* motion 1.1, 1.3a */
void test_the_scene_draws_from_the_copies(void)
{
    fxl_motion_set set = make_track(1);
    fxl_scene scene;
    keys[0].centre.x = FXL_UNITS(7);
    begin(&set, &scene);
    TEST_ASSERT_EQUAL_PTR(instances, scene.instances);
    TEST_ASSERT_EQUAL_PTR(placements, scene.placements);
    const tiny_scene *tiny = tiny_make();
    TEST_ASSERT_EQUAL_MEMORY(tiny->instances, instances, 2 * sizeof instances[0]);
    TEST_ASSERT_EQUAL_MEMORY(still, placements, sizeof placements);
    TEST_ASSERT_EQUAL_INT32(FXL_UNITS(7), instances[2].centre.x);
    TEST_ASSERT_EQUAL_INT32(0, instances[2].centre.z);
    TEST_ASSERT_EQUAL(tiny->instances[2].model, instances[2].model);
}

static int32_t rounded_between(int32_t a, int32_t b, uint32_t part, uint32_t whole)
{
    return (int32_t)floorl(a + ((long double)b - a) * part / whole + 0.5L);
}

/* A straight line from key to key, with halves upward; the last key holds. */
/* accuracy 1.2j, motion 2.1c, 2.2a */
void test_places_go_straight_from_key_to_key(void)
{
    fxl_motion_set set = make_track(3);
    fxl_scene scene;
    for (uint32_t i = 0; i < 3; i++) {
        keys[i].centre = unit_point(FXL_UNITS(90));
        keys[i].scale = unit_between(32768, FXL_UNITS(4));
    }
    keys[1].frame = 7;
    keys[2].frame = 20;
    fxl_motion_player player = begin(&set, &scene);
    for (uint32_t frame = 0; frame < FRAMES; frame++) {
        const uint32_t i = frame < 7 ? 0 : 1;
        const uint32_t part = frame < 20 ? frame - keys[i].frame : 13, whole = i ? 13 : 7;
        fxl_motion_play(&player, frame);
        const fxl_point *at = &instances[2].centre;
        TEST_ASSERT_EQUAL_INT32(
            rounded_between(keys[i].centre.x, keys[i + 1].centre.x, part, whole), at->x);
        TEST_ASSERT_EQUAL_INT32(
            rounded_between(keys[i].centre.y, keys[i + 1].centre.y, part, whole), at->y);
        TEST_ASSERT_EQUAL_INT32(
            rounded_between(keys[i].centre.z, keys[i + 1].centre.z, part, whole), at->z);
        TEST_ASSERT_EQUAL_INT32(rounded_between(keys[i].scale, keys[i + 1].scale, part, whole),
                                placements[1].scale);
    }
}

/* motion 2.2b */
void test_a_track_repeats(void)
{
    fxl_motion_set set = make_track(2);
    fxl_scene scene;
    keys[1].frame = 8;
    keys[1].centre.y = FXL_UNITS(4);
    motions[0].repeats = 1;
    fxl_motion_player player = begin(&set, &scene);
    for (uint32_t frame = 0; frame < FRAMES; frame++) {
        fxl_motion_play(&player, frame);
        TEST_ASSERT_EQUAL_INT32((int32_t)(frame % 8) * 32768, instances[2].centre.y);
    }
    fxl_motion_play(&player, 0xFFFFFFFFu);
    TEST_ASSERT_EQUAL_INT32(7 * 32768, instances[2].centre.y);
}

static void expect_orientation(fxl_angle yaw, const fxl_orientation *orientation)
{
    fxl_orientation wanted;
    TEST_ASSERT_EQUAL(FXL_OK, fxl_orientation_from_angles(yaw, 0, 0, &wanted));
    TEST_ASSERT_EQUAL_MEMORY(&wanted, orientation, sizeof wanted);
}

/* motion 1.2c, 2.2d */
void test_steps_spins_and_circles_go_on_where_a_track_repeats(void)
{
    const fxl_angle step = 1u << 26; /* 64 frames a turn */
    fxl_motion_set set = make_track(2);
    fxl_scene scene;
    keys[1].frame = 8;
    motions[0].repeats = 1;
    motions[0].yaw_step = step;
    fxl_motion_player player = begin(&set, &scene);
    for (uint32_t frame = 0; frame < FRAMES; frame++) {
        fxl_motion_play(&player, frame);
        expect_orientation(frame * step, &placements[1].orientation);
    }
    motions[0].yaw_step = 0;
    motions[0].axis.y = 1;
    motions[0].spin_step = step;
    motions[0].radius = FXL_UNITS(2);
    motions[0].circle_step = step;
    player = begin(&set, &scene);
    fxl_motion_play(&player, 16); /* a quarter of a turn: 16 mod 8 would be none */
    TEST_ASSERT_EQUAL_INT32(FXL_UNITS(2), instances[2].centre.x);
    TEST_ASSERT_EQUAL_INT32(0, instances[2].centre.z);
    TEST_ASSERT_EQUAL_INT32(0, placements[1].orientation.x.x);
}

/* From 350 degrees to 20 it is 30 onward, not 330 back. */
/* motion 2.1d */
void test_angles_take_the_short_way(void)
{
    fxl_motion_set set = make_track(2);
    fxl_scene scene;
    keys[0].yaw = FXL_DEGREES(350);
    keys[1].frame = 2;
    keys[1].yaw = FXL_DEGREES(20);
    fxl_motion_player player = begin(&set, &scene);
    fxl_motion_play(&player, 1);
    const exact_placement wanted = exact_angles(FXL_DEGREES(5), 0, 0);
    TEST_ASSERT_NEAR(exact_distance(&wanted, &placements[1].orientation), 0, 8);
}

/* motion 2.3, accuracy 1.2j */
void test_a_circle_is_round(void)
{
    fxl_motion_set set = make_track(1);
    fxl_scene scene;
    keys[0].centre = (fxl_point){Q16(3), Q16(1), Q16(-2)};
    motions[0].radius = FXL_UNITS(50);
    motions[0].circle = FXL_DEGREES(30);
    motions[0].circle_step = 0x0ABCDEF1u;
    fxl_motion_player player = begin(&set, &scene);
    for (uint32_t frame = 0; frame < FRAMES; frame++) {
        const fxl_angle angle = FXL_DEGREES(30) + frame * 0x0ABCDEF1u;
        const long double turn = angle * EXACT_PI / 2147483648.0L;
        fxl_motion_play(&player, frame);
        TEST_ASSERT_NEAR(Q16(3) + FXL_UNITS(50) * sinl(turn), instances[2].centre.x, 0.51);
        TEST_ASSERT_EQUAL_INT32(Q16(1), instances[2].centre.y);
        TEST_ASSERT_NEAR(Q16(-2) + FXL_UNITS(50) * cosl(turn), instances[2].centre.z, 0.51);
    }
}

/* The spin turns first, about an axis of the model; then the angles turn. */
/* motion 2.4a-d */
void test_it_spins_and_then_turns(void)
{
    const fxl_point axis = {1, 2, 2};
    for (int kind = 0; kind < 3; kind++) {
        fxl_motion_set set = make_track(1);
        fxl_scene scene;
        keys[0].pitch = kind != 1 ? FXL_DEGREES(25) : 0;
        motions[0].yaw_step = kind != 1 ? FXL_DEGREES(3) : 0;
        motions[0].roll_step = kind != 1 ? FXL_DEGREES(-5) : 0;
        motions[0].axis = kind != 0 ? axis : (fxl_point){0, 0, 0};
        motions[0].spin = FXL_DEGREES(10);
        motions[0].spin_step = FXL_DEGREES(17);
        fxl_motion_player player = begin(&set, &scene);
        for (uint32_t frame = 0; frame < FRAMES; frame++) {
            const exact_placement angles = exact_angles(frame * motions[0].yaw_step, keys[0].pitch,
                                                        frame * motions[0].roll_step);
            const exact_placement spin =
                exact_axis(axis, kind != 0 ? FXL_DEGREES(10) + frame * FXL_DEGREES(17) : 0);
            const exact_placement wanted = exact_product(&angles, &spin);
            fxl_motion_play(&player, frame);
            TEST_ASSERT_NEAR(exact_distance(&wanted, &placements[1].orientation), 0, 15);
        }
    }
}

/* A wheel on a car that drives a circle: as fxl_placement_attach places it, in that frame. */
/* motion 2.4d, 2.5a, 2.5c */
void test_a_child_follows_its_parent(void)
{
    fxl_motion_set set = make();
    fxl_scene scene;
    motions[0].radius = FXL_UNITS(9);
    motions[0].circle_step = motions[0].yaw_step = FXL_DEGREES(4);
    keys[0].scale = FXL_UNITS(2);
    motions[1].parent = 1;
    motions[1].axis.x = 1;
    motions[1].spin_step = FXL_DEGREES(31);
    keys[1].centre = (fxl_point){Q16(1.5), Q16(0.25), Q16(-2)};
    fxl_motion_player player = begin(&set, &scene);
    for (uint32_t frame = 0; frame < FRAMES; frame++) {
        fxl_placement wheel, wanted;
        fxl_point centre;
        fxl_motion_play(&player, FRAMES - frame);
        fxl_motion_play(&player, frame); /* a frame depends on its number alone */
        wheel.scale = FXL_Q16_16_ONE;
        fxl_orientation_from_axis(&motions[1].axis, frame * FXL_DEGREES(31), &wheel.orientation);
        TEST_ASSERT_EQUAL(FXL_OK, fxl_placement_attach(&instances[1].centre, &placements[0],
                                                       &keys[1].centre, &wheel, &centre, &wanted));
        TEST_ASSERT_EQUAL_MEMORY(&centre, &instances[2].centre, sizeof centre);
        TEST_ASSERT_EQUAL_MEMORY(&wanted, &placements[1], sizeof wanted);
        TEST_ASSERT_EQUAL_INT32(FXL_UNITS(2), placements[1].scale);
    }
}

static fxl_motion_set make_lively(void)
{
    fxl_motion_set set = make();
    motions[0].radius = FXL_UNITS(9);
    motions[0].circle_step = motions[0].yaw_step = 0x01234567u;
    motions[0].roll_step = 0x00777777u;
    motions[0].key_count = 3;
    motions[0].repeats = 1;
    keys[0].pitch = 0x0F0F0F0Fu;
    keys[1] = (fxl_motion_key){7, {Q16(1.3), Q16(2.7), Q16(3.1)}, 1u << 30, 5, 9, 99999};
    keys[2] = (fxl_motion_key){19, {Q16(-3.3), Q16(0.7), Q16(1)}, 3u << 29, 1u << 31, 9, 77777};
    motions[1].first_key = 3;
    motions[1].parent = 1;
    motions[1].axis = (fxl_point){1, -2, 3};
    motions[1].spin_step = 0x13579BDFu;
    keys[3].centre = (fxl_point){Q16(1.5), Q16(0.25), Q16(-2)};
    set.key_count = 4;
    return set;
}

/* motion 1.2a-b */
void test_every_board_plays_the_same_frames(void)
{
    fxl_motion_set set = make_lively();
    fxl_scene scene;
    uint32_t crc = 0;
    fxl_motion_player player = begin(&set, &scene);
    for (uint32_t frame = 0; frame < FRAMES; frame++) {
        fxl_motion_play(&player, frame);
        crc = (crc << 1 | crc >> 31) ^ unit_crc32((const uint8_t *)instances, sizeof instances) ^
              unit_crc32((const uint8_t *)placements, sizeof placements);
    }
    TEST_ASSERT_EQUAL_HEX32(0xD4E2AE23u, crc);
}

/* motion 1.2b */
void test_frames_are_the_same_in_any_order(void)
{
    static uint32_t forward[FRAMES];
    fxl_motion_set set = make_lively();
    for (set.motion_count = 1; set.motion_count <= 2; set.motion_count++) {
        fxl_scene scene;
        set.key_count = 2 + set.motion_count;
        fxl_motion_player player = begin(&set, &scene);
        for (uint32_t i = 0; i < 2 * FRAMES; i++) {
            const uint32_t frame = i < FRAMES ? i : 2 * FRAMES - 1 - i;
            fxl_motion_play(&player, frame);
            const uint32_t crc = unit_crc32((const uint8_t *)instances, sizeof instances) ^
                                 unit_crc32((const uint8_t *)placements, sizeof placements);
            if (i < FRAMES) {
                forward[frame] = crc;
            }
            TEST_ASSERT_EQUAL_HEX32(forward[frame], crc);
        }
    }
}

static void refuse(fxl_status status, const fxl_motion_set *set, const fxl_scene *scene,
                   const fxl_motion_memory *room)
{
    fxl_motion_player player, before;
    fxl_scene given = *scene;
    memset(&player, 0x5A, sizeof player);
    before = player;
    memset(instances, 0x77, sizeof instances);
    TEST_ASSERT_EQUAL(status, fxl_motion_begin(&player, set, &given, room));
    TEST_ASSERT_EQUAL_MEMORY(&before, &player, sizeof player);
    TEST_ASSERT_EQUAL_PTR(scene->instances, given.instances);
    TEST_ASSERT_EQUAL_PTR(scene->placements, given.placements);
    TEST_ASSERT_EQUAL_HEX8(0x77, instances[0].layer);
}

void test_what_cannot_be_played_is_refused(void)
{
    fxl_motion_set set = make();
    fxl_scene scene = tiny_make()->scene;
    fxl_motion_player player;
    fxl_motion_memory room = memory;
    refuse(FXL_E_ARGUMENT, &set, &scene, &room); /* no placements */
    scene.placements = still;
    const fxl_instance *const before = scene.instances;
    scene.instances = NULL;
    refuse(FXL_E_ARGUMENT, &set, &scene, &room);
    scene.instances = before;
    scene.first_turned = 2;
    refuse(FXL_E_COUNT, &set, &scene, &room);
    scene.first_turned = 1;
    refuse(FXL_E_ARGUMENT, NULL, &scene, &room);
    refuse(FXL_E_ARGUMENT, &set, &scene, NULL);
    TEST_ASSERT_EQUAL(FXL_E_ARGUMENT, fxl_motion_begin(NULL, &set, &scene, &room));
    TEST_ASSERT_EQUAL(FXL_E_ARGUMENT, fxl_motion_begin(&player, &set, NULL, &room));
    room.instances = NULL;
    refuse(FXL_E_ARGUMENT, &set, &scene, &room);
    room = memory;
    room.placements = NULL;
    refuse(FXL_E_ARGUMENT, &set, &scene, &room);
    room = memory;
    room.instances = (fxl_instance *)((uintptr_t)instances + 2);
    refuse(FXL_E_ALIGNMENT, &set, &scene, &room);
    room = memory;
    room.placements = (fxl_placement *)((uintptr_t)placements + 1);
    refuse(FXL_E_ALIGNMENT, &set, &scene, &room);
    room = memory;
    set.motions = NULL;
    refuse(FXL_E_ARGUMENT, &set, &scene, &room);
    set.motions = (const fxl_motion *)((uintptr_t)motions + 1);
    refuse(FXL_E_ALIGNMENT, &set, &scene, &room);
    set = make();
    set.keys = NULL;
    refuse(FXL_E_ARGUMENT, &set, &scene, &room);
    set.key_count = 0;
    refuse(FXL_E_ARGUMENT, &set, &scene, &room);
    set.keys = (const fxl_motion_key *)((uintptr_t)keys + 2);
    refuse(FXL_E_ALIGNMENT, &set, &scene, &room);
    set = make();
    set.motion_count = 0;
    set.keys = NULL;
    refuse(FXL_E_ARGUMENT, &set, &scene, &room);
    set = make();
    room.instance_capacity -= 1;
    refuse(FXL_E_CAPACITY, &set, &scene, &room);
    room = memory;
    room.placement_capacity -= 1;
    refuse(FXL_E_CAPACITY, &set, &scene, &room);
    TEST_ASSERT_EQUAL(FXL_OK, fxl_motion_begin(&player, &set, &scene, &memory));
}

void test_no_motions_need_no_tables(void)
{
    fxl_motion_set none = {0};
    fxl_scene scene = tiny_make()->scene;
    fxl_motion_player player;
    scene.placements = still;
    scene.first_turned = 1;
    TEST_ASSERT_EQUAL(FXL_OK, fxl_motion_begin(&player, &none, &scene, &memory));
    none.motions = motions; /* of which it has none */
    TEST_ASSERT_EQUAL(FXL_OK, fxl_motion_begin(&player, &none, &scene, &memory));
}

/* A track of one key repeats as well as it can. */
void test_one_key_repeats(void)
{
    fxl_motion_set set = make_track(1);
    fxl_scene scene;
    keys[0].centre.y = FXL_UNITS(4);
    motions[0].repeats = 1;
    fxl_motion_player player = begin(&set, &scene);
    for (uint32_t frame = 0; frame < 3; frame++) {
        fxl_motion_play(&player, frame);
        TEST_ASSERT_EQUAL_INT32(FXL_UNITS(4), instances[2].centre.y);
    }
}

/* SPDX-License-Identifier: MIT */
/* Motions as data in a world: the player writes to a table of its own, and the program hands on
 * what it wrote. docs/extras/motion.md, section 5. */
#include "draw/stages.h"
#include "fixel/all.h"
#include "world_unit.h"

enum {
    MOTIONS = 2,
    FRAMES = 24
};

/* Instance 1 turns on a circle, and instance 2 is its child. */
static const fxl_motion_key keys[] = {
    {.centre = {0, 0, Q16(9)}, .scale = Q16(1)},
    {.centre = {Q16(2), 0, Q16(4)}, .scale = Q16(0.5)},
    {.frame = 12, .centre = {Q16(-2), Q16(1), 0}, .yaw = DEGREES(90), .scale = Q16(2)}};
static const fxl_motion motions[MOTIONS] = {{.extent = {Q16(100), Q16(100), Q16(100)},
                                             .scale_low = Q16(1),
                                             .scale_high = Q16(1),
                                             .key_count = 1,
                                             .radius = Q16(2),
                                             .circle_step = DEGREES(10),
                                             .yaw_step = DEGREES(15)},
                                            {.extent = {Q16(100), Q16(100), Q16(100)},
                                             .scale_low = Q16(0.5),
                                             .scale_high = Q16(2),
                                             .first_key = 1,
                                             .key_count = 2,
                                             .repeats = 1,
                                             .parent = 1}};
static const fxl_motion_set set = {motions, MOTIONS, keys, 3};
static const fxl_placement still[MOTIONS] = {FXL_PLACEMENT_NONE, FXL_PLACEMENT_NONE};
static fxl_instance played[TINY_INSTANCES];
static fxl_placement played_placements[MOTIONS];
static const fxl_motion_memory memory = {played, TINY_INSTANCES, played_placements, MOTIONS};

static fxl_scene moving_scene(void)
{
    fxl_scene scene = tiny_make()->scene;
    scene.placements = still;
    scene.first_turned = TINY_INSTANCES - MOTIONS;
    TEST_ASSERT_EQUAL(FXL_OK, fxl_scene_check_all(&scene, NULL));
    TEST_ASSERT_EQUAL(FXL_OK, fxl_motion_check(&set, &scene, NULL));
    return scene;
}

static void attach(fxl_renderer *renderer, int number, const fxl_scene *scene)
{
    const fxl_lens lens = unit_lens(WORLD_WIDTH, WORLD_HEIGHT);
    const fxl_memory room = world_renderer_memory(number);
    TEST_ASSERT_EQUAL(FXL_OK, fxl_renderer_init_with(renderer, scene, &lens, &room));
}

/* The frames are those of the player's scene, while other instances of the world come and go. */
/* world 2.5 */
void test_a_world_moves_as_its_motions_say(void)
{
    static fxl_renderer plain;
    const fxl_world_memory room = world_memory();
    const fxl_pose pose = {{Q16(3), Q16(3), Q16(-3)}, 0u - DEGREES(10), 0u - DEGREES(12), 0};
    const fxl_instance behind = world_cube_at(0, -20);
    fxl_motion_player player;
    fxl_scene scene = moving_scene();
    TEST_ASSERT_EQUAL(FXL_OK, fxl_motion_begin(&player, &set, &scene, &memory));
    TEST_ASSERT_EQUAL(FXL_OK, fxl_world_init(&world, &scene, &room));
    attach(&plain, 1, &scene);
    attach(&world_renderer, 0, &world.scene);
    TEST_ASSERT_EQUAL(FXL_OK, fxl_world_attach(&world, &world_renderer));
    fxl_handle other = world_spawned(&behind, NULL);
    uint32_t changed = 0;
    for (uint32_t frame = 0; frame < FRAMES; frame++) {
        fxl_motion_play(&player, frame);
        for (uint32_t i = 0; i < set.motion_count; i++) {
            const fxl_handle handle = fxl_world_handle(scene.instance_count - set.motion_count + i);
            TEST_ASSERT_EQUAL(FXL_OK, fxl_world_move(&world, handle, &player.instances[i].centre));
            TEST_ASSERT_EQUAL(FXL_OK,
                              fxl_world_set_placement(&world, handle, &player.placements[i]));
        }
        memcpy(world_frames[1], world_frames[0], sizeof world_frames[0]);
        world_draw(&world_renderer, &pose, world_frames[0]);
        changed += memcmp(world_frames[0], world_frames[1], sizeof world_frames[0]) != 0;
        world_draw(&plain, &pose, world_frames[1]);
        TEST_ASSERT_EQUAL_MEMORY(world_frames[1], world_frames[0], sizeof world_frames[0]);
        TEST_ASSERT_EQUAL(FXL_OK, fxl_world_remove(&world, other));
        other = world_spawned(&behind, frame % 2 ? &still[0] : NULL);
    }
    TEST_ASSERT_EQUAL_UINT32(FRAMES, changed);
}

/* The player would point the world's scene to its own copies: the world's changes would be drawn no
 * more, until one of them pointed it back. */
/* world 2.5 */
void test_no_motion_begins_on_the_scene_of_a_world(void)
{
    const fxl_world_memory room = world_memory();
    fxl_motion_player player, player_before;
    fxl_scene scene = moving_scene();
    TEST_ASSERT_EQUAL(FXL_OK, fxl_world_init(&world, &scene, &room));
    memset(&player, 0x5A, sizeof player);
    memset(played, 0x5A, sizeof played);
    player_before = player;
    const fxl_world before = world;
    TEST_ASSERT_EQUAL(FXL_E_ORDER, fxl_motion_begin(&player, &set, &world.scene, &memory));
    TEST_ASSERT_EQUAL_MEMORY(&before, &world, sizeof world);
    TEST_ASSERT_EQUAL_MEMORY(&player_before, &player, sizeof player);
    TEST_ASSERT_EACH_EQUAL_HEX8(0x5A, played, sizeof played);
}

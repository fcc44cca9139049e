/* SPDX-License-Identifier: MIT */
#include "world_unit.h"

uint8_t world_frames[2][WORLD_WIDTH * WORLD_HEIGHT];
static uint32_t lists[2][WORLD_LIST];
static fxl_draw_entry orders[2][WORLD_PLACES + 6];
fxl_renderer world_renderer;

fxl_instance world_instances[WORLD_PLACES];
static fxl_placement placements[WORLD_TURNED];
static fxl_world_slot slots[WORLD_PLACES];
uint8_t world_colours[2 * 256];
fxl_world world;

fxl_world_memory world_memory(void)
{
    return (fxl_world_memory){world_instances, slots,         placements, WORLD_CAPACITY,
                              WORLD_TURNED,    world_colours, 2,          &fxl_turned_instances};
}

fxl_memory world_renderer_memory(int number)
{
    return (fxl_memory){orders[number], WORLD_PLACES + 6, lists[number], WORLD_LIST, NULL, 0};
}

tiny_scene *world_scene(void)
{
    tiny_scene *tiny = tiny_make();
    TEST_ASSERT_EQUAL(FXL_OK, fxl_scene_check(&tiny->scene, NULL));
    return tiny;
}

static void attach(void)
{
    const fxl_lens lens = unit_lens(WORLD_WIDTH, WORLD_HEIGHT);
    const fxl_memory room = world_renderer_memory(0);
    TEST_ASSERT_EQUAL(FXL_OK, fxl_renderer_init_with(&world_renderer, &world.scene, &lens, &room));
    TEST_ASSERT_EQUAL(FXL_OK, fxl_world_attach(&world, &world_renderer));
}

tiny_scene *world_start(void)
{
    const fxl_world_memory room = world_memory();
    tiny_scene *tiny = world_scene();
    TEST_ASSERT_EQUAL(FXL_OK, fxl_world_init(&world, &tiny->scene, &room));
    attach();
    return tiny;
}

fxl_instance world_cube_at(double x, double z)
{
    return (fxl_instance){{Q16(x), 0, Q16(z)}, 0, 0, 0};
}

fxl_handle world_spawned(const fxl_instance *instance, const fxl_placement *placement)
{
    fxl_handle handle;
    TEST_ASSERT_EQUAL(FXL_OK, fxl_world_spawn(&world, instance, placement, &handle));
    return handle;
}

void world_draw(fxl_renderer *by, const fxl_pose *pose, uint8_t *frame)
{
    const fxl_band band = UNIT_BAND(frame, WORLD_WIDTH, 0, WORLD_HEIGHT);
    fxl_fill_band(&band, WORLD_BACKGROUND);
    TEST_ASSERT_EQUAL(FXL_OK, fxl_frame_begin(by, pose));
    TEST_ASSERT_EQUAL(FXL_OK, fxl_frame_draw(by, &band));
    TEST_ASSERT_EQUAL(FXL_OK, fxl_frame_end(by));
}

uint32_t world_use_stale(fxl_handle handle)
{
    const fxl_point centre = {0, 0, 0};
    TEST_ASSERT_EQUAL(FXL_E_STALE, fxl_world_remove(&world, handle));
    TEST_ASSERT_EQUAL(FXL_E_STALE, fxl_world_hide(&world, handle));
    TEST_ASSERT_EQUAL(FXL_E_STALE, fxl_world_show(&world, handle));
    TEST_ASSERT_EQUAL(FXL_E_STALE, fxl_world_move(&world, handle, &centre));
    TEST_ASSERT_EQUAL(FXL_E_STALE, fxl_world_set_placement(&world, handle, NULL));
    TEST_ASSERT_EQUAL(FXL_E_STALE, fxl_world_set_model(&world, handle, 0));
    TEST_ASSERT_EQUAL(FXL_E_STALE, fxl_world_set_layer(&world, handle, 0));
    TEST_ASSERT_EQUAL(FXL_E_STALE, fxl_world_recolour(&world, handle, 0));
    TEST_ASSERT_NULL(fxl_world_instance(&world, handle));
    TEST_ASSERT_NULL(fxl_world_placement(&world, handle));
    TEST_ASSERT_FALSE(fxl_world_is_shown(&world, handle));
    return 8;
}

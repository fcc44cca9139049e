/* SPDX-License-Identifier: MIT */
/* A world whose scene has a BSP tree: the tree keeps its instance, and cubes that come and go are
 * cut by it. */
#include "bsp_scene.h"
#include "choices.h"
#include "draw/stages.h"
#include "fixel/all.h"
#include "world_unit.h"

enum {
    ROOM = 4096,
    PIECES = 4096
};

static FXL_ALIGN_8 uint8_t room[ROOM], pieces[PIECES];

static bsp_scene *start(void)
{
    const fxl_lens lens = unit_lens(WORLD_WIDTH, WORLD_HEIGHT);
    const fxl_world_memory memory = world_memory();
    const fxl_memory tables = world_renderer_memory(0);
    bsp_scene *made = bsp_make();
    TEST_ASSERT_EQUAL(FXL_OK, fxl_scene_check_all(&made->tiny->scene, NULL));
    TEST_ASSERT_EQUAL(FXL_OK, fxl_world_init(&world, &made->tiny->scene, &memory));
    TEST_ASSERT_EQUAL(FXL_OK,
                      fxl_renderer_init_with(&world_renderer, &world.scene, &lens, &tables));
    TEST_ASSERT_EQUAL(FXL_OK, fxl_world_attach(&world, &world_renderer));
    TEST_ASSERT_EQUAL(FXL_OK, choice_take(&world_renderer, &choice_tree, room, sizeof room));
    fxl_bsp_workspace *tree = world_renderer.order_memory;
    tree->pieces = pieces;
    tree->pieces_size = sizeof pieces;
    return made;
}

/* The instance of the tree is that of the scene's instance 1. */
static void expect_tree(void)
{
    const fxl_instance *owner = fxl_world_instance(&world, fxl_world_handle(1));
    TEST_ASSERT_NOT_NULL(owner);
    TEST_ASSERT_TRUE(owner == &world.scene.instances[world.scene.bsp_instance]);
    TEST_ASSERT_EQUAL(1, owner->model);
}

void test_the_instance_of_a_tree_stays(void)
{
    const fxl_point centre = {0, 0, 0};
    const fxl_handle owner = fxl_world_handle(1);
    const fxl_instance shares = {{0, 0, 0}, 1, 3, 0}, beside = {{0, 0, 0}, 0, 0, 0};
    fxl_handle handle;
    (void)start();
    expect_tree();
    TEST_ASSERT_EQUAL(FXL_E_BSP, fxl_world_remove(&world, owner));
    TEST_ASSERT_EQUAL(FXL_E_BSP, fxl_world_hide(&world, owner));
    TEST_ASSERT_EQUAL(FXL_E_BSP, fxl_world_move(&world, owner, &centre));
    TEST_ASSERT_EQUAL(FXL_E_BSP, fxl_world_set_placement(&world, owner, NULL));
    TEST_ASSERT_EQUAL(FXL_E_BSP, fxl_world_set_model(&world, owner, 0));
    TEST_ASSERT_EQUAL(FXL_E_BSP, fxl_world_set_layer(&world, owner, 1));
    TEST_ASSERT_EQUAL(FXL_OK, fxl_world_recolour(&world, owner, 1));
    TEST_ASSERT_EQUAL(FXL_E_BSP, fxl_world_spawn(&world, &shares, NULL, &handle));
    TEST_ASSERT_EQUAL(FXL_E_BSP, fxl_world_set_model(&world, fxl_world_handle(0), 1));
    TEST_ASSERT_EQUAL_UINT32(8, world.refused_calls);
    TEST_ASSERT_EQUAL(FXL_OK, fxl_world_spawn(&world, &beside, NULL, &handle));
    expect_tree();
}

/* In the tree's layer there are only convex models. */
void test_a_sorted_model_may_not_join_the_layer_of_a_tree(void)
{
    static fxl_model models[2];
    const fxl_instance sorted = {{0, 0, 0}, 0, 5, 0};
    bsp_scene *made = start();
    memcpy(models, made->tiny->models, sizeof models);
    models[0].kind = FXL_MODEL_SORTED;
    world.scene.models = models;
    const fxl_handle handle = world_spawned(&sorted, NULL);
    TEST_ASSERT_EQUAL(FXL_E_BSP, fxl_world_set_layer(&world, handle, 0));
    TEST_ASSERT_EQUAL(FXL_OK, fxl_world_set_layer(&world, handle, 6));
}

/* Cubes that come and go about the tree: as in a scene made anew, whose workspace is smaller. */
/* world 2.1 */
void test_a_tree_cuts_what_comes_and_goes(void)
{
    static fxl_renderer anew;
    static fxl_instance list[WORLD_PLACES];
    const fxl_lens lens = unit_lens(WORLD_WIDTH, WORLD_HEIGHT);
    const fxl_memory tables = world_renderer_memory(1);
    static FXL_ALIGN_8 uint8_t other_room[ROOM];
    const bsp_scene *made = start();
    fxl_handle handles[4];
    uint32_t count = 0, cut = 0;
    for (uint32_t round = 0; round < UNIT_REPEAT / 500; round++) {
        if (count < 4 && (count == 0 || unit_between(0, 1))) {
            const fxl_instance cube = {{unit_between(Q16(-2), Q16(2)),
                                        unit_between(Q16(-2), Q16(2)),
                                        unit_between(Q16(8), Q16(12))},
                                       0,
                                       0,
                                       0};
            handles[count++] = world_spawned(&cube, NULL);
        } else {
            TEST_ASSERT_EQUAL(FXL_OK, fxl_world_remove(&world, handles[0]));
            handles[0] = handles[--count];
        }
        expect_tree();
        fxl_scene scene = made->tiny->scene;
        const fxl_pose pose = {{unit_between(Q16(-3), Q16(3)), 0, 0}, 0, 0, 0};
        memcpy(list, world.scene.instances, world.scene.instance_count * sizeof list[0]);
        scene.instances = list;
        scene.instance_count = world.scene.instance_count;
        scene.bsp_instance = world.scene.bsp_instance;
        TEST_ASSERT_EQUAL(FXL_OK, fxl_scene_check_all(&scene, NULL));
        TEST_ASSERT_EQUAL(FXL_OK, fxl_renderer_init_with(&anew, &scene, &lens, &tables));
        TEST_ASSERT_EQUAL(FXL_OK, choice_take(&anew, &choice_tree, other_room, sizeof other_room));
        world_draw(&world_renderer, &pose, world_frames[0]);
        cut += ((fxl_bsp_workspace *)world_renderer.order_memory)->used > 0;
        ((fxl_bsp_workspace *)anew.order_memory)->pieces = pieces;
        ((fxl_bsp_workspace *)anew.order_memory)->pieces_size = sizeof pieces;
        world_draw(&anew, &pose, world_frames[1]);
        TEST_ASSERT_EQUAL_MEMORY(world_frames[1], world_frames[0], sizeof world_frames[0]);
    }
    TEST_ASSERT_TRUE(cut > UNIT_REPEAT / 1000);
}

/* What the tree cuts, and what a beam then splits, keeps the colours of its instance. */
/* light 5.1 */
void test_pieces_have_the_colours_of_their_instance(void)
{
    static fxl_world_colours colours;
    const fxl_pose pose = {{Q16(1), 0, 0}, 0, 0, 0};
    (void)start();
    for (int i = 0; i < 256; i++) {
        world_colours[i] = (uint8_t)(i + 100);
    }
    const fxl_instance cube = {{Q16(0.75), 0, Q16(8.75)}, 0, 0, 0};
    const fxl_handle handle = world_spawned(&cube, NULL);
    world_draw(&world_renderer, &pose, world_frames[0]);
    TEST_ASSERT_EQUAL(FXL_OK, fxl_world_recolour(&world, handle, 1));
    TEST_ASSERT_EQUAL(FXL_OK, fxl_world_set_colours(&world, &world_renderer, &colours));
    world_draw(&world_renderer, &pose, world_frames[1]);
    uint32_t changed = 0;
    for (int i = 0; i < WORLD_WIDTH * WORLD_HEIGHT; i++) {
        const uint8_t was = world_frames[0][i], is = world_frames[1][i];
        TEST_ASSERT_TRUE(is == was || (was >= 1 && was <= 6 && is == was + 100));
        changed += is != was;
    }
    TEST_ASSERT_TRUE(changed > 10);
    TEST_ASSERT_TRUE(((fxl_bsp_workspace *)world_renderer.order_memory)->used > 0);
}

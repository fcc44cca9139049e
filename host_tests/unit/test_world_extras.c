/* SPDX-License-Identifier: MIT */
/* Worlds with what else a program may attach: a tree, motions, surfaces. */
#include "bsp_scene.h"
#include "choices.h"
#include "world_unit.h"

/* A world whose scene has a BSP tree: the tree keeps its instance, and cubes that come and go are
 * cut by it. */

enum {
    ROOM = 4096,
    PIECES = 4096
};

static FXL_ALIGN_8 uint8_t tree_room[ROOM], pieces[PIECES];

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
    TEST_ASSERT_EQUAL(FXL_OK,
                      choice_take(&world_renderer, &choice_tree, tree_room, sizeof tree_room));
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
/* light 5.1a */
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

/* Motions as data in a world: the player writes to a table of its own, and the program hands on
 * what it wrote. docs/extras/motion.md, section 5. */

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
static const fxl_motion_set motion_set = {motions, MOTIONS, keys, 3};
static const fxl_placement still[MOTIONS] = {FXL_PLACEMENT_NONE, FXL_PLACEMENT_NONE};
static fxl_instance played[TINY_INSTANCES];
static fxl_placement played_placements[MOTIONS];
static const fxl_motion_memory motion_memory = {played, TINY_INSTANCES, played_placements, MOTIONS};

static fxl_scene moving_scene(void)
{
    fxl_scene scene = tiny_make()->scene;
    scene.placements = still;
    scene.first_turned = TINY_INSTANCES - MOTIONS;
    TEST_ASSERT_EQUAL(FXL_OK, fxl_scene_check_all(&scene, NULL));
    TEST_ASSERT_EQUAL(FXL_OK, fxl_motion_check(&motion_set, &scene, NULL));
    return scene;
}

static void attach_renderer(fxl_renderer *renderer, int number, const fxl_scene *scene)
{
    const fxl_lens lens = unit_lens(WORLD_WIDTH, WORLD_HEIGHT);
    const fxl_memory room = world_renderer_memory(number);
    TEST_ASSERT_EQUAL(FXL_OK, fxl_renderer_init_with(renderer, scene, &lens, &room));
}

/* The frames are those of the player's scene, while other instances of the world come and go. */
/* world 2.5b */
void test_a_world_moves_as_its_motions_say(void)
{
    static fxl_renderer plain;
    const fxl_world_memory room = world_memory();
    const fxl_pose pose = {{Q16(3), Q16(3), Q16(-3)}, 0u - DEGREES(10), 0u - DEGREES(12), 0};
    const fxl_instance behind = world_cube_at(0, -20);
    fxl_motion_player player;
    fxl_scene scene = moving_scene();
    TEST_ASSERT_EQUAL(FXL_OK, fxl_motion_begin(&player, &motion_set, &scene, &motion_memory));
    TEST_ASSERT_EQUAL(FXL_OK, fxl_world_init(&world, &scene, &room));
    attach_renderer(&plain, 1, &scene);
    attach_renderer(&world_renderer, 0, &world.scene);
    TEST_ASSERT_EQUAL(FXL_OK, fxl_world_attach(&world, &world_renderer));
    fxl_handle other = world_spawned(&behind, NULL);
    uint32_t changed = 0;
    for (uint32_t frame = 0; frame < FRAMES; frame++) {
        fxl_motion_play(&player, frame);
        for (uint32_t i = 0; i < motion_set.motion_count; i++) {
            const fxl_handle handle =
                fxl_world_handle(scene.instance_count - motion_set.motion_count + i);
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
/* world 2.5c */
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
    TEST_ASSERT_EQUAL(FXL_E_ORDER,
                      fxl_motion_begin(&player, &motion_set, &world.scene, &motion_memory));
    TEST_ASSERT_EQUAL_MEMORY(&before, &world, sizeof world);
    TEST_ASSERT_EQUAL_MEMORY(&player_before, &player, sizeof player);
    TEST_ASSERT_EACH_EQUAL_HEX8(0x5A, played, sizeof played);
}

/* Surfaces of instances that a world recolours. */

enum {
    TEXEL = 90 /* and the next */
};

static const uint8_t texels[2] = {TEXEL, TEXEL + 1};
static uint16_t face_map[12];
static fxl_texture texture;
static fxl_surface surface;
static fxl_mapped_face mapped;
static fxl_corner mapped_corners[3];
static fxl_surface_set surface_set;
static fxl_surfaces surfaces;

/* The face -z of model 0 has a texture of two colours. */
static void attach_surfaces(const tiny_scene *tiny)
{
    texture = (fxl_texture){.texels = texels, .log_width = 1, .levels = 1};
    surface = (fxl_surface){.texture = 1, .opacity = 16, .division = FXL_DIVIDE_1};
    mapped = (fxl_mapped_face){.corners = {0, 1, 2}};
    const uint16_t *vertices = fxl_face_indices(tiny->corners, &tiny->faces[4]);
    mapped_corners[0] = (fxl_corner){{0, 0}, vertices[0], 0};
    mapped_corners[1] = (fxl_corner){{0, Q16(2)}, vertices[1], 0};
    mapped_corners[2] = (fxl_corner){{Q16(2), Q16(2)}, vertices[2], 0};
    memset(face_map, 0, sizeof face_map);
    face_map[4] = 1;
    surface_set = (fxl_surface_set){.textures = &texture,
                                    .surfaces = &surface,
                                    .faces = &mapped,
                                    .face_map = face_map,
                                    .corners = mapped_corners,
                                    .texture_count = 1,
                                    .surface_count = 1,
                                    .face_count = 1,
                                    .corner_count = 3};
    TEST_ASSERT_EQUAL(FXL_OK, fxl_attach_surfaces(&world_renderer, &surfaces, &surface_set,
                                                  FXL_SURFACES_OF(fxl_palette)));
}

/* The faces without a surface are recoloured, and those with one keep their texels. */
/* surfaces 6.2a */
void test_an_instance_that_is_recoloured_keeps_its_surfaces(void)
{
    static fxl_world_colours colours;
    const fxl_pose pose = {{Q16(2), Q16(1), Q16(-4)}, 0, 0, 0};
    const fxl_instance cube = {{0, 0, 0}, 0, 0, 0};
    const tiny_scene *tiny = world_start();
    uint32_t kept = 0, changed = 0;
    for (uint32_t i = 0; i < TINY_INSTANCES; i++) {
        TEST_ASSERT_EQUAL(FXL_OK, fxl_world_hide(&world, fxl_world_handle(i)));
    }
    for (uint32_t i = 0; i < 256; i++) {
        world_colours[i] = (uint8_t)(i + 100);
    }
    const fxl_handle handle = world_spawned(&cube, NULL);
    attach_surfaces(tiny);
    TEST_ASSERT_EQUAL(FXL_OK, fxl_world_set_colours(&world, &world_renderer, &colours));
    world_draw(&world_renderer, &pose, world_frames[0]);
    TEST_ASSERT_EQUAL(FXL_OK, fxl_world_recolour(&world, handle, 1));
    world_draw(&world_renderer, &pose, world_frames[1]);
    for (uint32_t i = 0; i < WORLD_WIDTH * WORLD_HEIGHT; i++) {
        const uint8_t before = world_frames[0][i];
        const bool is_texel = before == TEXEL || before == TEXEL + 1;
        const bool is_kept = is_texel || before == WORLD_BACKGROUND;
        TEST_ASSERT_EQUAL_UINT8(is_kept ? before : before + 100, world_frames[1][i]);
        kept += is_texel;
        changed += !is_kept;
    }
    TEST_ASSERT_TRUE(kept > 20 && changed > 10);
}

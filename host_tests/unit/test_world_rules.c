/* SPDX-License-Identifier: MIT */
/* What a world promises and refuses, rule by rule. */
#include "world_unit.h"

/* world 1.1b */
void test_the_scenes_instances_keep_their_order(void)
{
    tiny_scene *tiny = world_start();
    TEST_ASSERT_EQUAL_UINT32(TINY_INSTANCES, world.scene.instance_count);
    TEST_ASSERT_EQUAL_MEMORY(tiny->instances, world.scene.instances, sizeof tiny->instances);
    TEST_ASSERT_EQUAL_UINT32(WORLD_PLACES, world.scene.instance_capacity);
    TEST_ASSERT_EQUAL_UINT32(WORLD_PLACES + 6, world.scene.draw_list_needed);
    TEST_ASSERT_NULL(world.scene.placements);
}

/* A world of which every instance is a world's scene again. */
/* world 1.1 */
void test_instances_with_placements_are_taken_over(void)
{
    static const fxl_placement placement = {
        {{0, FXL_Q2_30_ONE, 0}, {-FXL_Q2_30_ONE, 0, 0}, {0, 0, FXL_Q2_30_ONE}}, Q16(2)};
    static fxl_instance more[WORLD_PLACES];
    static fxl_placement more_placements[WORLD_TURNED];
    static fxl_world_slot more_slots[WORLD_PLACES];
    static fxl_world other;
    const fxl_instance instance = world_cube_at(3, 20), second = world_cube_at(-4, 9);
    fxl_world_memory room = world_memory();
    (void)world_start();
    (void)world_spawned(&instance, &placement);
    (void)world_spawned(&second, &placement);
    room.instances = more;
    room.slots = more_slots;
    room.placements = more_placements;
    TEST_ASSERT_EQUAL(FXL_OK, fxl_world_init(&other, &world.scene, &room));
    const fxl_placement *found = fxl_world_placement(&other, fxl_world_handle(TINY_INSTANCES));
    TEST_ASSERT_NOT_NULL(found);
    TEST_ASSERT_EQUAL_MEMORY(&placement, found, sizeof placement);
    for (uint32_t i = 0; i < TINY_INSTANCES + 2; i++) {
        const fxl_instance *taken = fxl_world_instance(&other, fxl_world_handle(i));
        TEST_ASSERT_EQUAL_MEMORY(&world.scene.instances[i], taken, sizeof *taken);
    }
    TEST_ASSERT_EQUAL_UINT32(TINY_INSTANCES, other.scene.first_turned);
    TEST_ASSERT_EQUAL_UINT32(world.scene.draw_list_needed, other.scene.draw_list_needed);
    room.turned_capacity = 0;
    TEST_ASSERT_EQUAL(FXL_E_CAPACITY, fxl_world_init(&other, &world.scene, &room));
}

/* Those of the scene count. */
/* world 1.1a-b */
void test_each_capacity_is_for_instances_of_its_kind(void)
{
    static const fxl_placement placement = {
        {{FXL_Q2_30_ONE, 0, 0}, {0, FXL_Q2_30_ONE, 0}, {0, 0, FXL_Q2_30_ONE}}, Q16(1)};
    const fxl_instance instance = world_cube_at(2, 10);
    fxl_handle handle;
    (void)world_start();
    for (uint32_t i = TINY_INSTANCES; i < WORLD_CAPACITY; i++) {
        (void)world_spawned(&instance, NULL);
    }
    TEST_ASSERT_EQUAL(FXL_E_CAPACITY, fxl_world_spawn(&world, &instance, NULL, &handle));
    for (uint32_t i = 0; i < WORLD_TURNED; i++) {
        (void)world_spawned(&instance, &placement);
    }
    TEST_ASSERT_EQUAL(FXL_E_CAPACITY, fxl_world_spawn(&world, &instance, &placement, &handle));
    TEST_ASSERT_EQUAL_UINT32(WORLD_PLACES, world.scene.instance_count);
}

/* world 1.2b */
void test_a_handle_stays_stale_when_its_slot_is_used_again(void)
{
    (void)world_start();
    const fxl_instance instance = world_cube_at(0, 5);
    const fxl_handle first = world_spawned(&instance, NULL);
    TEST_ASSERT_EQUAL(FXL_OK, fxl_world_remove(&world, first));
    const fxl_handle second = world_spawned(&instance, NULL);
    TEST_ASSERT_EQUAL_UINT32(first.slot, second.slot);
    (void)world_use_stale(first);
    (void)world_use_stale((fxl_handle){0, 0});
    (void)world_use_stale((fxl_handle){WORLD_PLACES, 1});
    (void)world_use_stale((fxl_handle){UINT32_MAX, 1});
    (void)world_use_stale((fxl_handle){second.slot + 1, 0}); /* a free slot's own number */
    TEST_ASSERT_NOT_NULL(fxl_world_instance(&world, second));
}

/* The sight falls on an instance that has not the place that it was spawned at. */
/* world 1.2e-f, 1.2i */
void test_what_is_hit_has_a_handle(void)
{
    const fxl_pose pose = {{0, 0, Q16(-4)}, 0, 0, 0};
    const fxl_point eye = {0, 0, Q16(-4)}, end = {0, 0, Q16(9)};
    const fxl_instance wide = world_cube_at(6, 5), target = world_cube_at(0, 5);
    fxl_picked picked;
    fxl_hit hit;
    (void)world_start();
    (void)world_spawned(&wide, NULL);
    const fxl_handle aim = world_spawned(&target, NULL);
    TEST_ASSERT_EQUAL(FXL_OK, fxl_world_remove(&world, fxl_world_handle(0)));
    TEST_ASSERT_EQUAL(FXL_OK, fxl_frame_begin(&world_renderer, &pose));
    TEST_ASSERT_EQUAL(FXL_OK,
                      fxl_pick_face(&world_renderer, WORLD_WIDTH / 2, WORLD_HEIGHT / 2, &picked));
    TEST_ASSERT_EQUAL(FXL_OK, fxl_cast_segment(&world.scene, &eye, &end, &hit));
    TEST_ASSERT_EQUAL(picked.instance, hit.instance);
    const fxl_handle found = fxl_world_handle_at(&world, picked.instance);
    TEST_ASSERT_EQUAL_MEMORY(&aim, &found, sizeof found);
    TEST_ASSERT_EQUAL(FXL_OK, fxl_pick_face(&world_renderer, 0, 0, &picked));
    TEST_ASSERT_EQUAL(FXL_PICK_NONE, picked.instance);
    (void)fxl_frame_end(&world_renderer);
    (void)world_use_stale(fxl_world_handle_at(&world, picked.instance));
    (void)world_use_stale(fxl_world_handle_at(&world, FXL_HIT_NONE));
    (void)world_use_stale(fxl_world_handle_at(&world, world.scene.instance_count));
    (void)world_use_stale(fxl_world_handle_at(&world, UINT32_MAX));
    (void)world_use_stale(fxl_world_handle_at(NULL, 0));
}

/* Every change, by a handle that is right. */
static void expect_of_changes(fxl_status expected, fxl_handle handle)
{
    const fxl_instance instance = world_cube_at(1, 6);
    const fxl_world before = world;
    const uint32_t calls = world.refused_calls;
    fxl_handle made = {77, 77};
    TEST_ASSERT_EQUAL(expected, fxl_world_spawn(&world, &instance, NULL, &made));
    TEST_ASSERT_EQUAL(expected, fxl_world_remove(&world, handle));
    TEST_ASSERT_EQUAL(expected, fxl_world_hide(&world, handle));
    TEST_ASSERT_EQUAL(expected, fxl_world_show(&world, handle));
    TEST_ASSERT_EQUAL(expected, fxl_world_move(&world, handle, &instance.centre));
    TEST_ASSERT_EQUAL(expected, fxl_world_set_placement(&world, handle, NULL));
    TEST_ASSERT_EQUAL(expected, fxl_world_set_model(&world, handle, 1));
    TEST_ASSERT_EQUAL(expected, fxl_world_set_layer(&world, handle, 9));
    TEST_ASSERT_EQUAL(expected, fxl_world_recolour(&world, handle, 1));
    TEST_ASSERT_EQUAL_UINT32(calls + 9, world.refused_calls);
    world.refused_calls = calls;
    TEST_ASSERT_EQUAL_MEMORY(&before, &world, sizeof world);
    TEST_ASSERT_TRUE(made.slot == 77 && made.generation == 77);
}

/* world 2.3a-b */
void test_nothing_changes_while_a_frame_is_drawn(void)
{
    static fxl_instance before[WORLD_PLACES];
    const fxl_pose pose = {{0, 0, Q16(-4)}, 0, 0, 0};
    const fxl_band band = UNIT_BAND(world_frames[0], WORLD_WIDTH, 0, 8);
    (void)world_start();
    memcpy(before, world_instances, sizeof before);
    TEST_ASSERT_EQUAL(FXL_OK, fxl_frame_begin(&world_renderer, &pose));
    expect_of_changes(FXL_E_ORDER, fxl_world_handle(0));
    TEST_ASSERT_EQUAL(FXL_OK, fxl_frame_draw(&world_renderer, &band));
    expect_of_changes(FXL_E_ORDER, fxl_world_handle(0));
    TEST_ASSERT_EQUAL_MEMORY(before, world_instances, sizeof before);
    TEST_ASSERT_EQUAL(FXL_E_ARGUMENT, fxl_frame_end(NULL));
    TEST_ASSERT_EQUAL(FXL_OK, fxl_frame_end(&world_renderer));
    TEST_ASSERT_EQUAL(FXL_E_ORDER, fxl_frame_draw(&world_renderer, &band));
    TEST_ASSERT_EQUAL(FXL_OK, fxl_world_remove(&world, fxl_world_handle(0)));
}

/* world 2.3d, 2.4a-b */
void test_a_renderer_draws_once_it_is_attached(void)
{
    static fxl_renderer others[FXL_WORLD_RENDERERS_MAX];
    const fxl_pose pose = {{0, 0, Q16(-4)}, 0, 0, 0};
    const fxl_lens lens = unit_lens(WORLD_WIDTH, WORLD_HEIGHT);
    const fxl_memory room = world_renderer_memory(1);
    const fxl_instance instance = world_cube_at(1, 6);
    tiny_scene *tiny = world_start();
    for (int i = 0; i < FXL_WORLD_RENDERERS_MAX; i++) {
        TEST_ASSERT_EQUAL(FXL_OK, fxl_renderer_init_with(&others[i], &world.scene, &lens, &room));
        TEST_ASSERT_EQUAL(FXL_E_CAPACITY, fxl_frame_begin(&others[i], &pose));
        TEST_ASSERT_EQUAL(i + 1 < FXL_WORLD_RENDERERS_MAX ? FXL_OK : FXL_E_CAPACITY,
                          fxl_world_attach(&world, &others[i]));
    }
    /* Any of them holds changes off. */
    TEST_ASSERT_EQUAL(FXL_OK, fxl_frame_begin(&others[1], &pose));
    expect_of_changes(FXL_E_ORDER, fxl_world_handle(0));
    TEST_ASSERT_EQUAL(FXL_OK, fxl_world_detach(&world, &others[1]));
    TEST_ASSERT_EQUAL(FXL_E_CAPACITY, fxl_frame_begin(&others[1], &pose));
    (void)world_spawned(&instance, NULL);
    TEST_ASSERT_EQUAL(FXL_OK, fxl_world_attach(&world, &others[1]));
    TEST_ASSERT_EQUAL(FXL_OK, fxl_world_attach(&world, &others[1])); /* it has its place */
    TEST_ASSERT_EQUAL(FXL_OK, fxl_frame_begin(&others[1], &pose));
    TEST_ASSERT_EQUAL_UINT32(1, world.refused_calls);
    TEST_ASSERT_EQUAL(FXL_OK, fxl_renderer_init_with(&others[3], &tiny->scene, &lens, &room));
    TEST_ASSERT_EQUAL(FXL_E_RANGE, fxl_world_attach(&world, &others[3]));
    TEST_ASSERT_EQUAL(FXL_E_ARGUMENT, fxl_world_attach(&world, NULL));
    TEST_ASSERT_EQUAL(FXL_E_ARGUMENT, fxl_world_attach(NULL, &others[3]));
    TEST_ASSERT_EQUAL(FXL_E_INDEX, fxl_world_detach(&world, &others[3]));
    TEST_ASSERT_EQUAL(FXL_E_ARGUMENT, fxl_world_detach(&world, NULL));
    TEST_ASSERT_EQUAL(FXL_E_ARGUMENT, fxl_world_detach(NULL, &others[3]));
    TEST_ASSERT_EQUAL_UINT32(5, world.refused_calls);
}

/* The order's entries for the faces of a model do not move as the world fills. */
void test_another_workspace_has_room_for_the_largest_model(void)
{
    (void)world_start();
    const size_t size = fxl_workspace_size(&world_renderer);
    TEST_ASSERT_EQUAL(6 * sizeof(fxl_draw_entry), size);
    const fxl_instance instance = world_cube_at(2, 8);
    (void)world_spawned(&instance, NULL);
    TEST_ASSERT_EQUAL(size, fxl_workspace_size(&world_renderer));
}

/* To a unit: the radius times the scale is rounded up. Without a placement there is no slack. */
/* world 2.2a */
void test_the_edge_of_the_world_is_exact(void)
{
    fxl_placement placement = {
        {{FXL_Q2_30_ONE, 0, 0}, {0, FXL_Q2_30_ONE, 0}, {0, 0, FXL_Q2_30_ONE}}, FXL_Q16_16_ONE};
    fxl_instance instance = world_cube_at(0, 0);
    (void)world_start();
    const fxl_handle handle = world_spawned(&instance, &placement);
    fxl_point edge = {0, -(FXL_COORDINATE_MAX - FXL_PLACEMENT_SLACK - TINY_RADIUS), 0};
    TEST_ASSERT_EQUAL(FXL_OK, fxl_world_move(&world, handle, &edge));
    placement.scale += 1; /* the product is not whole */
    TEST_ASSERT_EQUAL(FXL_E_RANGE, fxl_world_set_placement(&world, handle, &placement));
    placement.scale = 1 * 65536 + 1;
    edge.y += 1; /* TINY_RADIUS is 1.75: a scale of 1 + 1/65536 makes it 1.75/65536 longer */
    TEST_ASSERT_EQUAL(FXL_OK, fxl_world_move(&world, handle, &edge));
    TEST_ASSERT_EQUAL(FXL_E_RANGE, fxl_world_set_placement(&world, handle, &placement));
    edge.y += 1;
    TEST_ASSERT_EQUAL(FXL_OK, fxl_world_move(&world, handle, &edge));
    TEST_ASSERT_EQUAL(FXL_OK, fxl_world_set_placement(&world, handle, &placement));
    edge.y -= 1;
    TEST_ASSERT_EQUAL(FXL_E_RANGE, fxl_world_move(&world, handle, &edge));
    const fxl_handle unturned = world_spawned(&instance, NULL);
    for (int axis = 0; axis < 6; axis++) {
        const int32_t sign = axis < 3 ? 1 : -1;
        edge = (fxl_point){0, 0, 0};
        (&edge.x)[axis % 3] = sign * (FXL_COORDINATE_MAX - TINY_RADIUS);
        TEST_ASSERT_EQUAL(FXL_OK, fxl_world_move(&world, unturned, &edge));
        (&edge.x)[axis % 3] += sign;
        TEST_ASSERT_EQUAL(FXL_E_RANGE, fxl_world_move(&world, unturned, &edge));
    }
}

static fxl_world_memory init_room;
static const fxl_scene *init_scene;

static void expect_init(fxl_status status, const char *what, uint32_t index)
{
    (void)what;
    (void)index;
    TEST_ASSERT_EQUAL(status, fxl_world_init(&world, init_scene, &init_room));
    init_room = world_memory();
}

/* world 1.1a */
void test_init_refuses(void)
{
    const fxl_world_memory right = world_memory();
    fxl_world_memory room = init_room = right;
    fxl_world before;
    tiny_scene *tiny = world_start();
    before = world;
    const fxl_scene *scene = init_scene = &tiny->scene;
    const unit_field fields[] = {
        {UNIT_FIELD(init_room.instances, 0), FXL_E_ARGUMENT, NULL, 0},
        {UNIT_FIELD(init_room.slots, 0), FXL_E_ARGUMENT, NULL, 0},
        {UNIT_FIELD(init_room.placements, 0), FXL_E_ARGUMENT, NULL, 0},
        {UNIT_FIELD(init_room.placement_code, 0), FXL_E_ARGUMENT, NULL, 0},
        {UNIT_FIELD(init_room.colours, 0), FXL_E_ARGUMENT, NULL, 0},
        {UNIT_FIELD(init_room.instances, (intptr_t)right.instances + 1), FXL_E_ALIGNMENT, NULL, 0},
        {UNIT_FIELD(init_room.slots, (intptr_t)right.slots + 2), FXL_E_ALIGNMENT, NULL, 0},
        {UNIT_FIELD(init_room.placements, (intptr_t)right.placements + 1), FXL_E_ALIGNMENT, NULL,
         0},
        {UNIT_FIELD(init_room.colour_count, 256), FXL_E_COUNT, NULL, 0},
        {UNIT_FIELD(init_room.capacity, FXL_SCENE_INSTANCES_MAX - WORLD_TURNED + 1), FXL_E_COUNT,
         NULL, 0},
        {UNIT_FIELD(init_room.capacity, TINY_INSTANCES - 1), FXL_E_CAPACITY, NULL, 0},
    };
    unit_expect_fields(fields, sizeof fields / sizeof fields[0], expect_init);
    TEST_ASSERT_EQUAL(FXL_E_ARGUMENT, fxl_world_init(NULL, scene, &room));
    TEST_ASSERT_EQUAL(FXL_E_ARGUMENT, fxl_world_init(&world, NULL, &room));
    TEST_ASSERT_EQUAL(FXL_E_ARGUMENT, fxl_world_init(&world, scene, NULL));
    room.capacity = UINT32_MAX;
    room.turned_capacity = 1;
    TEST_ASSERT_EQUAL(FXL_E_COUNT, fxl_world_init(&world, scene, &room));
    room.capacity = room.turned_capacity = 0;
    TEST_ASSERT_EQUAL(FXL_E_COUNT, fxl_world_init(&world, scene, &room));
    room = right; /* as much as may be, but too little for the scene */
    room.capacity = FXL_SCENE_INSTANCES_MAX - WORLD_TURNED;
    room.colour_count = UINT8_MAX;
    fxl_scene crowded = *scene;
    crowded.instance_count = FXL_SCENE_INSTANCES_MAX + 1;
    TEST_ASSERT_EQUAL(FXL_E_CAPACITY, fxl_world_init(&world, &crowded, &room));
    tiny->scene.draw_list_needed = 0;
    TEST_ASSERT_EQUAL(FXL_E_ORDER, fxl_world_init(&world, scene, &right));
    TEST_ASSERT_EQUAL_MEMORY(&before, &world, sizeof world);
}

/* A world over another one's scene, with fewer tables of colours than an instance there needs. */
void test_colours_that_another_world_lacks_are_refused(void)
{
    static fxl_instance more[WORLD_PLACES];
    static fxl_world_slot more_slots[WORLD_PLACES];
    static fxl_world other;
    fxl_world_memory room = world_memory();
    (void)world_start();
    TEST_ASSERT_EQUAL(FXL_OK, fxl_world_recolour(&world, fxl_world_handle(2), 2));
    room.instances = more;
    room.slots = more_slots;
    room.turned_capacity = 0;
    memset(&other, 0x5A, sizeof other);
    memset(more, 0x5A, sizeof more);
    for (room.colour_count = 0; room.colour_count < 2; room.colour_count++) {
        room.colours = room.colour_count > 0 ? world_colours : NULL;
        TEST_ASSERT_EQUAL(FXL_E_INDEX, fxl_world_init(&other, &world.scene, &room));
        TEST_ASSERT_EACH_EQUAL_HEX8(0x5A, &other, sizeof other);
        TEST_ASSERT_EACH_EQUAL_HEX8(0x5A, more, sizeof more);
    }
    TEST_ASSERT_EQUAL(FXL_OK, fxl_world_init(&other, &world.scene, &room));
    TEST_ASSERT_EQUAL(2, fxl_world_instance(&other, fxl_world_handle(2))->recolour);
    TEST_ASSERT_EQUAL(FXL_OK, fxl_world_recolour(&world, fxl_world_handle(2), 0));
    room.colour_count = 0;
    TEST_ASSERT_EQUAL(FXL_OK, fxl_world_init(&other, &world.scene, &room));
}

void test_spawn_and_the_rest_refuse_null(void)
{
    const fxl_instance instance = world_cube_at(0, 5), recoloured = {{0, 0, 0}, 0, 0, 1};
    fxl_handle handle = {0, 0};
    const fxl_handle first = fxl_world_handle(0);
    (void)world_start();
    TEST_ASSERT_EQUAL(FXL_E_ARGUMENT, fxl_world_spawn(NULL, &instance, NULL, &handle));
    TEST_ASSERT_EQUAL(FXL_E_ARGUMENT, fxl_world_spawn(&world, NULL, NULL, &handle));
    TEST_ASSERT_EQUAL(FXL_E_ARGUMENT, fxl_world_spawn(&world, &instance, NULL, NULL));
    TEST_ASSERT_EQUAL(FXL_E_RESERVED, fxl_world_spawn(&world, &recoloured, NULL, &handle));
    TEST_ASSERT_EQUAL(FXL_E_ARGUMENT, fxl_world_remove(NULL, first));
    TEST_ASSERT_EQUAL(FXL_E_ARGUMENT, fxl_world_hide(NULL, first));
    TEST_ASSERT_EQUAL(FXL_E_ARGUMENT, fxl_world_move(NULL, first, &instance.centre));
    TEST_ASSERT_EQUAL(FXL_E_ARGUMENT, fxl_world_move(&world, first, NULL));
    TEST_ASSERT_EQUAL(FXL_E_ARGUMENT, fxl_world_set_placement(NULL, first, NULL));
    TEST_ASSERT_EQUAL(FXL_E_ARGUMENT, fxl_world_set_model(NULL, first, 0));
    TEST_ASSERT_EQUAL(FXL_E_ARGUMENT, fxl_world_set_layer(NULL, first, 0));
    TEST_ASSERT_EQUAL(FXL_E_ARGUMENT, fxl_world_recolour(NULL, first, 0));
    TEST_ASSERT_EQUAL_UINT32(4, world.refused_calls);
    TEST_ASSERT_NULL(fxl_world_instance(NULL, first));
    TEST_ASSERT_NULL(fxl_world_placement(NULL, first));
    TEST_ASSERT_FALSE(fxl_world_is_shown(NULL, first));
}

/* A model that two world_instances show, one of them in colours of its own. */
void test_instances_in_colours_of_their_own(void)
{
    static fxl_world_colours colours;
    static fxl_renderer other;
    const fxl_pose pose = {{0, 0, Q16(-4)}, 0, 0, 0};
    const fxl_instance left = world_cube_at(-3, 3), right = world_cube_at(3, 3);
    (void)world_start();
    for (uint32_t i = 0; i < TINY_INSTANCES; i++) {
        TEST_ASSERT_EQUAL(FXL_OK, fxl_world_hide(&world, fxl_world_handle(i)));
    }
    for (int i = 0; i < 256; i++) {
        world_colours[i] = (uint8_t)(i + 50);
        world_colours[256 + i] = (uint8_t)(i + 100);
    }
    (void)world_spawned(&left, NULL);
    const fxl_handle handle = world_spawned(&right, NULL);
    world_draw(&world_renderer, &pose, world_frames[0]);
    TEST_ASSERT_EQUAL(FXL_OK, fxl_world_recolour(&world, handle, 2));
    world_draw(&world_renderer, &pose, world_frames[1]); /* the renderer was not told of colours */
    TEST_ASSERT_EQUAL_MEMORY(world_frames[0], world_frames[1], sizeof world_frames[0]);
    TEST_ASSERT_EQUAL(FXL_OK, fxl_world_set_colours(&world, &world_renderer, &colours));
    for (uint32_t number = 0; number <= 2; number++) {
        uint32_t changed = 0;
        TEST_ASSERT_EQUAL(FXL_OK, fxl_world_recolour(&world, handle, number));
        world_draw(&world_renderer, &pose, world_frames[1]);
        for (int i = 0; i < WORLD_WIDTH * WORLD_HEIGHT; i++) {
            const bool of_right =
                i % WORLD_WIDTH >= WORLD_WIDTH / 2 && world_frames[0][i] != WORLD_BACKGROUND;
            TEST_ASSERT_EQUAL(world_frames[0][i] + (of_right ? 50 * (int)number : 0),
                              world_frames[1][i]);
            changed += of_right;
        }
        TEST_ASSERT_TRUE(changed > 20);
    }
    TEST_ASSERT_EQUAL(FXL_OK, fxl_world_set_colours(&world, &world_renderer, NULL));
    TEST_ASSERT_NULL(world_renderer.shader);
    TEST_ASSERT_EQUAL(FXL_E_INDEX, fxl_world_set_colours(&world, &other, &colours));
    TEST_ASSERT_EQUAL(FXL_E_ARGUMENT, fxl_world_set_colours(NULL, &world_renderer, &colours));
}

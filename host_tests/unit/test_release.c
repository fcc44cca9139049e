/* SPDX-License-Identifier: MIT */
/* Frames whose scene is released (fxl_frame_release_scene): it changes while they are drawn, and
 * their pixels stay. */
#include "frame_bands.h"
#include "study/targets.h"
#include "choices.h"
#include "world_unit.h"

enum {
    POLYGONS = 12, /* more than any frame of these tests has */
    LIST = POLYGONS * FXL_DISPLAY_LIST_WORDS(8),
    BYTES = WORLD_WIDTH * WORLD_HEIGHT
};

static uint32_t lists[2][LIST];
static fxl_draw_entry orders[2][WORLD_PLACES + 6];
static fxl_renderer renderers[2];
static FXL_ALIGN_8 uint8_t spans[800];
static const fxl_placement tilted = {
    {{644245094, -858993459, 0}, {858993459, 644245094, 0}, {0, 0, FXL_Q2_30_ONE}}, Q16(1.5)};

static void init(int number, const fxl_scene *scene, uint32_t words)
{
    const fxl_lens lens = unit_lens(WORLD_WIDTH, WORLD_HEIGHT);
    const fxl_memory room = {orders[number], WORLD_PLACES + 6, lists[number], words, NULL, 0};
    TEST_ASSERT_EQUAL(FXL_OK, fxl_renderer_init_with(&renderers[number], scene, &lens, &room));
}

static fxl_pose pose_of(uint32_t frame)
{
    return (fxl_pose){{Q16(0.5), Q16(0.25), Q16(-5)}, frame * DEGREES(3), 0, frame * DEGREES(7)};
}

/* Draws the frame that has begun, in bands. */
static void draw(fxl_renderer *by, uint16_t rows, uint8_t *frame)
{
    frame_draw_bands(by, frame, rows, WORLD_BACKGROUND);
}

/* There is no scene to read any more. */
static void expect_no_reads(fxl_renderer *by)
{
    const fxl_scene *scene = by->scene;
    const fxl_pose pose = pose_of(1);
    TEST_ASSERT_EQUAL(FXL_OK, fxl_frame_begin(by, &pose));
    draw(by, 4, world_frames[0]);
    TEST_ASSERT_EQUAL(FXL_OK, fxl_frame_release_scene(by));
    TEST_ASSERT_EQUAL(FXL_OK, fxl_frame_release_scene(by));
    by->scene = NULL;
    draw(by, 4, world_frames[1]);
    TEST_ASSERT_EQUAL_MEMORY(world_frames[0], world_frames[1], BYTES);
    draw(by, WORLD_HEIGHT, world_frames[1]);
    TEST_ASSERT_EQUAL_MEMORY(world_frames[0], world_frames[1], BYTES);
    by->scene = scene;
}

void test_a_released_frame_reads_nothing_of_the_scene(void)
{
    static const choice *const methods[] = {&choice_sorted, &choice_box, &choice_spans,
                                            &choice_spans_box};
    tiny_scene *tiny = world_scene();
    tiny->scene.placements = &tilted;
    tiny->scene.first_turned = 2;
    tiny->scene.placement_code = &fxl_turned_instances;
    for (uint32_t i = 0; i < 8; i++) {
        init(0, &tiny->scene, LIST);
        TEST_ASSERT_EQUAL(FXL_OK, choice_take(&renderers[0], methods[i / 2], spans, sizeof spans));
        tiny->scene.placements = i % 2 ? NULL : &tilted;
        expect_no_reads(&renderers[0]);
    }
}

/* Whatever the list has no room for: a sorted model's faces, an instance, or all. */
void test_a_frame_that_the_list_does_not_hold_is_not_released(void)
{
    const fxl_pose pose = pose_of(1);
    const tiny_scene *tiny = world_scene();
    init(0, &tiny->scene, LIST);
    TEST_ASSERT_EQUAL(FXL_E_ORDER, fxl_frame_release_scene(&renderers[0]));
    TEST_ASSERT_EQUAL(FXL_E_ARGUMENT, fxl_frame_release_scene(NULL));
    TEST_ASSERT_EQUAL(FXL_OK, fxl_frame_begin(&renderers[0], &pose));
    draw(&renderers[0], WORLD_HEIGHT, world_frames[0]);
    const uint32_t used = renderers[0].frame.display_list.used;
    TEST_ASSERT_TRUE(used > 0 && used < LIST);
    for (uint32_t words = 0; words <= used; words++) {
        init(0, &tiny->scene, words);
        TEST_ASSERT_EQUAL(FXL_OK, fxl_frame_begin(&renderers[0], &pose));
        TEST_ASSERT_EQUAL(words < used ? FXL_E_CAPACITY : FXL_OK,
                          fxl_frame_release_scene(&renderers[0]));
        TEST_ASSERT_EQUAL_UINT32(words < used, renderers[0].workspace.counters.refused_calls);
        draw(&renderers[0], 4, world_frames[1]);
        TEST_ASSERT_EQUAL_MEMORY(world_frames[0], world_frames[1], BYTES);
    }
    TEST_ASSERT_EQUAL(FXL_OK, fxl_frame_end(&renderers[0]));
    TEST_ASSERT_EQUAL(FXL_E_ORDER, fxl_frame_release_scene(&renderers[0]));
}

/* A pick would read the scene as it is now. */
void test_a_released_frame_is_not_picked(void)
{
    const fxl_pose pose = pose_of(0);
    fxl_picked picked = {7, 7, 7};
    init(0, &world_scene()->scene, LIST);
    TEST_ASSERT_EQUAL(FXL_OK, fxl_frame_begin(&renderers[0], &pose));
    TEST_ASSERT_EQUAL(FXL_OK, fxl_frame_release_scene(&renderers[0]));
    TEST_ASSERT_EQUAL(FXL_E_ORDER, fxl_pick_face(&renderers[0], 9, 9, &picked));
    TEST_ASSERT_TRUE(picked.instance == 7 && picked.face == 7 && picked.colour == 7);
    TEST_ASSERT_EQUAL(FXL_OK, fxl_frame_begin(&renderers[0], &pose));
    TEST_ASSERT_EQUAL(FXL_OK, fxl_pick_face(&renderers[0], 9, 9, &picked));
}

/* As a frame that was not released. */
void test_a_refused_begin_with_placements_ends_a_released_frame(void)
{
    static fxl_placement placement;
    const fxl_pose pose = pose_of(1);
    tiny_scene *tiny = world_scene();
    placement = tilted;
    tiny->scene.placements = &placement;
    tiny->scene.first_turned = 2;
    tiny->scene.placement_code = &fxl_turned_instances;
    tiny->instances[0].centre.x = Q16(500);
    init(0, &tiny->scene, LIST);
    TEST_ASSERT_EQUAL(FXL_OK, fxl_frame_begin(&renderers[0], &pose));
    draw(&renderers[0], 4, world_frames[0]);
    TEST_ASSERT_EQUAL(FXL_OK, fxl_frame_release_scene(&renderers[0]));
    placement.orientation.x.x ^= 1 << 20;
    tiny->instances[0].centre.x = 0;
    TEST_ASSERT_EQUAL(FXL_E_PLACEMENT, fxl_frame_begin(&renderers[0], &pose));
    TEST_ASSERT_EQUAL(FXL_E_ORDER, fxl_frame_release_scene(&renderers[0]));
    placement = tilted;
    TEST_ASSERT_EQUAL(FXL_OK, fxl_frame_begin(&renderers[0], &pose));
    draw(&renderers[0], 4, world_frames[1]);
    TEST_ASSERT_TRUE(memcmp(world_frames[0], world_frames[1], BYTES) != 0);
}

/* --- a world ------------------------------------------------------------------------------ */

static void start_world(uint32_t words)
{
    (void)world_start();
    TEST_ASSERT_EQUAL(FXL_OK, fxl_world_detach(&world, &world_renderer));
    for (int i = 0; i < 2; i++) {
        init(i, &world.scene, words);
        TEST_ASSERT_EQUAL(FXL_OK, fxl_world_attach(&world, &renderers[i]));
    }
}

/* A change of every kind, so that every place of the table has another instance. */
static void change_world(uint32_t frame)
{
    static fxl_handle made;
    const fxl_handle first = fxl_world_handle(0), second = fxl_world_handle(1);
    const fxl_instance instance = world_cube_at(frame - 3.0, 4);
    const fxl_point there = {Q16(1) - (int32_t)frame * Q16(0.5), Q16(0.5), Q16(3)};
    TEST_ASSERT_EQUAL(frame > 0 ? FXL_OK : FXL_E_STALE,
                      fxl_world_remove(&world, frame > 0 ? made : (fxl_handle){0, 0}));
    made = world_spawned(&instance, frame % 2 ? &tilted : NULL);
    TEST_ASSERT_EQUAL(FXL_OK, fxl_world_move(&world, first, &there));
    TEST_ASSERT_EQUAL(FXL_OK, fxl_world_set_placement(&world, first, frame % 2 ? NULL : &tilted));
    TEST_ASSERT_EQUAL(FXL_OK,
                      frame % 2 ? fxl_world_hide(&world, second) : fxl_world_show(&world, second));
    TEST_ASSERT_EQUAL(FXL_OK, fxl_world_set_model(&world, fxl_world_handle(2), frame % 2));
    TEST_ASSERT_EQUAL(FXL_OK, fxl_world_set_layer(&world, first, (uint8_t)(frame % 3)));
    TEST_ASSERT_EQUAL(FXL_OK, fxl_world_recolour(&world, first, frame % 3));
}

/* Between the bands of frame n, the world changes and frame n + 1 begins in the other renderer. */
/* world 2.3e, 2.3g */
void test_a_world_changes_while_a_released_frame_is_drawn(void)
{
    static uint8_t frame_before[BYTES];
    static fxl_world_colours colours[2];
    start_world(LIST);
    for (int i = 0; i < 512; i++) {
        world_colours[i] = (uint8_t)(i + 50);
    }
    for (int i = 0; i < 2; i++) {
        TEST_ASSERT_EQUAL(FXL_OK, fxl_world_set_colours(&world, &renderers[i], &colours[i]));
    }
    for (uint32_t frame = 0; frame < 8; frame++) {
        fxl_renderer *drawn = &renderers[frame % 2], *next = &renderers[(frame + 1) % 2];
        const fxl_pose pose = pose_of(frame), pose_after = pose_of(frame + 1);
        TEST_ASSERT_EQUAL(FXL_OK, fxl_frame_begin(drawn, &pose));
        draw(drawn, WORLD_HEIGHT, world_frames[0]); /* undisturbed */
        TEST_ASSERT_EQUAL(FXL_OK, fxl_frame_release_scene(drawn));
        for (uint16_t first = 0; first < WORLD_HEIGHT; first = (uint16_t)(first + 4)) {
            const fxl_band band =
                UNIT_BAND(world_frames[1] + first * WORLD_WIDTH, WORLD_WIDTH, first, 4);
            if (first == 8) {
                change_world(frame);
                TEST_ASSERT_EQUAL(FXL_OK, fxl_frame_begin(next, &pose_after));
            }
            fxl_fill_band(&band, WORLD_BACKGROUND);
            TEST_ASSERT_EQUAL(FXL_OK, fxl_frame_draw(drawn, &band));
        }
        TEST_ASSERT_EQUAL_MEMORY(world_frames[0], world_frames[1], BYTES);
        TEST_ASSERT_TRUE(memcmp(frame_before, world_frames[0], BYTES) != 0);
        memcpy(frame_before, world_frames[0], BYTES);
        TEST_ASSERT_EQUAL(FXL_OK, fxl_frame_release_scene(next));
    }
    TEST_ASSERT_EQUAL_UINT32(1, world.refused_calls); /* the stale handle */
}

/* A frame that is not wholly in its list holds changes off, as does one that was not released. */
/* world 2.3h */
void test_a_world_waits_for_a_frame_that_reads_it(void)
{
    const fxl_handle first = fxl_world_handle(0);
    const fxl_pose pose = pose_of(1);
    for (uint32_t words = 0; words <= LIST; words += LIST) {
        start_world(words);
        for (int i = 0; i < 2; i++) {
            TEST_ASSERT_EQUAL(FXL_OK, fxl_frame_begin(&renderers[i], &pose));
        }
        TEST_ASSERT_EQUAL(words > 0 ? FXL_OK : FXL_E_CAPACITY,
                          fxl_frame_release_scene(&renderers[0]));
        TEST_ASSERT_EQUAL(FXL_E_ORDER, fxl_world_remove(&world, first)); /* renderers[1] reads */
        TEST_ASSERT_EQUAL(FXL_OK, fxl_frame_end(&renderers[1]));
        TEST_ASSERT_EQUAL(words > 0 ? FXL_OK : FXL_E_ORDER, fxl_world_remove(&world, first));
        TEST_ASSERT_EQUAL(FXL_OK, fxl_frame_begin(&renderers[0], &pose)); /* it reads again */
        TEST_ASSERT_EQUAL(FXL_E_ORDER, fxl_world_hide(&world, fxl_world_handle(1)));
    }
}

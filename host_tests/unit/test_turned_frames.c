/* SPDX-License-Identifier: MIT */
/* Turned instances in a renderer: whole frames, with every clipper and method. */
#include "choices.h"
#include "clippers_list.h"
#include "frame_bands.h"
#include "study/study.h"
#include "scene/face_bounds.h"
#include "tiny.h"
#include "tiny_frames.h"

enum {
    WIDTH = 48,
    HEIGHT = 32,
    PIXELS = WIDTH * HEIGHT,
    BACKGROUND = 200,
    LIST_WORDS = 40 * FXL_DISPLAY_LIST_WORDS(8),
    SPANS = 4096
};

static FXL_ALIGN_8 fxl_clipper_workspace room;
static FXL_ALIGN_8 uint8_t span_room[SPANS];
static uint8_t frames[2][PIXELS], third[PIXELS];
static fxl_draw_entry order[64];
static uint32_t list[LIST_WORDS];
static fxl_cached_vertex cache[9];
static fxl_renderer renderer;
static fxl_placement placements[TINY_INSTANCES];
static tiny_scene *tiny;

/* The tiny scene, of which the instances from first on are turned. */
static void make(uint32_t first)
{
    tiny = tiny_make();
    tiny_place_from(tiny, placements, first);
}

static void start(int which, uint32_t list_words, uint32_t entries, bool front_to_back)
{
    const fxl_memory memory = {order, 64, list, list_words, cache, entries};
    const fxl_clipper *clipper = clipper_number(which);
    tiny_start(&renderer, tiny, WIDTH, HEIGHT, &memory);
    TEST_ASSERT_EQUAL(FXL_OK,
                      fxl_renderer_set_clipper(&renderer, clipper, &room, clipper->workspace_size));
    if (front_to_back) {
        TEST_ASSERT_EQUAL(FXL_OK, choice_take(&renderer, &choice_spans, span_room, SPANS));
    }
}

static void draw(const fxl_pose *pose, uint32_t rows, uint8_t *frame)
{
    frame_draw_pose(&renderer, pose, frame, rows, BACKGROUND);
}

/* Placements that leave the cubes about as large as they are. */
static void place_all(void)
{
    for (uint32_t i = 0; i < TINY_INSTANCES; i++) {
        placements[i].orientation = unit_orientation();
        placements[i].scale = unit_between(0, 2) == 0 ? Q16(1) : unit_between(Q16(0.25), Q16(4));
    }
}

static fxl_counters counters_but_spilled(void)
{
    fxl_counters counters = renderer.workspace.counters;
    counters.spilled = counters.split_bands = 0;
    return counters;
}

/* Without a placement the bits are those of an instance that has none: the same pixels and
 * counters, but for the count of the rounded. */
/* SPEC 8.2i */
void test_placements_that_turn_nothing(void)
{
    for (int round = 0; round < UNIT_REPEAT / 100; round++) {
        const fxl_pose pose = tiny_pose_between();
        const bool keyed = unit_between(0, 1);
        for (int which = 0; which < CLIPPERS + 2; which++) {
            const uint32_t words = (uint32_t)unit_between(0, LIST_WORDS);
            const bool front_to_back = unit_between(0, 1);
            const uint32_t first = (uint32_t)unit_between(0, TINY_INSTANCES - 1);
            const uint32_t rows = (uint32_t)unit_between(1, HEIGHT);
            fxl_counters counters[2];
            for (int turned = 0; turned < 2; turned++) {
                make(turned ? first : TINY_INSTANCES);
                if (!keyed) {
                    tiny->scene.face_bounds = NULL;
                    tiny->scene.face_bounds_count = 0;
                }
                start(which, words, 9, front_to_back);
                draw(&pose, rows, frames[turned]);
                counters[turned] = renderer.workspace.counters;
                counters[turned].split_bands = 0;
            }
            TEST_ASSERT_EQUAL_MEMORY(frames[0], frames[1], PIXELS);
            TEST_ASSERT_EQUAL_UINT16(0, counters[0].rounded);
            TEST_ASSERT_TRUE(clipper_number(which)->by_points
                                 ? counters[1].rounded <= TINY_INSTANCES
                                 : counters[1].rounded == 0);
            counters[1].rounded = 0;
            TEST_ASSERT_EQUAL_MEMORY(&counters[0], &counters[1], sizeof counters[0]);
        }
    }
}

/* Bands, list and cache change no pixel and no counter. */
void test_bands_of_turned_instances(void)
{
    for (int round = 0; round < UNIT_REPEAT / 100; round++) {
        const fxl_pose pose = tiny_pose_between();
        make((uint32_t)unit_between(0, TINY_INSTANCES - 1));
        place_all();
        for (int which = 0; which < CLIPPERS + 2; which++) {
            start(which, LIST_WORDS, 9, false);
            draw(&pose, HEIGHT, frames[0]);
            const fxl_counters counters = counters_but_spilled();
            TEST_ASSERT_EQUAL_UINT32(counters.in, counters.backfacing + counters.outside +
                                                      counters.degenerate + counters.refused +
                                                      counters.drawn);
            TEST_ASSERT_EQUAL_UINT32(0, counters.refused);
            start(which, (uint32_t)unit_between(0, 60), (uint32_t)unit_between(0, 9), false);
            draw(&pose, (uint32_t)unit_between(1, HEIGHT), frames[1]);
            TEST_ASSERT_EQUAL_MEMORY(frames[0], frames[1], PIXELS);
            const fxl_counters again = counters_but_spilled();
            TEST_ASSERT_EQUAL_MEMORY(&counters, &again, sizeof counters);
        }
    }
}

/* So small and far away that its eye has another unit, and seen along an axis of the cube, where
 * the sides face the eye or not by a hair. */
void test_facing_of_what_is_small_and_far(void)
{
    uint32_t backfacing = 0;
    const fxl_pose pose = {.position = {0, 0, 0}};
    for (int round = 0; round < UNIT_REPEAT / 10; round++) {
        make(0);
        tiny->scene.instance_count = 1;
        fxl_instance *cube = &tiny->instances[0];
        placements[0].scale = FXL_SCALE_MIN;
        cube->centre.z = unit_between(Q16(60), Q16(400));
        cube->centre.x = unit_between(-1024, 1024); /* four units of the model */
        cube->centre.y = unit_between(-1024, 1024);
        start(CLIPPERS, LIST_WORDS, 9, false);
        draw(&pose, HEIGHT, frames[0]);
        uint32_t wanted = 0;
        for (uint32_t i = 0; i < 6; i++) {
            const fxl_face *face = &tiny->faces[i];
            wanted += !fxl_placement_is_front(&placements[0], &cube->centre, &face->normal,
                                              fxl_face_height(tiny->vertices, face));
        }
        TEST_ASSERT_EQUAL_UINT32(wanted, renderer.workspace.counters.backfacing);
        TEST_ASSERT_EQUAL_UINT32(6, renderer.workspace.counters.in);
        backfacing += wanted;
    }
    TEST_ASSERT_TRUE(backfacing > UNIT_REPEAT / 10 * 3 && backfacing < UNIT_REPEAT / 10 * 5);
}

/* Front to back, the frame is that of the reverse order: cubes that are apart look the same. */
void test_front_to_back(void)
{
    int differing = 0;
    for (int round = 0; round < UNIT_REPEAT / 100; round++) {
        const fxl_pose pose = tiny_pose_between();
        make(0);
        place_all();
        start(CLIPPERS, LIST_WORDS, 9, false);
        draw(&pose, HEIGHT, frames[0]);
        start(CLIPPERS, (uint32_t)unit_between(0, LIST_WORDS), 9, true);
        draw(&pose, (uint32_t)unit_between(1, HEIGHT), frames[1]);
        for (int i = 0; i < PIXELS; i++) {
            differing += frames[0][i] != frames[1][i];
        }
    }
    TEST_ASSERT_EQUAL(0, differing);
}

/* The clippers' outlines are less than a hundredth of a pixel apart. */
void test_clippers_agree(void)
{
    const int rounds = UNIT_REPEAT / 100;
    int differing = 0, drawn = 0;
    for (int round = 0; round < rounds; round++) {
        const fxl_pose pose = tiny_pose_between();
        make(0);
        place_all();
        start(CLIPPERS, LIST_WORDS, 9, false);
        draw(&pose, HEIGHT, frames[0]);
        for (int which = 0; which < CLIPPERS + 2; which++) {
            start(which, LIST_WORDS, 9, false);
            draw(&pose, HEIGHT, frames[1]);
            TEST_ASSERT_EQUAL(
                clipper_number(which)->by_points != NULL,
                renderer.workspace.counters.rounded > 0 ||
                    (clipper_number(which)->by_points && renderer.frame.visible_count == 0));
            for (int i = 0; i < PIXELS; i++) {
                differing += frames[0][i] != frames[1][i];
                drawn += frames[1][i] != BACKGROUND;
            }
        }
    }
    TEST_ASSERT_TRUE(drawn > rounds * PIXELS / 4);
    TEST_ASSERT_TRUE(differing <= 1 + rounds / 4);
}

/* --- misuse --------------------------------------------------------------------------------- */

static void expect_refused(fxl_status status)
{
    const fxl_pose pose = {.position = {0, 0, Q16(-5)}};
    const uint32_t refused = renderer.workspace.counters.refused_calls;
    TEST_ASSERT_EQUAL(status, fxl_frame_begin(&renderer, &pose));
    TEST_ASSERT_EQUAL_UINT32(refused + 1, renderer.workspace.counters.refused_calls);
}

static bool is_in_sight(uint32_t number)
{
    for (uint32_t i = 0; i < renderer.frame.visible_count; i++) {
        if (order[i].index == number) {
            return true;
        }
    }
    return false;
}

/* An orientation is refused where its instance is in sight, whether the frame before had its rows
 * measured or not. */
/* SPEC 8.1c, collide 2.3c */
void test_orientations_in_sight_are_checked(void)
{
    const uint32_t rounds = UNIT_REPEAT / 1000 + 60;
    uint32_t in_sight = 0, measured = 0;
    for (uint32_t round = 0; round < rounds; round++) {
        fxl_pose poses[2];
        poses[0] = tiny_pose_between();
        poses[1] = tiny_pose_between();
        const uint32_t number = round % TINY_INSTANCES;
        make(round % 2);
        place_all();
        start(CLIPPERS, round % 3 * 20, 9, false);
        draw(&poses[1], 5, frames[0]);
        const bool seen = is_in_sight(number) && number >= tiny->scene.first_turned;
        draw(&poses[0], 5, third);
        measured += seen && renderer.frame.state == FXL_FRAME_MEASURED;
        const fxl_camera before = renderer.frame.view.camera;
        fxl_placement *placement =
            &placements[number -
                        (number < tiny->scene.first_turned ? 0 : tiny->scene.first_turned)];
        const fxl_placement good = *placement;
        if (number >= tiny->scene.first_turned) {
            placement->orientation.x.x ^= 1 << 20;
        }
        TEST_ASSERT_EQUAL(seen ? FXL_E_PLACEMENT : FXL_OK, fxl_frame_begin(&renderer, &poses[1]));
        if (seen) { /* what is asked of the view is of the picture that was drawn last */
            TEST_ASSERT_EQUAL_MEMORY(&before, &renderer.frame.view.camera, sizeof before);
            TEST_ASSERT_EQUAL(FXL_FRAME_NONE, renderer.frame.state);
        } else {
            frame_draw_bands(&renderer, third, 5, BACKGROUND);
            TEST_ASSERT_EQUAL_MEMORY(frames[0], third, PIXELS);
        }
        *placement = good;
        in_sight += seen;
        draw(&poses[1], 5, third);
        TEST_ASSERT_EQUAL_MEMORY(frames[0], third, PIXELS);
    }
    /* A library for few bytes measures no rows. */
    TEST_ASSERT_TRUE(in_sight > 0 && in_sight < rounds && (measured > 0 || FXL_IS_SMALL));
    make(0);
    start(CLIPPERS, 0, 9, false);
    placements[0].orientation.x.x = placements[1].orientation.x.x = placements[2].orientation.x.x =
        0;
    expect_refused(FXL_E_PLACEMENT);
    TEST_ASSERT_EQUAL(FXL_FRAME_NONE, renderer.frame.state);
}

/* Instances may come and go, the turned ones at the end of the table. */
void test_the_number_of_instances_may_change(void)
{
    const fxl_pose pose = {.position = {0, 0, Q16(-6)}};
    make(1);
    start(CLIPPERS, LIST_WORDS, 9, false);
    for (uint32_t count = 0; count <= TINY_INSTANCES; count++) {
        tiny->scene.instance_count = count;
        draw(&pose, HEIGHT, frames[0]);
        TEST_ASSERT_EQUAL_UINT32(6 * count, renderer.workspace.counters.in);
    }
}

static void expect_fault(fxl_status status, const char *what, uint32_t index)
{
    fxl_scene_fault fault = {"", 99};
    tiny->scene.draw_list_needed = 77;
    TEST_ASSERT_EQUAL(status, fxl_scene_check(&tiny->scene, &fault));
    TEST_ASSERT_EQUAL_STRING(what, fault.what);
    TEST_ASSERT_EQUAL_UINT32(index, fault.index);
    TEST_ASSERT_EQUAL_UINT32(77, tiny->scene.draw_list_needed);
}

void test_the_check_of_a_scene_with_placements(void)
{
    make(1);
    placements[1].scale = FXL_SCALE_MAX + 1;
    expect_fault(FXL_E_RANGE, "instance", 2);
    placements[1].scale = FXL_SCALE_MAX;
    placements[0].orientation.x.x = 0;
    expect_fault(FXL_E_PLACEMENT, "instance", 1);
    make(0);
    tiny->instances[0].centre.y = Q16(8190); /* a corner would be outside if it stood still */
    expect_fault(FXL_E_RANGE, "instance", 0);
    placements[0].scale = Q16(0.5);
    TEST_ASSERT_EQUAL(FXL_OK, fxl_scene_check(&tiny->scene, NULL));
    tiny->scene.placement_code = NULL;
    expect_fault(FXL_E_ARGUMENT, "placement table", 0);
    TEST_ASSERT_EQUAL(FXL_OK, fxl_scene_check_all(&tiny->scene, NULL));
    TEST_ASSERT_EQUAL_PTR(&fxl_turned_instances, tiny->scene.placement_code);
    placements[0].scale = 0;
    tiny->scene.placement_code = NULL;
    TEST_ASSERT_EQUAL(FXL_E_RANGE, fxl_scene_check_all(&tiny->scene, NULL));
    TEST_ASSERT_NULL(tiny->scene.placement_code);
}

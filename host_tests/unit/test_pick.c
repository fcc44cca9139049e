/* SPDX-License-Identifier: MIT */
/* The face under a pixel against the frame that was drawn, and points of the world against the
 * pixels that show them. */
#include <math.h>

#include "choices.h"
#include "frame_bands.h"
#include "tiny.h"
#include "tiny_frames.h"
#include "study/clippers.h"
#include "study/targets.h"
#include "study/span_buffer.h"

enum {
    WIDTH = 24,
    HEIGHT = 16,
    BACKGROUND = 200,
    WORDS = 60 /* three faces or so */
};

static uint8_t whole[HEIGHT][WIDTH], alone[TINY_INSTANCES][HEIGHT][WIDTH], again[HEIGHT][WIDTH];
static uint32_t list[WORDS];
static fxl_draw_entry order[TINY_INSTANCES + 6];
static fxl_renderer renderer;
static uint64_t spans[FXL_SPAN_BUFFER_BYTES_LEAST(WIDTH, HEIGHT) / 8 + 1];
static tiny_scene *tiny;

static void start(uint32_t words, const fxl_clipper *clipper, const choice *visibility)
{
    fxl_lens lens = unit_lens(WIDTH, HEIGHT);
    const fxl_memory memory = {order, TINY_INSTANCES + 6, words > 0 ? list : NULL, words, NULL, 0};
    TEST_ASSERT_EQUAL(FXL_OK, fxl_scene_check(&tiny->scene, NULL));
    TEST_ASSERT_EQUAL(FXL_OK, fxl_renderer_init_bare(&renderer, &tiny->scene, &lens, &memory));
    TEST_ASSERT_EQUAL(FXL_OK, fxl_renderer_set_clipper(&renderer, clipper, NULL, 0));
    TEST_ASSERT_EQUAL(FXL_OK, choice_take(&renderer, visibility, spans, sizeof spans));
}

static void draw(uint8_t frame[HEIGHT][WIDTH])
{
    frame_draw_bands(&renderer, frame[0], 4, BACKGROUND);
}

/* Each instance in a frame of its own. */
static void draw_alone(const fxl_pose *pose)
{
    const fxl_instance first = tiny->instances[0];
    for (uint32_t i = 0; i < TINY_INSTANCES; i++) {
        tiny->instances[0] = i == 0 ? first : tiny->instances[i];
        tiny->scene.instance_count = 1;
        start(0, &fxl_clipper_view, &choice_sorted);
        TEST_ASSERT_EQUAL(FXL_OK, fxl_frame_begin(&renderer, pose));
        draw(alone[i]);
        tiny->instances[0] = first;
        tiny->scene.instance_count = TINY_INSTANCES;
    }
}

static uint32_t expect_pixel(uint32_t x, uint32_t y)
{
    fxl_picked picked;
    TEST_ASSERT_EQUAL(FXL_OK, fxl_pick_face(&renderer, (uint16_t)x, (uint16_t)y, &picked));
    if (picked.instance == FXL_PICK_NONE) {
        TEST_ASSERT_EQUAL_UINT8(BACKGROUND, whole[y][x]);
        TEST_ASSERT_TRUE(picked.face == 0 && picked.colour == 0);
        return 0;
    }
    const fxl_model *model = &tiny->models[tiny->instances[picked.instance].model];
    TEST_ASSERT_TRUE(picked.face < model->face_count);
    TEST_ASSERT_EQUAL_UINT8(whole[y][x], picked.colour);
    TEST_ASSERT_EQUAL_UINT8(whole[y][x], tiny->faces[model->first_face + picked.face].material);
    TEST_ASSERT_EQUAL_UINT8(whole[y][x], alone[picked.instance][y][x]);
    return 1u << picked.instance;
}

/* Before, between and after the bands; with a display list that holds some of the faces, or none.
 */
/* pick 2.5, 2.1a, 2.2a-d, accuracy 1.2n */
void test_a_pick_is_the_pixel_that_was_drawn(void)
{
    static const choice *const methods[] = {&choice_sorted, &choice_box, &choice_spans,
                                            &choice_spans_box};
    static const fxl_clipper *const clippers[] = {&fxl_clipper_view, &fxl_clipper_world};
    uint32_t seen = 0;
    for (int round = 0; round < UNIT_REPEAT / 100; round++) {
        const fxl_pose pose = tiny_pose_about();
        const uint32_t words = unit_random() % 2 ? WORDS : 0;
        tiny = tiny_make();
        tiny->instances[0].model = unit_random() % 2; /* several with an order of their own */
        tiny->instances[2].model = unit_random() % 2;
        draw_alone(&pose);
        start(words, clippers[unit_random() % 2], methods[unit_random() % 4]);
        TEST_ASSERT_EQUAL(FXL_OK, fxl_frame_begin(&renderer, &pose));
        draw(whole);
        const fxl_counters before = renderer.workspace.counters;
        for (int i = 0; i < 12; i++) {
            seen |= expect_pixel(unit_random() % WIDTH, unit_random() % HEIGHT);
        }
        TEST_ASSERT_EQUAL_MEMORY(&before, &renderer.workspace.counters, sizeof before);
        draw(again);
        TEST_ASSERT_EQUAL_MEMORY(whole, again, sizeof whole);
    }
    TEST_ASSERT_EQUAL_UINT32(7, seen);
}

/* pick 2.1 */
void test_picks_that_cannot_be_are_refused(void)
{
    fxl_picked picked = {1, 2, 3};
    const fxl_pose pose = {{0, 0, Q16(-4)}, 0, 0, 0};
    tiny = tiny_make();
    start(0, &fxl_clipper_view, &choice_sorted);
    TEST_ASSERT_EQUAL(FXL_E_ORDER, fxl_pick_face(&renderer, 0, 0, &picked));
    TEST_ASSERT_EQUAL(FXL_OK, fxl_frame_begin(&renderer, &pose));
    TEST_ASSERT_EQUAL(FXL_E_ARGUMENT, fxl_pick_face(NULL, 0, 0, &picked));
    TEST_ASSERT_EQUAL(FXL_E_ARGUMENT, fxl_pick_face(&renderer, 0, 0, NULL));
    TEST_ASSERT_EQUAL(FXL_E_RANGE, fxl_pick_face(&renderer, WIDTH, 0, &picked));
    TEST_ASSERT_EQUAL(FXL_E_RANGE, fxl_pick_face(&renderer, 0, HEIGHT, &picked));
    TEST_ASSERT_EQUAL_UINT32(4, renderer.workspace.counters.refused_calls);
    TEST_ASSERT_TRUE(picked.instance == 1 && picked.face == 2 && picked.colour == 3);
}

/* By the definition, in double. */
/* pick 1.1b, 1.2b, 1.3a */
void test_points_of_the_world_are_where_double_says(void)
{
    uint32_t seen = 0;
    fxl_view view;
    for (int i = 0; i < UNIT_REPEAT / 10; i++) {
        const fxl_lens lens = unit_any_lens();
        const fxl_pose pose = unit_pose();
        fxl_point point = unit_point(FXL_COORDINATE_MAX);
        fxl_screen_place place;
        fxl_view_set_lens(&view, &lens);
        TEST_ASSERT_EQUAL(FXL_OK, fxl_view_set_pose(&view, &pose));
        if (unit_random() % 2) { /* before the eye */
            const int32_t far_off = unit_between(0, Q16(300));
            const fxl_direction *forward = &view.camera.axes.forward;
            point.x = pose.position.x + (fxl_q16_16)((int64_t)far_off * forward->x >> 30);
            point.y = pose.position.y + (fxl_q16_16)((int64_t)far_off * forward->y >> 30);
            point.z = pose.position.z + (fxl_q16_16)((int64_t)far_off * forward->z >> 30);
        }
        const fxl_status status = fxl_find_on_screen(&view, &point, &place);
        if (status == FXL_E_RANGE) {
            continue; /* beyond the end of the world */
        }
        fxl_view_point at;
        fxl_transform_point(&view.camera, &point, &at);
        TEST_ASSERT_EQUAL(FXL_OK, status);
        TEST_ASSERT_TRUE(place.depth == at.z);
        seen |= 1u << place.place;
        const double z = (double)at.z, unit = 70368744177664.0;
        const double x = lens.width * 32768.0 + lens.focal * ((double)at.x / z);
        const double y = lens.height * 32768.0 - lens.focal * ((double)at.y / z);
        const double near_z = (lens.near_z + (double)lens.inset) / 65536.0;
        const double far_z = (lens.far_z - (double)lens.inset) / 65536.0;
        if (place.place == FXL_POINT_NEAR) {
            TEST_ASSERT_TRUE(z / unit < near_z && place.at.x == 0 && place.at.y == 0);
            continue;
        }
        TEST_ASSERT_TRUE(z / unit >= near_z);
        if (place.place == FXL_POINT_BEYOND) {
            TEST_ASSERT_TRUE(fabs(x) > 268369919 || fabs(y) > 268369919); /* 4095 pixels - 1 */
            continue;
        }
        TEST_ASSERT_NEAR(place.at.x, x, 0.64);
        TEST_ASSERT_NEAR(place.at.y, y, 0.64);
        const bool on_screen = place.at.x >= 0 && place.at.x < lens.width * 65536 &&
                               place.at.y >= 0 && place.at.y < lens.height * 65536;
        TEST_ASSERT_EQUAL(on_screen && z / unit <= far_z, place.place == FXL_POINT_VISIBLE);
    }
    TEST_ASSERT_EQUAL_UINT32(15, seen);
}

/* The last places on a screen, and the first off it. */
/* pick 1.3b */
void test_the_edge_of_the_screen(void)
{
    const fxl_pose pose = {{0, 0, Q16(-5)}, 0, 0, 0};
    const fxl_lens lens = unit_lens(WIDTH, HEIGHT);
    uint32_t seen[2] = {0, 0};
    fxl_view view;
    fxl_view_set_lens(&view, &lens);
    TEST_ASSERT_EQUAL(FXL_OK, fxl_view_set_pose(&view, &pose));
    for (int32_t unit = -40; unit <= 40; unit++) {
        for (int axis = 0; axis < 4; axis++) {
            const int32_t edge =
                (int32_t)((axis % 2 ? HEIGHT : WIDTH) * 32768 * (int64_t)Q16(5) / lens.focal);
            const int32_t at = axis < 2 ? edge + unit : -edge + unit;
            const fxl_point point = {axis % 2 ? 0 : at, axis % 2 ? at : 0, 0};
            fxl_screen_place place;
            TEST_ASSERT_EQUAL(FXL_OK, fxl_find_on_screen(&view, &point, &place));
            const bool is_on = place.at.x >= 0 && place.at.x < Q16(WIDTH) && place.at.y >= 0 &&
                               place.at.y < Q16(HEIGHT);
            TEST_ASSERT_EQUAL(is_on ? FXL_POINT_VISIBLE : FXL_POINT_OFF_SCREEN, place.place);
            seen[is_on]++;
        }
    }
    TEST_ASSERT_TRUE(seen[0] > 100 && seen[1] > 100);
}

/* pick 1.3b */
/* As far away as the focal length, a unit is a pixel. */
void test_points_on_the_edges_themselves(void)
{
    static const int32_t ways[][2] = {{-1, 0}, {0, 1}, {1, 0}, {0, -1}};
    const fxl_pose pose = {{0, 0, 0}, 0, 0, 0};
    const fxl_lens lens = unit_lens(WIDTH, HEIGHT);
    fxl_view view;
    fxl_view_set_lens(&view, &lens);
    TEST_ASSERT_EQUAL(FXL_OK, fxl_view_set_pose(&view, &pose));
    for (int i = 0; i < 4; i++) {
        const fxl_point point = {ways[i][0] * WIDTH * 32768, ways[i][1] * HEIGHT * 32768, lens.focal};
        fxl_screen_place place;
        TEST_ASSERT_EQUAL(FXL_OK, fxl_find_on_screen(&view, &point, &place));
        TEST_ASSERT_EQUAL_INT32((ways[i][0] + 1) * WIDTH * 32768, place.at.x);
        TEST_ASSERT_EQUAL_INT32((1 - ways[i][1]) * HEIGHT * 32768, place.at.y);
        TEST_ASSERT_EQUAL(i < 2 ? FXL_POINT_VISIBLE : FXL_POINT_OFF_SCREEN, place.place);
    }
}

void test_a_vertex_is_where_its_face_begins(void)
{
    const fxl_pose pose = {{0, 0, Q16(-5)}, 0, 0, 0};
    const fxl_point centre = {0, 0, 0}, behind = {0, 0, Q16(-5)}, far_away = {0, 0, Q16(1000)};
    fxl_lens lens = unit_lens(WIDTH, HEIGHT);
    fxl_screen_place place = {{1, 2}, 3, 9};
    fxl_view view;
    fxl_view_set_lens(&view, &lens);
    TEST_ASSERT_EQUAL(FXL_E_ORDER, fxl_find_on_screen(&view, &centre, &place));
    TEST_ASSERT_EQUAL(FXL_OK, fxl_view_set_pose(&view, &pose));
    TEST_ASSERT_EQUAL(FXL_E_ARGUMENT, fxl_find_on_screen(NULL, &centre, &place));
    TEST_ASSERT_EQUAL(FXL_E_ARGUMENT, fxl_find_on_screen(&view, NULL, &place));
    TEST_ASSERT_EQUAL(FXL_E_ARGUMENT, fxl_find_on_screen(&view, &centre, NULL));
    const fxl_point outside = {FXL_COORDINATE_MAX + 1, 0, 0};
    TEST_ASSERT_EQUAL(FXL_E_RANGE, fxl_find_on_screen(&view, &outside, &place));
    TEST_ASSERT_TRUE(place.at.x == 1 && place.at.y == 2 && place.depth == 3 && place.place == 9);
    TEST_ASSERT_EQUAL(FXL_OK, fxl_find_on_screen(&view, &centre, &place));
    TEST_ASSERT_EQUAL_INT32(WIDTH * 32768, place.at.x);
    TEST_ASSERT_EQUAL_INT32(HEIGHT * 32768, place.at.y);
    TEST_ASSERT_EQUAL(FXL_POINT_VISIBLE, place.place);
    TEST_ASSERT_EQUAL(FXL_OK, fxl_find_on_screen(&view, &behind, &place));
    TEST_ASSERT_EQUAL(FXL_POINT_NEAR, place.place);
    TEST_ASSERT_EQUAL(FXL_OK, fxl_find_on_screen(&view, &far_away, &place));
    TEST_ASSERT_EQUAL(FXL_POINT_OFF_SCREEN, place.place);
}

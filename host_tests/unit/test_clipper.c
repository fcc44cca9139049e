/* SPDX-License-Identifier: MIT */
/* The two clippers under their treaty, alone and in a renderer. */
#include "tiny.h"

enum {
    WIDTH = 48,
    HEIGHT = 32,
    PIXELS = WIDTH * HEIGHT,
    BACKGROUND = 200,
    LIST_WORDS = 18 * FXL_LIST_WORDS(8) /* all faces of the scene, whole or cut */
};

static const fxl_clipper clippers[] = {fxl_clip_by_view, fxl_clip_by_world};

static fxl_view random_view(fxl_q16_16 reach)
{
    fxl_view view;
    fxl_pose pose = unit_pose();
    pose.position = unit_point(reach);
    view.lens = unit_lens(WIDTH, HEIGHT);
    TEST_ASSERT_EQUAL(FXL_OK, fxl_camera_from_pose(&pose, &view.camera));
    fxl_frustum_from_camera(&view.camera, &view.lens, &view.frustum);
    fxl_view_frustum_from_lens(&view.lens, &view.view_frustum);
    return view;
}

/* Small and near the view's middle, or anywhere. */
static fxl_polygon random_triangle(const fxl_view *view)
{
    fxl_polygon polygon = {.colour = (uint8_t)unit_random(), .count = 3};
    const fxl_direction *ahead = &view->camera.forward;
    const fxl_point *eye = &view->camera.position;
    int depth = unit_between(1, 60);
    fxl_q16_16 size = unit_between(1, depth * 60000);
    bool anywhere = unit_random() % 8 == 0;
    for (int i = 0; i < 3; i++) {
        fxl_point off = unit_point(anywhere ? Q16(8000) : size);
        polygon.vertices[i].position = anywhere
                                           ? off
                                           : (fxl_point){eye->x + (ahead->x >> 14) * depth + off.x,
                                                         eye->y + (ahead->y >> 14) * depth + off.y,
                                                         eye->z + (ahead->z >> 14) * depth + off.z};
        polygon.vertices[i].u = unit_between(0, Q16(64));
        polygon.vertices[i].v = unit_between(0, Q16(64));
    }
    return polygon;
}

static bool is_kept(fxl_clip_result result)
{
    return result == FXL_CLIP_INSIDE || result == FXL_CLIP_CUT;
}

/* What the treaty says of *result: within work, or null. */
static void expect_treaty(fxl_clip_result outcome, const fxl_clipper_work *work,
                          const fxl_view_polygon *result, const fxl_polygon *polygon)
{
    if (!is_kept(outcome)) {
        TEST_ASSERT_NULL(result);
        return;
    }
    const char *first = (const char *)work, *at = (const char *)result;
    TEST_ASSERT_TRUE(at >= first && at + sizeof *result <= first + sizeof *work);
    TEST_ASSERT_EQUAL(polygon->colour, result->colour);
    TEST_ASSERT_TRUE(result->count >= 3 && result->count <= FXL_POLYGON_CAPACITY);
}

static void expect_transformed(const fxl_view *view, const fxl_polygon *polygon,
                               const fxl_view_polygon *result)
{
    static fxl_view_polygon expected;
    fxl_transform_polygon(&view->camera, polygon, &expected);
    TEST_ASSERT_EQUAL(expected.count, result->count);
    for (int i = 0; i < expected.count; i++) {
        TEST_ASSERT_EQUAL_MEMORY(&expected.vertices[i], &result->vertices[i],
                                 sizeof expected.vertices[i]);
    }
}

void test_a_polygon_inside_is_transformed_by_both(void)
{
    static fxl_clipper_work work;
    int inside = 0, cut = 0, gone = 0;
    for (int i = 0; i < UNIT_REPEAT / 4; i++) {
        fxl_view view = random_view(Q16(100));
        fxl_polygon polygon = random_triangle(&view);
        for (int which = 0; which < 2; which++) {
            const fxl_view_polygon *result = (const fxl_view_polygon *)&polygon;
            fxl_clip_result outcome = clippers[which](&polygon, &view, &work, &result);
            expect_treaty(outcome, &work, result, &polygon);
            if (outcome == FXL_CLIP_INSIDE) {
                expect_transformed(&view, &polygon, result);
                inside++;
            }
            cut += outcome == FXL_CLIP_CUT;
            gone += !is_kept(outcome);
        }
    }
    const int few = UNIT_REPEAT / 40;
    TEST_ASSERT_TRUE(inside > few && cut > few && gone > few);
}

/* The polygon itself may lie in the work, and is then lost. */
void test_a_polygon_within_the_work_gives_the_same(void)
{
    static fxl_clipper_work work, other;
    int cut = 0;
    for (int i = 0; i < UNIT_REPEAT / 4; i++) {
        fxl_view view = random_view(Q16(100));
        fxl_polygon polygon = random_triangle(&view);
        for (int which = 0; which < 2; which++) {
            const fxl_view_polygon *apart, *within;
            fxl_clip_result outcome = clippers[which](&polygon, &view, &work, &apart);
            other.polygon = polygon;
            TEST_ASSERT_EQUAL(outcome, clippers[which](&other.polygon, &view, &other, &within));
            expect_treaty(outcome, &other, within, &polygon);
            if (is_kept(outcome)) {
                TEST_ASSERT_EQUAL(apart->count, within->count);
                TEST_ASSERT_EQUAL_MEMORY(apart->vertices, within->vertices,
                                         apart->count * sizeof apart->vertices[0]);
            }
            cut += outcome == FXL_CLIP_CUT;
        }
    }
    TEST_ASSERT_TRUE(cut > UNIT_REPEAT / 40);
}

static uint8_t frames[4][PIXELS];
static fxl_order_entry order[2][64];
static uint32_t list[2][LIST_WORDS];
static fxl_renderer renderers[2];

static void start(int which)
{
    tiny_scene *tiny = tiny_make();
    fxl_scene_fault fault = {"", 0};
    fxl_lens lens = unit_lens(WIDTH, HEIGHT);
    const fxl_memory memory = {order[which], 64, list[which], LIST_WORDS};
    TEST_ASSERT_EQUAL_MESSAGE(FXL_OK, fxl_scene_check(&tiny->scene, &fault), fault.what);
    TEST_ASSERT_EQUAL(FXL_OK, fxl_renderer_init(&renderers[which], &tiny->scene, &lens, &memory));
}

static void draw(fxl_renderer *renderer, const fxl_pose *pose, uint8_t *frame)
{
    fxl_band band = {frame, WIDTH, WIDTH, 0, HEIGHT};
    fxl_fill_band(&band, BACKGROUND);
    TEST_ASSERT_EQUAL(FXL_OK, fxl_frame_begin(renderer, pose));
    TEST_ASSERT_EQUAL(FXL_OK, fxl_frame_draw(renderer, &band));
}

/* Between and beside the cubes, where many faces are cut. */
static fxl_pose random_pose(void)
{
    fxl_pose pose = unit_pose();
    pose.position = unit_point(Q16(3));
    pose.position.z += Q16(5) * unit_between(0, 2);
    return pose;
}

/* A clipper that counts what it is asked, and answers what it is told to. */
static uint32_t asked;
static const fxl_clip_result *answer; /* null: what fxl_clip_by_view says */

static fxl_clip_result recording_clipper(const fxl_polygon *polygon, const fxl_view *view,
                                         fxl_clipper_work *work, const fxl_view_polygon **result)
{
    asked++;
    TEST_ASSERT_EQUAL(WIDTH, view->lens.width);
    TEST_ASSERT_TRUE(polygon->count >= 3 && polygon->count <= FXL_FACE_VERTICES_MAX);
    *result = NULL;
    return answer ? *answer : fxl_clip_by_view(polygon, view, work, result);
}

void test_the_renderer_asks_the_clipper_that_it_was_given(void)
{
    start(0);
    TEST_ASSERT_TRUE(renderers[0].clipper == fxl_clip_by_view);
    fxl_pose pose = {{Q16(0.5), Q16(0.25), Q16(-4)}, 0, 0, 0};
    draw(&renderers[0], &pose, frames[0]);
    fxl_counters counters = renderers[0].counters;
    TEST_ASSERT_TRUE(counters.drawn > 0);
    renderers[0].clipper = recording_clipper;
    answer = NULL;
    asked = 0;
    draw(&renderers[0], &pose, frames[1]);
    TEST_ASSERT_EQUAL_MEMORY(frames[0], frames[1], PIXELS);
    TEST_ASSERT_EQUAL_MEMORY(&counters, &renderers[0].counters, sizeof counters);
    TEST_ASSERT_EQUAL_UINT32(counters.in - counters.backfacing, asked);
}

void test_what_a_clipper_answers_is_counted(void)
{
    static const fxl_clip_result answers[] = {FXL_CLIP_OUTSIDE, FXL_CLIP_DEGENERATE,
                                              FXL_CLIP_CAPACITY};
    start(0);
    fxl_pose pose = {{Q16(0.5), Q16(0.25), Q16(-4)}, 0, 0, 0};
    renderers[0].clipper = recording_clipper;
    for (int i = 0; i < 3; i++) {
        answer = &answers[i];
        asked = 0;
        draw(&renderers[0], &pose, frames[0]);
        const fxl_counters *c = &renderers[0].counters;
        TEST_ASSERT_TRUE(asked > 0);
        TEST_ASSERT_EQUAL_UINT32(i == 0 ? asked : 0, c->outside);
        TEST_ASSERT_EQUAL_UINT32(i == 1 ? asked : 0, c->degenerate);
        TEST_ASSERT_EQUAL_UINT32(i == 2 ? asked : 0, c->refused);
        TEST_ASSERT_EQUAL_UINT32(0, c->drawn + c->clipped);
        TEST_ASSERT_EACH_EQUAL_HEX8(BACKGROUND, frames[0], PIXELS);
    }
}

static bool is_near(const uint8_t *frame, int pixel, uint8_t colour)
{
    int x = pixel % WIDTH, y = pixel / WIDTH;
    for (int j = y - 1; j <= y + 1; j++) {
        for (int i = x - 1; i <= x + 1; i++) {
            if (i >= 0 && i < WIDTH && j >= 0 && j < HEIGHT && frame[j * WIDTH + i] == colour) {
                return true;
            }
        }
    }
    return false;
}

/* The two outlines are less than a hundredth of a pixel apart (near is 1/16, focal
 * 24 pixels), so a pixel differs only on an edge, with the other colour next to
 * it, and seldom. */
void test_both_clippers_draw_the_same_frames(void)
{
    const int rounds = UNIT_REPEAT / 50;
    int differing = 0, apart = 0;
    uint32_t clipped = 0;
    start(0);
    start(1);
    renderers[1].clipper = fxl_clip_by_world;
    for (int round = 0; round < rounds; round++) {
        fxl_pose pose = random_pose();
        draw(&renderers[0], &pose, frames[0]);
        draw(&renderers[1], &pose, frames[1]);
        for (int i = 0; i < PIXELS; i++) {
            differing += frames[0][i] != frames[1][i];
            apart += !is_near(frames[0], i, frames[1][i]);
        }
        const fxl_counters *a = &renderers[0].counters, *b = &renderers[1].counters;
        TEST_ASSERT_EQUAL_UINT32(a->in, b->in);
        TEST_ASSERT_EQUAL_UINT32(a->backfacing, b->backfacing);
        TEST_ASSERT_EQUAL_UINT32(0, a->refused + b->refused);
        clipped += a->clipped;
    }
    TEST_ASSERT_TRUE(clipped > (uint32_t)rounds / 2);
    TEST_ASSERT_TRUE(differing <= 1 + rounds / 50);
    TEST_ASSERT_TRUE(apart == 0);
}

void test_the_clipper_may_change_between_frames(void)
{
    start(0);
    start(1);
    renderers[1].clipper = fxl_clip_by_world;
    for (int round = 0; round < 16; round++) {
        fxl_pose pose = random_pose();
        draw(&renderers[0], &pose, frames[0]);
        draw(&renderers[1], &pose, frames[1]);
        renderers[0].clipper = fxl_clip_by_world;
        draw(&renderers[0], &pose, frames[2]);
        renderers[0].clipper = fxl_clip_by_view;
        draw(&renderers[0], &pose, frames[3]);
        TEST_ASSERT_EQUAL_MEMORY(frames[1], frames[2], PIXELS);
        TEST_ASSERT_EQUAL_MEMORY(frames[0], frames[3], PIXELS);
    }
}

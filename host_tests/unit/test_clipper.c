/* SPDX-License-Identifier: MIT */
/* The two clippers under their treaty, alone and in a renderer. */
#include "clip_unit.h"
#include "frame_bands.h"
#include "polygon_face.h"
#include "tiny.h"
#include "tiny_frames.h"
#include "study/clippers.h"

enum {
    WIDTH = 48,
    HEIGHT = 32,
    PIXELS = WIDTH * HEIGHT,
    BACKGROUND = 200,
    LIST_WORDS = 18 * FXL_DISPLAY_LIST_WORDS(8) /* all faces of the scene, whole or cut */
};

static const fxl_clipper *const clippers[] = {&fxl_clipper_view, &fxl_clipper_world};

static fxl_view random_view(fxl_q16_16 reach)
{
    fxl_view view;
    fxl_pose pose = unit_pose();
    pose.position = unit_point(reach);
    fxl_lens lens = unit_lens(WIDTH, HEIGHT);
    fxl_view_set_lens(&view, &lens);
    TEST_ASSERT_EQUAL(FXL_OK, fxl_view_set_pose(&view, &pose));
    fxl_view_set_world_frustum(&view);
    return view;
}

/* Small and near the view's middle, or anywhere. */
static fxl_polygon random_triangle(const fxl_view *view)
{
    fxl_polygon polygon = {.colour = (uint8_t)unit_random(), .count = 3};
    const fxl_direction *ahead = &view->camera.axes.forward;
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

/* A face between the centres of pixels is inside. */
static fxl_clip_result clip_by_view(const fxl_model_view *model_view, const fxl_face *face,
                                    fxl_clipper_work *work, fxl_screen_polygon *screen)
{
    fxl_clip_result result = fxl_clip_by_view(model_view, face, work, screen);
    return result == FXL_CLIP_BETWEEN ? FXL_CLIP_INSIDE : result;
}

static bool is_kept(fxl_clip_result result)
{
    return result == FXL_CLIP_INSIDE || result == FXL_CLIP_CUT || result == FXL_CLIP_BETWEEN;
}

/* Projects each vertex of a polygon that lies inside. */
static void project_polygon(const fxl_view *view, const fxl_view_polygon *seen,
                            fxl_screen_polygon *screen)
{
    screen->colour = seen->colour;
    screen->count = seen->count;
    for (int i = 0; i < seen->count; i++) {
        TEST_ASSERT_EQUAL(FXL_OK, fxl_project_point(&view->lens, &seen->vertices[i].position,
                                                    &screen->points[i]));
    }
}

static void expect_projected(const fxl_view *view, const fxl_polygon *polygon,
                             const fxl_screen_polygon *screen)
{
    static fxl_view_polygon seen;
    static fxl_screen_polygon expected;
    clip_see_polygon(&view->camera, polygon, &seen);
    project_polygon(view, &seen, &expected);
    TEST_ASSERT_EQUAL(expected.count, screen->count);
    TEST_ASSERT_EQUAL_MEMORY(expected.points, screen->points,
                             expected.count * sizeof expected.points[0]);
}

void test_a_polygon_inside_is_projected_by_both(void)
{
    static fxl_clipper_work work;
    static polygon_face face;
    int inside = 0, cut = 0, gone = 0;
    for (int i = 0; i < UNIT_REPEAT / 4; i++) {
        fxl_view view = random_view(Q16(100));
        fxl_polygon polygon = random_triangle(&view);
        for (int which = 0; which < 2; which++) {
            fxl_screen_polygon screen;
            polygon_face_set(&face, &polygon, &view, (uint32_t)unit_between(1, 8));
            fxl_clip_result outcome =
                clippers[which]->clip(&face.model_view, &face.face, &work, &screen);
            if (outcome == FXL_CLIP_INSIDE) {
                expect_projected(&view, &polygon, &screen);
                inside++;
            }
            if (is_kept(outcome)) {
                TEST_ASSERT_EQUAL(polygon.colour, screen.colour);
                TEST_ASSERT_TRUE(screen.count >= 3 && screen.count <= FXL_POLYGON_CAPACITY);
            }
            cut += outcome == FXL_CLIP_CUT;
            gone += !is_kept(outcome);
        }
    }
    const int few = UNIT_REPEAT / 40;
    TEST_ASSERT_TRUE(inside > few && cut > few && gone > few);
}

/* Clips to all six planes, one after the other. */
static fxl_clip_result clip_to_all(const fxl_view *view, const fxl_polygon *polygon,
                                   fxl_screen_polygon *screen)
{
    static fxl_view_polygon seen;
    static fxl_clip_view_work work;
    const fxl_view_polygon *clipped;
    clip_see_polygon(&view->camera, polygon, &seen);
    fxl_clip_result outcome =
        fxl_clip_view_by_planes(&seen, &view->view_frustum, FXL_PLANES_ALL, &work, NULL, &clipped);
    if (clipped != NULL) {
        project_polygon(view, clipped, screen);
    }
    return outcome;
}

/* A plane that no vertex is outside of has nothing to cut, but for the last bit
 * of a vertex that another plane made. */
/* SPEC 4.7g */
void test_planes_that_are_not_needed_change_nothing(void)
{
    static fxl_clipper_work work;
    static polygon_face face;
    int cut = 0;
    for (int i = 0; i < UNIT_REPEAT; i++) {
        fxl_view view = random_view(Q16(100));
        fxl_polygon polygon = random_triangle(&view);
        fxl_screen_polygon needed, all;
        polygon_face_set(&face, &polygon, &view, 1);
        fxl_clip_result outcome = clip_by_view(&face.model_view, &face.face, &work, &needed);
        fxl_clip_result expected = clip_to_all(&view, &polygon, &all);
        TEST_ASSERT_EQUAL(is_kept(expected), is_kept(outcome));
        if (is_kept(outcome)) {
            TEST_ASSERT_EQUAL(expected, outcome);
            TEST_ASSERT_EQUAL(all.count, needed.count);
            for (int k = 0; k < all.count; k++) {
                TEST_ASSERT_INT32_WITHIN(1, all.points[k].x, needed.points[k].x);
                TEST_ASSERT_INT32_WITHIN(1, all.points[k].y, needed.points[k].y);
            }
        }
        cut += outcome == FXL_CLIP_CUT;
    }
    TEST_ASSERT_TRUE(cut > UNIT_REPEAT / 20);
}

/* What an object's planes leave out is not looked at. */
void test_planes_left_out_do_not_cut(void)
{
    static fxl_clipper_work work;
    static polygon_face face;
    fxl_view view = random_view(Q16(100));
    fxl_polygon polygon = {.colour = 9, .count = 3};
    const fxl_direction *ahead = &view.camera.axes.forward, *aside = &view.camera.axes.right;
    for (int i = 0; i < 3; i++) { /* 10 ahead, and 0, 6 and 12 to the right */
        polygon.vertices[i].position =
            (fxl_point){view.camera.position.x + (ahead->x >> 14) * 10 + (aside->x >> 14) * 6 * i,
                        view.camera.position.y + (ahead->y >> 14) * 10 + (aside->y >> 14) * 6 * i,
                        view.camera.position.z + (ahead->z >> 14) * 10 + (aside->z >> 14) * 6 * i};
    }
    fxl_screen_polygon screen;
    polygon_face_set(&face, &polygon, &view, 4);
    TEST_ASSERT_EQUAL(FXL_CLIP_CUT, clip_by_view(&face.model_view, &face.face, &work, &screen));
    polygon_face_set(&face, &polygon, &view, 4);
    face.model_view.planes = FXL_PLANES_ALL & (fxl_planes) ~(1u << FXL_PLANE_RIGHT);
    TEST_ASSERT_EQUAL(FXL_CLIP_INSIDE, clip_by_view(&face.model_view, &face.face, &work, &screen));
    expect_projected(&view, &polygon, &screen);
}

/* What the scan would find of it. */
static bool has_pixels(const fxl_screen_polygon *screen)
{
    const fxl_band band = {.width = WIDTH, .stride = WIDTH, .rows = HEIGHT};
    fxl_scan scan;
    fxl_span span;
    TEST_ASSERT_EQUAL(FXL_OK, fxl_scan_begin(screen, &band, &scan));
    return fxl_scan_next(&scan, &span);
}

/* place fill-rule: definition: has_one_column and has_one_row */
/* All vertices have the same first centre from them on, in a row and in a column. */
static bool has_one_column(const fxl_screen_polygon *screen)
{
    bool one = true;
    for (int i = 1; i < screen->count; i++) {
        one = one && (screen->points[i].x + 32767) / 65536 == (screen->points[0].x + 32767) / 65536;
    }
    return one;
}

static bool has_one_row(const fxl_screen_polygon *screen)
{
    bool one = true;
    for (int i = 1; i < screen->count; i++) {
        one = one && (screen->points[i].y + 32767) / 65536 == (screen->points[0].y + 32767) / 65536;
    }
    return one;
}

/* SPEC 7.2b, 7.2d */
void test_a_face_between_centres_has_no_pixels(void)
{
    static fxl_clipper_work work;
    static polygon_face face;
    int between = 0, pixels = 0;
    for (int i = 0; i < UNIT_REPEAT; i++) {
        fxl_view view = random_view(Q16(100));
        fxl_polygon polygon = random_triangle(&view);
        const fxl_point middle = polygon.vertices[0].position;
        const int smaller = unit_between(1, 20);
        for (int k = 1; k < 3; k++) {
            fxl_point *at = &polygon.vertices[k].position;
            *at = (fxl_point){middle.x + (at->x - middle.x) / smaller,
                              middle.y + (at->y - middle.y) / smaller,
                              middle.z + (at->z - middle.z) / smaller};
        }
        fxl_screen_polygon screen;
        polygon_face_set(&face, &polygon, &view, 8);
        fxl_clip_result result = fxl_clip_by_view(&face.model_view, &face.face, &work, &screen);
        if (result == FXL_CLIP_BETWEEN || result == FXL_CLIP_INSIDE) {
            expect_projected(&view, &polygon, &screen);
            /* What reaches no row, any clipper may leave to the list. */
            bool between_columns = has_one_column(&screen);
            TEST_ASSERT_FALSE(between_columns && result != FXL_CLIP_BETWEEN);
            TEST_ASSERT_FALSE(result == FXL_CLIP_BETWEEN && !between_columns &&
                              !has_one_row(&screen));
            TEST_ASSERT_FALSE(result == FXL_CLIP_BETWEEN && has_pixels(&screen));
            between += result == FXL_CLIP_BETWEEN;
            pixels += has_pixels(&screen);
        }
    }
    TEST_ASSERT_TRUE(between > UNIT_REPEAT / 20 && pixels > UNIT_REPEAT / 20);
}

static uint8_t frames[4][PIXELS];
static fxl_draw_entry order[2][64];
static uint32_t list[2][LIST_WORDS];
static fxl_renderer renderers[2];

static void start(int which)
{
    tiny_scene *tiny = tiny_make();
    fxl_scene_fault fault = {"", 0};
    fxl_lens lens = unit_lens(WIDTH, HEIGHT);
    const fxl_memory memory = {order[which], 64, list[which], LIST_WORDS, NULL, 0};
    TEST_ASSERT_EQUAL_MESSAGE(FXL_OK, fxl_scene_check(&tiny->scene, &fault), fault.what);
    TEST_ASSERT_EQUAL(FXL_OK,
                      fxl_renderer_init_with(&renderers[which], &tiny->scene, &lens, &memory));
}

static void set_clipper(int which, const fxl_clipper *clipper)
{
    TEST_ASSERT_EQUAL(FXL_OK, fxl_renderer_set_clipper(&renderers[which], clipper, NULL, 0));
}

static void draw(fxl_renderer *renderer, const fxl_pose *pose, uint8_t *frame)
{
    frame_draw_pose(renderer, pose, frame, HEIGHT, BACKGROUND);
}

/* A clipper that counts what it is asked, and answers what it is told to. */
static uint32_t asked;
static const fxl_clip_result *answer; /* null: what fxl_clip_by_view says */

static fxl_clip_result recording_clipper(const fxl_model_view *model_view, const fxl_face *face,
                                         fxl_clipper_work *work, fxl_screen_polygon *screen)
{
    asked++;
    TEST_ASSERT_EQUAL(WIDTH, model_view->view->lens.width);
    TEST_ASSERT_TRUE(face->count >= 3 && face->count <= FXL_FACE_VERTICES_MAX);
    return answer ? *answer : clip_by_view(model_view, face, work, screen);
}

static const fxl_clipper recording = {.clip = recording_clipper};

/* SPEC 4.7o */
void test_the_renderer_asks_the_clipper_that_it_was_given(void)
{
    start(0);
    TEST_ASSERT_TRUE(renderers[0].clipper == &fxl_clipper_view);
    fxl_pose pose = {{Q16(0.5), Q16(0.25), Q16(-4)}, 0, 0, 0};
    draw(&renderers[0], &pose, frames[0]);
    fxl_counters counters = renderers[0].workspace.counters;
    TEST_ASSERT_TRUE(counters.drawn > 0);
    set_clipper(0, &recording);
    answer = NULL;
    asked = 0;
    draw(&renderers[0], &pose, frames[1]);
    TEST_ASSERT_EQUAL_MEMORY(frames[0], frames[1], PIXELS);
    TEST_ASSERT_EQUAL_MEMORY(&counters, &renderers[0].workspace.counters, sizeof counters);
    TEST_ASSERT_EQUAL_UINT32(counters.in - counters.backfacing, asked);
}

/* SPEC 4.11e-f */
void test_what_a_clipper_answers_is_counted(void)
{
    static const fxl_clip_result answers[] = {FXL_CLIP_OUTSIDE, FXL_CLIP_DEGENERATE,
                                              FXL_CLIP_CAPACITY, FXL_CLIP_RANGE};
    start(0);
    fxl_pose pose = {{Q16(0.5), Q16(0.25), Q16(-4)}, 0, 0, 0};
    set_clipper(0, &recording);
    for (int i = 0; i < 4; i++) {
        answer = &answers[i];
        asked = 0;
        draw(&renderers[0], &pose, frames[0]);
        const fxl_counters *c = &renderers[0].workspace.counters;
        TEST_ASSERT_TRUE(asked > 0);
        TEST_ASSERT_EQUAL_UINT32(i == 0 ? asked : 0, c->outside);
        TEST_ASSERT_EQUAL_UINT32(i == 1 ? asked : 0, c->degenerate);
        TEST_ASSERT_EQUAL_UINT32(i >= 2 ? asked : 0, c->refused);
        TEST_ASSERT_EQUAL_UINT32(0, c->drawn + c->clipped);
        TEST_ASSERT_EACH_EQUAL_HEX8(BACKGROUND, frames[0], PIXELS);
    }
}

/* The two outlines are less than a hundredth of a pixel apart (near is 1/16, focal
 * 24 pixels), so a pixel differs only on an edge, with the other colour next to
 * it, and seldom. */
/* clippers 4.3 */
void test_both_clippers_draw_the_same_frames(void)
{
    const int rounds = UNIT_REPEAT / 50;
    int differing = 0, apart = 0;
    uint32_t clipped = 0;
    start(0);
    start(1);
    set_clipper(1, &fxl_clipper_world);
    for (int round = 0; round < rounds; round++) {
        fxl_pose pose = tiny_pose_between();
        draw(&renderers[0], &pose, frames[0]);
        draw(&renderers[1], &pose, frames[1]);
        for (int i = 0; i < PIXELS; i++) {
            differing += frames[0][i] != frames[1][i];
            apart += !frame_has_near(frames[0], WIDTH, HEIGHT, i, frames[1][i]);
        }
        const fxl_counters *a = &renderers[0].workspace.counters,
                           *b = &renderers[1].workspace.counters;
        TEST_ASSERT_EQUAL_UINT32(a->in, b->in);
        TEST_ASSERT_EQUAL_UINT32(a->backfacing, b->backfacing);
        TEST_ASSERT_EQUAL_UINT32(0, a->refused + b->refused);
        clipped += a->clipped;
    }
    TEST_ASSERT_TRUE(clipped > (uint32_t)rounds / 2);
    TEST_ASSERT_TRUE(differing <= 1 + rounds / 50);
    TEST_ASSERT_TRUE(apart == 0);
}

/* Two renderers at once, with caches of any size, none included. */
/* SPEC 4.10c */
void test_the_cache_changes_no_pixel(void)
{
    enum {
        ENTRIES = 9
    };
    static fxl_cached_vertex caches[2][ENTRIES];
    for (int round = 0; round < UNIT_REPEAT / 100; round++) {
        fxl_pose pose = tiny_pose_between();
        start(0);
        draw(&renderers[0], &pose, frames[0]);
        const fxl_counters counters = renderers[0].workspace.counters;
        for (int which = 0; which < 2; which++) {
            start(which);
            fxl_vertex_cache_init(&renderers[which].workspace.cache, caches[which],
                                  (uint32_t)unit_between(1, ENTRIES));
            TEST_ASSERT_EQUAL(FXL_OK, fxl_frame_begin(&renderers[which], &pose));
        }
        for (int which = 0; which < 2; which++) {
            frame_draw_bands(&renderers[which], frames[1 + which], HEIGHT, BACKGROUND);
            TEST_ASSERT_EQUAL_MEMORY(frames[0], frames[1 + which], PIXELS);
            TEST_ASSERT_EQUAL_MEMORY(&counters, &renderers[which].workspace.counters,
                                     sizeof counters);
        }
    }
}

void test_the_clipper_may_change_between_frames(void)
{
    start(0);
    start(1);
    set_clipper(1, &fxl_clipper_world);
    for (int round = 0; round < 16; round++) {
        fxl_pose pose = tiny_pose_between();
        draw(&renderers[0], &pose, frames[0]);
        draw(&renderers[1], &pose, frames[1]);
        set_clipper(0, &fxl_clipper_world);
        draw(&renderers[0], &pose, frames[2]);
        set_clipper(0, &fxl_clipper_view);
        draw(&renderers[0], &pose, frames[3]);
        TEST_ASSERT_EQUAL_MEMORY(frames[1], frames[2], PIXELS);
        TEST_ASSERT_EQUAL_MEMORY(frames[0], frames[3], PIXELS);
    }
}

/* SPDX-License-Identifier: MIT */
/* What is left out of whole frames: objects by a sphere, and faces of a sorted model before the
 * sort. */
#include "frame_bands.h"
#include "tiny.h"
#include "study/clippers.h"

enum {
    WIDTH = 48,
    HEIGHT = 32,
    ENTRIES = 16,
    LIST_WORDS = 18 * FXL_DISPLAY_LIST_WORDS(8),
    POSES = 60
};

static uint8_t whole[WIDTH * HEIGHT], other[WIDTH * HEIGHT];
static fxl_draw_entry order[2][ENTRIES];
static uint32_t list[2][LIST_WORDS];
static fxl_renderer renderers[2];
static uint32_t asked;

static fxl_clip_result counting(const fxl_model_view *model_view, const fxl_face *face,
                                fxl_clipper_work *work, fxl_screen_polygon *screen)
{
    asked += 1;
    return fxl_clip_by_view(model_view, face, work, screen);
}

static const fxl_clipper dropping = {.clip = counting, .by_clip_flags = true};
static const fxl_clipper keeping = {.clip = counting};

/* All three cubes sorted: their faces share vertices. */
static tiny_scene *start(uint32_t list_words)
{
    tiny_scene *tiny = tiny_make();
    const fxl_lens lens = unit_lens(WIDTH, HEIGHT);
    tiny->instances[0].model = tiny->instances[2].model = 1;
    TEST_ASSERT_EQUAL(FXL_OK, fxl_scene_check(&tiny->scene, NULL));
    TEST_ASSERT_TRUE(tiny->scene.draw_list_needed <= ENTRIES);
    for (int i = 0; i < 2; i++) {
        static fxl_cached_vertex cache[2][8]; /* all vertices of a model: it pays to drop */
        const fxl_memory memory = {order[i], ENTRIES, list[i], list_words, cache[i], 8};
        TEST_ASSERT_EQUAL(FXL_OK,
                          fxl_renderer_init_with(&renderers[i], &tiny->scene, &lens, &memory));
        TEST_ASSERT_EQUAL(FXL_OK, fxl_renderer_set_clipper(&renderers[i],
                                                           i == 0 ? &dropping : &keeping, NULL, 0));
    }
    return tiny;
}

/* Among the cubes, turned to all sides: some lie behind, some across a side. */
static fxl_pose pose_number(int number)
{
    fxl_pose pose = {{Q16(0.5), Q16(0.25), Q16(-3)}, 0, 0, 0};
    pose.position.z += number % 7 * Q16(2);
    pose.position.x += (number % 5 - 2) * Q16(1.1);
    pose.yaw = (uint32_t)number * DEGREES(37);
    pose.pitch = (uint32_t)number * DEGREES(13) - DEGREES(20);
    pose.roll = (uint32_t)number * DEGREES(11);
    return pose;
}

static void draw(fxl_renderer *renderer, const fxl_pose *pose, uint8_t *frame, uint16_t rows)
{
    frame_draw_pose(renderer, pose, frame, rows, 0);
}

/* The same frame and the same counts, whatever the list has room for and in bands. */
void test_leaving_out_changes_no_frame_and_no_count(void)
{
    static const uint32_t lists[] = {LIST_WORDS, 40, 0};
    for (int number = 0; number < POSES; number++) {
        const fxl_pose pose = pose_number(number);
        start(lists[number % 3]);
        draw(&renderers[0], &pose, whole, number % 2 ? HEIGHT : 8);
        draw(&renderers[1], &pose, other, HEIGHT);
        TEST_ASSERT_EQUAL_MEMORY(other, whole, sizeof whole);
        fxl_counters left_out = renderers[0].workspace.counters;
        fxl_counters kept = renderers[1].workspace.counters;
        left_out.spilled = kept.spilled = 0; /* what the list had room for may differ */
        TEST_ASSERT_EQUAL_MEMORY(&kept, &left_out, sizeof kept);
    }
}

/* The clipper is not asked about them, nor for an instance that lies inside all planes. */
void test_what_is_left_out_is_not_clipped(void)
{
    uint32_t saved = 0;
    for (int number = 0; number < POSES; number++) {
        const fxl_pose pose = pose_number(number);
        start(LIST_WORDS);
        asked = 0;
        TEST_ASSERT_EQUAL(FXL_OK, fxl_frame_begin(&renderers[0], &pose));
        const uint32_t by_dropping = asked;
        asked = 0;
        TEST_ASSERT_EQUAL(FXL_OK, fxl_frame_begin(&renderers[1], &pose));
        TEST_ASSERT_TRUE(by_dropping <= asked);
        saved += asked - by_dropping;
        const fxl_counters *counters = &renderers[0].workspace.counters;
        /* What was asked about was neither turned away nor, so far as a face has all vertices
         * outside one plane, outside. */
        TEST_ASSERT_TRUE(by_dropping <= counters->in - counters->backfacing);
        TEST_ASSERT_TRUE(by_dropping >= counters->drawn);
    }
    TEST_ASSERT_EQUAL(!FXL_IS_COMPACT, saved > 0); /* a build for size leaves none out */
}

static bool is_outside(const fxl_view *view, const fxl_model_view *model_view, const fxl_face *face)
{
    for (int plane = 0; plane < 6; plane++) {
        uint32_t outside = 0;
        for (uint32_t i = 0; i < face->count; i++) {
            const uint16_t number = fxl_face_indices(model_view->indices, face)[i];
            fxl_cached_vertex vertex;
            fxl_transform_vertex(model_view, number, &vertex);
            outside += fxl_view_distance(&view->view_frustum, plane, &vertex.position) < 0;
        }
        if (outside == face->count) {
            return true;
        }
    }
    return false;
}

/* Faces of 3 to 8 of a cube's vertices: any of them, as they need no plane. */
static void make_any_faces(fxl_face faces[6], uint16_t indices[6 * 8])
{
    for (uint16_t f = 0; f < 6; f++) {
        faces[f].count = (uint8_t)(3 + f);
        for (uint32_t i = 0; i < 8; i++) {
            indices[8 * f + i] = (uint16_t)(unit_random() % 8);
        }
        fxl_face_take_indices(&faces[f], indices, 8u * f);
    }
}

/* Exactly the faces with all vertices on the outer side of one plane, and the others as they were.
 */
void test_exactly_those_outside_one_plane_are_left_out(void)
{
    uint32_t dropped = 0, kept = 0, dropped_large = 0;
    for (int number = 0; number < 2 * POSES; number++) {
        const fxl_pose pose = pose_number(number / 2);
        tiny_scene *tiny = start(LIST_WORDS);
        const fxl_face *faces = &tiny->faces[tiny->models[1].first_face];
        fxl_view *view = &renderers[0].frame.view;
        TEST_ASSERT_EQUAL(FXL_OK, fxl_view_set_pose(view, &pose));
        for (uint32_t i = 0; i < TINY_INSTANCES; i++) {
            fxl_draw_entry entries[6], expected[6];
            fxl_face any[6];
            uint16_t indices[6 * 8];
            fxl_model_view model_view;
            uint32_t left = 0;
            fxl_model_view_of_instance(&model_view, &tiny->scene, &tiny->instances[i], view,
                                       &renderers[0].workspace.cache);
            if (number % 2 != 0) {
                make_any_faces(any, indices);
                faces = any;
                model_view.indices = indices;
            }
            for (uint16_t f = 0; f < 6; f++) {
                entries[f] = fxl_draw_entry_of(((uint64_t)f << 33) + 5, f, 0);
                if (!is_outside(view, &model_view, &faces[f])) {
                    expected[left++] = entries[f];
                } else {
                    dropped_large += faces[f].count > 4;
                }
            }
            TEST_ASSERT_EQUAL_UINT32(left, fxl_drop_outside(&model_view, faces, entries, 6));
            for (uint32_t f = 0; f < left; f++) {
                TEST_ASSERT_EQUAL_UINT32(expected[f].index, entries[f].index);
                TEST_ASSERT_EQUAL_UINT64(fxl_draw_entry_distance(&expected[f]),
                                         fxl_draw_entry_distance(&entries[f]));
            }
            dropped += 6 - left;
            kept += left;
        }
    }
    TEST_ASSERT_TRUE(dropped > 50 && kept > 50 && dropped_large > 50);
}

static fxl_renderer renderer;
static fxl_draw_entry objects[TINY_INSTANCES + 6];
static uint8_t pixels[2][HEIGHT * WIDTH];

static fxl_counters draw_by(tiny_scene *tiny, const fxl_lens *lens, const fxl_pose *pose, int which,
                            const fxl_clipper *clipper)
{
    const fxl_memory memory = {objects, TINY_INSTANCES + 6, NULL, 0, NULL, 0};
    TEST_ASSERT_EQUAL(FXL_OK, fxl_scene_check(&tiny->scene, NULL));
    TEST_ASSERT_EQUAL(FXL_OK, fxl_renderer_init_with(&renderer, &tiny->scene, lens, &memory));
    TEST_ASSERT_EQUAL(FXL_OK, fxl_renderer_set_clipper(&renderer, clipper, NULL, 0));
    frame_draw_pose(&renderer, pose, pixels[which], HEIGHT, 0);
    return renderer.workspace.counters;
}

/* The same frame with the least radius and with one that leaves nothing out. */
void test_leaving_objects_out_changes_no_pixel(void)
{
    uint32_t left_out = 0, drawn = 0;
    for (int i = 0; i < UNIT_REPEAT / 100; i++) {
        tiny_scene *tiny = tiny_make();
        fxl_lens lens = unit_lens(WIDTH, HEIGHT);
        fxl_pose pose = unit_pose();
        pose.position = (fxl_point){unit_between(Q16(-8), Q16(8)), unit_between(Q16(-4), Q16(4)),
                                    unit_between(Q16(-8), Q16(20))};
        const fxl_clipper *clipper = i % 2 ? &fxl_clipper_view : &fxl_clipper_world;
        tiny->models[0].radius = tiny->models[1].radius = 113512;
        fxl_counters tight = draw_by(tiny, &lens, &pose, 0, clipper);
        tiny->models[0].radius = tiny->models[1].radius = FXL_RADIUS_MAX;
        fxl_counters wide_open = draw_by(tiny, &lens, &pose, 1, clipper);
        TEST_ASSERT_EQUAL_MEMORY(pixels[0], pixels[1], sizeof pixels[0]);
        TEST_ASSERT_EQUAL_UINT32(wide_open.in, tight.in);
        TEST_ASSERT_EQUAL_UINT32(wide_open.drawn, tight.drawn);
        TEST_ASSERT_EQUAL_UINT32(wide_open.clipped, tight.clipped);
        TEST_ASSERT_EQUAL_UINT32(wide_open.backfacing + wide_open.outside + wide_open.degenerate,
                                 tight.backfacing + tight.outside + tight.degenerate);
        TEST_ASSERT_TRUE(tight.outside >= wide_open.outside);
        left_out += tight.outside - wide_open.outside;
        drawn += tight.drawn;
    }
    TEST_ASSERT_TRUE(left_out > UNIT_REPEAT / 100 && drawn > UNIT_REPEAT / 300);
}

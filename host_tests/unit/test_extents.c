/* SPDX-License-Identifier: MIT */
/* Bands that pass over what does not reach them: the same frames, and less work. */
#include "study/study.h"
#include "choices.h"
#include "frame_bands.h"
#include "tiny.h"

enum {
    WIDTH = 24,
    HEIGHT_MAX = 300, /* rows are kept in twos where they are more than 254 */
    SIDES = 20,       /* of a prism: more faces than an instance has bits */
    INSTANCES = 9,
    ENTRIES = INSTANCES + 6 + 60,
    WORDS = 200,
    BACKGROUND = 200
};

static uint8_t whole[WIDTH * HEIGHT_MAX], other[WIDTH * HEIGHT_MAX];
static uint32_t list[WORDS];
static fxl_draw_entry order[ENTRIES];
static fxl_renderer renderer;
static uint16_t height;
static uint32_t asked;

/* The cubes of the tiny scene, and a prism: two ends of SIDES corners, and the sides between. */
static fxl_point vertices[16 + 2 * SIDES];
static uint16_t indices[48 + 2 * SIDES + 4 * SIDES];
static fxl_face faces[12 + 2 + SIDES];
static fxl_model models[3];
static fxl_instance instances[INSTANCES];
static fxl_scene scene;
static const fxl_scene *shown; /* the scene, but for a world */

static void make_prism(void)
{
    uint16_t *index = indices + 48;
    fxl_face *face = faces + 12;
    for (uint32_t i = 0; i < SIDES; i++) {
        const fxl_angle angle = (fxl_angle)((uint64_t)i * 0x100000000u / SIDES);
        const fxl_q16_16 x = fxl_cos(angle) >> 14, y = fxl_sin(angle) >> 14;
        vertices[16 + i] = (fxl_point){x, y, -Q16(1)};
        vertices[16 + SIDES + i] = (fxl_point){x, y, Q16(1)};
    }
    for (uint32_t end = 0; end < 2; end++, face++) {
        *face = (fxl_face){.normal = {0, 0, end ? FXL_Q2_30_ONE : -FXL_Q2_30_ONE},
                           .count = SIDES,
                           .material = (uint8_t)(21 + end)};
        for (uint32_t i = 0; i < SIDES; i++) {
            *index++ = (uint16_t)(end ? SIDES + i : SIDES - 1 - i);
        }
        fxl_face_take_indices(face, indices, (uint32_t)(index - indices) - SIDES);
    }
    for (uint32_t i = 0; i < SIDES; i++, face++) {
        const fxl_angle middle = (fxl_angle)((uint64_t)(2 * i + 1) * 0x80000000u / SIDES);
        const uint32_t next = (i + 1) % SIDES;
        *face = (fxl_face){.normal = {fxl_cos(middle), fxl_sin(middle), 0},
                           .count = 4,
                           .material = (uint8_t)(30 + i)};
        *index++ = (uint16_t)i;
        *index++ = (uint16_t)next;
        *index++ = (uint16_t)(SIDES + next);
        *index++ = (uint16_t)(SIDES + i);
        fxl_face_take_indices(face, indices, (uint32_t)(index - indices) - 4);
    }
    models[2] = (fxl_model){16, 2 * SIDES, 12, 2 + SIDES, FXL_MODEL_CONVEX, 0, 0, TINY_RADIUS, 0};
}

static void make_scene(void)
{
    const tiny_scene *tiny = tiny_make();
    memcpy(vertices, tiny->vertices, sizeof tiny->vertices);
    memcpy(indices, tiny->corners, sizeof tiny->corners);
    memcpy(faces, tiny->faces, sizeof tiny->faces);
    memcpy(models, tiny->models, sizeof tiny->models);
    make_prism();
    for (uint32_t i = 0; i < INSTANCES; i++) {
        instances[i] = (fxl_instance){unit_point(Q16(8)), (uint16_t)unit_between(0, 2),
                                      (uint8_t)unit_between(0, 1), 0};
    }
    shown = &scene;
    scene = (fxl_scene){.vertices = vertices,
                        .indices = indices,
                        .faces = faces,
                        .models = models,
                        .instances = instances,
                        .instance_count = INSTANCES,
                        .model_count = 3,
                        .draw_list_needed = INSTANCES + 6};
}

static fxl_clip_result counting(const fxl_model_view *model_view, const fxl_face *face,
                                fxl_clipper_work *work, fxl_screen_polygon *screen)
{
    asked++;
    return fxl_clip_by_view(model_view, face, work, screen);
}

static const fxl_clipper counted = {.clip = counting, .by_clip_flags = true};

static uint64_t clipper_room[512], spans_room[2048];

typedef struct {
    const fxl_clipper *clipper;
    const choice *visibility;
    uint32_t spare, words;
} setting;

static void start(const setting *with)
{
    const fxl_lens lens = unit_lens(WIDTH, height);
    const fxl_memory memory = {order, INSTANCES + 6 + with->spare, list, with->words, NULL, 0};
    TEST_ASSERT_EQUAL(FXL_OK, fxl_renderer_init_with(&renderer, shown, &lens, &memory));
    TEST_ASSERT_EQUAL(FXL_OK, fxl_renderer_set_clipper(&renderer, with->clipper, clipper_room,
                                                       sizeof clipper_room));
    TEST_ASSERT_EQUAL(FXL_OK,
                      choice_take(&renderer, with->visibility, spans_room, sizeof spans_room));
}

static void draw_rows(fxl_workspace *workspace, uint8_t *frame, uint32_t first, uint32_t rows)
{
    frame_draw_band(&renderer, workspace, frame, first, rows, BACKGROUND);
}

/* In bands of so many rows, after begin. */
static void draw_bands(fxl_workspace *workspace, uint8_t *frame, uint32_t rows)
{
    for (uint32_t row = 0; row < height; row += rows) {
        draw_rows(workspace, frame, row, row + rows <= height ? rows : height - row);
    }
}

static fxl_pose random_pose(void)
{
    fxl_pose pose = unit_pose();
    pose.position = unit_point(Q16(7));
    return pose;
}

static void draw_whole(const setting *with, const fxl_pose *pose, fxl_counters *counters)
{
    setting plain = *with;
    plain.words = 0;
    start(&plain);
    TEST_ASSERT_EQUAL(FXL_OK, fxl_frame_begin(&renderer, pose));
    draw_rows(&renderer.workspace, whole, 0, height);
    *counters = renderer.workspace.counters;
    counters->spilled = counters->split_bands = 0;
}

static void check_counters(const fxl_counters *expected)
{
    fxl_counters found = renderer.workspace.counters;
    found.spilled = found.split_bands = 0;
    TEST_ASSERT_EQUAL_MEMORY(expected, &found, sizeof found);
}

static setting random_setting(void)
{
    static const fxl_clipper *const clippers[] = {&fxl_clipper_view, &fxl_clipper_world,
                                                  &fxl_clipper_triangles};
    static const choice *const methods[] = {&choice_sorted, &choice_spans};
    const setting made = {clippers[unit_between(0, 2)], methods[unit_between(0, 1)],
                          (uint32_t)unit_between(0, 60), (uint32_t)unit_between(1, WORDS)};
    return made;
}

/* Whatever draws it, on screens of three heights, with memory for all faces, some or none. */
void test_bands_of_any_height_give_the_same_frame_and_counts(void)
{
    static const uint16_t heights[] = {16, 254, HEIGHT_MAX};
    for (uint32_t round = 0; round < UNIT_REPEAT / 25 + 12; round++) {
        const fxl_pose pose = random_pose();
        setting with;
        fxl_counters expected;
        height = heights[round % 3];
        make_scene();
        with = random_setting();
        draw_whole(&with, &pose, &expected);
        start(&with);
        TEST_ASSERT_EQUAL(FXL_OK, fxl_frame_begin(&renderer, &pose));
        memset(other, 0, sizeof other);
        draw_bands(&renderer.workspace, other, (uint32_t)unit_between(1, 9));
        TEST_ASSERT_EQUAL_MEMORY(whole, other, (size_t)WIDTH * height);
        check_counters(&expected);
        draw_bands(&renderer.workspace, other, 40); /* once more, by what is there */
        TEST_ASSERT_EQUAL_MEMORY(whole, other, (size_t)WIDTH * height);
        check_counters(&expected);
    }
}

/* With memory for more faces than a place counts, the one instance behind that is drawn as one without memory is. */
void test_places_of_faces_are_below_that_of_none(void)
{
#ifndef UNIT_ON_TARGET
    enum {
        COPIES =
            8500, /* those of 8 instances are too many, even without some that the display list has */
        ROOM = INSTANCES * COPIES / 4
    };
    static fxl_face copies[COPIES];
    static fxl_draw_entry roomy[ROOM];
    static const fxl_point corners[] = {
        {Q16(8), 0, 0}, {-Q16(4), -Q16(7), 0}, {-Q16(4), Q16(7), 0}};
    static const uint16_t triangle[] = {0, 1, 2};
    const fxl_memory memory = {roomy, ROOM, list, WORDS, NULL, 0};
    const fxl_model model = {0, 3, 0, COPIES, FXL_MODEL_CONVEX, 0, 0, Q16(9), 0};
    const setting plain = {&fxl_clipper_view, &choice_sorted, 0, 0};
    const fxl_pose pose = {{0, 0, 0}, 0, 0, 0};
    fxl_counters expected;
    uint32_t without = 0;
    height = 254;
    make_scene();
    for (uint32_t i = 0; i < COPIES; i++) {
        copies[i] = (fxl_face){
            .normal = {0, 0, -FXL_Q2_30_ONE}, .count = 3, .material = (uint8_t)(i / 1000)};
        fxl_face_take_indices(&copies[i], triangle, 0);
    }
    for (int32_t i = 0; i < INSTANCES; i++) {
        instances[i] = (fxl_instance){{0, (i - INSTANCES / 2) * Q16(20), Q16(20 + i)}, 0, 0, 0};
    }
    scene.vertices = corners;
    scene.indices = triangle;
    scene.faces = copies;
    scene.models = &model;
    draw_whole(&plain, &pose, &expected);
    TEST_ASSERT_EQUAL_UINT32(INSTANCES * COPIES, expected.drawn);
    const fxl_lens lens = unit_lens(WIDTH, height);
    TEST_ASSERT_EQUAL(FXL_OK, fxl_renderer_init_with(&renderer, &scene, &lens, &memory));
    TEST_ASSERT_EQUAL(FXL_OK, fxl_frame_begin(&renderer, &pose));
    TEST_ASSERT_EQUAL(INSTANCES, renderer.frame.visible_count);
    draw_bands(&renderer.workspace, other, 40);
    for (uint32_t i = 0; i < INSTANCES; i++) {
        without += (roomy[i].faces & UINT16_MAX) == UINT16_MAX;
    }
    TEST_ASSERT_EQUAL_UINT32(1, without);
    TEST_ASSERT_EQUAL_MEMORY(whole, other, (size_t)WIDTH * height);
    check_counters(&expected);
#endif
}

/* A workspace beside the renderer's own knows no face order, and finds it. */
void test_another_workspace_draws_the_same_bands(void)
{
    static fxl_workspace second;
    static uint64_t memory[2048];
    height = 64;
    for (uint32_t round = 0; round < UNIT_REPEAT / 50 + 8; round++) {
        const fxl_pose pose = random_pose();
        setting with;
        fxl_counters expected;
        make_scene();
        with = random_setting();
        draw_whole(&with, &pose, &expected);
        start(&with);
        TEST_ASSERT_EQUAL(FXL_OK, fxl_workspace_init(&second, &renderer, memory, sizeof memory));
        TEST_ASSERT_EQUAL(FXL_OK, fxl_frame_begin(&renderer, &pose));
        for (uint32_t row = 0; row < height; row += 4) {
            draw_rows(row % 8 ? &second : &renderer.workspace, other, row, 4);
        }
        TEST_ASSERT_EQUAL_MEMORY(whole, other, (size_t)WIDTH * height);
    }
}

/* Frame after frame from the same renderer: memory that a frame lent itself is free again for the
 * next, which sees more instances, or draws in one band. */
void test_the_next_frame_has_all_its_memory_again(void)
{
    height = 48;
    make_scene();
    for (uint32_t round = 0; round < UNIT_REPEAT / 50 + 8; round++) {
        const setting with = {&fxl_clipper_view, &choice_sorted, 60, 12};
        const fxl_pose pose = random_pose();
        fxl_counters expected;
        if (round == 0) {
            start(&with);
        }
        if (round % 4 == 3) { /* a setting between two frames */
            TEST_ASSERT_EQUAL(FXL_OK,
                              fxl_renderer_set_clipper(&renderer, &fxl_clipper_view, NULL, 0));
        }
        static fxl_renderer kept;
        TEST_ASSERT_EQUAL(FXL_OK, fxl_frame_begin(&renderer, &pose));
        draw_bands(&renderer.workspace, other, 1 + round % 7);
        kept = renderer;
        draw_whole(&with, &pose, &expected);
        TEST_ASSERT_EQUAL_MEMORY(whole, other, (size_t)WIDTH * height);
        renderer = kept;
        check_counters(&expected);
    }
}

/* Where a target sorts no faces their entries are lent, too. They are free again for one that sorts them, even if
 * it is chosen while a world's renderer is detached. */
void test_another_target_has_all_its_memory_again(void)
{
    static fxl_instance places[INSTANCES];
    static fxl_world_slot slots[INSTANCES];
    static fxl_world world;
    const fxl_world_memory room = {.instances = places, .slots = slots, .capacity = INSTANCES};
    const fxl_pose pose = {{-Q16(20), 0, 0}, DEGREES(90), 0, 0};
    const setting sorted = {&fxl_clipper_view, &choice_sorted, 0, 0};
    const setting near_first = {&fxl_clipper_view, &choice_depth_16, 0, 12};
    fxl_counters expected;
    height = 48;
    make_scene();
    for (uint32_t i = 0; i < INSTANCES; i++) { /* all of them are in sight */
        instances[i] = (fxl_instance){{0, (int32_t)i * Q16(2) - Q16(8), 0}, (uint16_t)(i % 2), 0, 0};
    }
    draw_whole(&sorted, &pose, &expected);
    TEST_ASSERT_EQUAL(FXL_OK, fxl_world_init(&world, &scene, &room));
    for (uint32_t round = 0; round < 2; round++) {
        shown = round == 0 ? &scene : &world.scene;
        start(&near_first);
        TEST_ASSERT_TRUE(round == 0 || fxl_world_attach(&world, &renderer) == FXL_OK);
        TEST_ASSERT_EQUAL(FXL_OK, fxl_frame_begin(&renderer, &pose));
        TEST_ASSERT_EQUAL(FXL_IS_COMPACT, renderer.workspace.cache.entries == NULL);
        draw_bands(&renderer.workspace, other, 7);
        TEST_ASSERT_TRUE(round == 0 || fxl_world_detach(&world, &renderer) == FXL_OK);
        TEST_ASSERT_EQUAL(FXL_OK,
                          choice_take(&renderer, &choice_sorted, spans_room, sizeof spans_room));
        TEST_ASSERT_TRUE(round == 0 || fxl_world_attach(&world, &renderer) == FXL_OK);
        renderer.frame.display_list.capacity = 0;
        TEST_ASSERT_EQUAL(FXL_OK, fxl_frame_begin(&renderer, &pose));
        TEST_ASSERT_NULL(renderer.workspace.cache.entries);
        draw_bands(&renderer.workspace, other, height);
        TEST_ASSERT_EQUAL_MEMORY(whole, other, (size_t)WIDTH * height);
        check_counters(&expected);
    }
}

/* How often the clipper was asked for a frame in bands of three rows. */
static uint32_t asked_in_bands(uint32_t words, uint32_t spare, const fxl_pose *pose)
{
    const setting with = {&counted, &choice_sorted, spare, words};
    start(&with);
    asked = 0;
    TEST_ASSERT_EQUAL(FXL_OK, fxl_frame_begin(&renderer, pose));
    draw_bands(&renderer.workspace, other, 3);
    return asked;
}

/* With memory for the faces a face is clipped once by begin and once for each band that it
 * reaches; without, and in a library for size, once for each band that its instance reaches;
 * without a list, for each band. */
void test_a_band_clips_what_reaches_it(void)
{
    const fxl_pose pose = {{-Q16(20), 0, 0}, DEGREES(90), 0, 0};
    uint32_t least = 0;
    height = 96;
    make_scene();
    for (uint32_t i = 0; i < INSTANCES;
         i++) { /* prisms that lie, one above another: each side reaches few rows */
        instances[i] = (fxl_instance){{Q16(2), (int32_t)i * Q16(3) - Q16(12), 0}, 2, 0, 0};
    }
    const uint32_t by_faces = asked_in_bands(1, 60, &pose);
    const uint32_t by_instances = asked_in_bands(1, 0, &pose);
    const uint32_t by_all = asked_in_bands(0, 60, &pose);
    draw_rows(&renderer.workspace, other, 0, height);
    for (uint32_t row = 0; row < height; row += 3) { /* bands in which something is drawn */
        for (uint32_t i = 0; i < 3u * WIDTH; i++) {
            if (other[row * WIDTH + i] != BACKGROUND) {
                least++;
                break;
            }
        }
    }
    TEST_ASSERT_TRUE(least > 4);
    TEST_ASSERT_TRUE(by_faces >= least);
    if (!FXL_IS_SMALL) {
        TEST_ASSERT_TRUE(by_instances * 3 < by_all);
    }
    if (!FXL_IS_COMPACT) {
        TEST_ASSERT_TRUE(by_faces * 3 < by_instances * 2);
    }
}

/* A cache of the caller's that lies directly behind the order stays the renderer's. There are no
 * entries for faces where no model is sorted. */
void test_a_cache_behind_the_order_is_kept(void)
{
    static struct {
        fxl_draw_entry order[4];
        FXL_ALIGN_8 fxl_cached_vertex cache[16];
    } block;
    const fxl_lens lens = unit_lens(WIDTH, 16);
    const fxl_memory memory = {block.order, 4, list, 0, block.cache, 16};
    const fxl_pose pose = {{0, 0, Q16(-5)}, 0, 0, 0};
    tiny_scene *tiny = tiny_make();
    tiny->models[1].kind = FXL_MODEL_CONVEX;
    tiny->scene.face_bounds = NULL;
    tiny->scene.face_bounds_count = 0;
    TEST_ASSERT_EQUAL_PTR(&block.order[4], block.cache);
    TEST_ASSERT_EQUAL(FXL_OK, fxl_scene_check(&tiny->scene, NULL));
    TEST_ASSERT_EQUAL(FXL_OK, fxl_renderer_init_with(&renderer, &tiny->scene, &lens, &memory));
    for (int frame = 0; frame < 2; frame++) {
        const fxl_band band = UNIT_BAND(whole, WIDTH, 0, 16);
        TEST_ASSERT_EQUAL(FXL_OK, fxl_frame_begin(&renderer, &pose));
        TEST_ASSERT_EQUAL(FXL_OK, fxl_frame_draw(&renderer, &band));
        TEST_ASSERT_EQUAL_PTR(block.cache, renderer.workspace.cache.entries);
    }
}

/* fxl_render draws one band, so it measures nothing: the clipper is asked once for each face, and
 * once more for the one that the list had no room for. */
void test_a_whole_frame_is_not_measured(void)
{
    height = 96;
    for (uint32_t round = 0; round < 40; round++) {
        const fxl_pose pose = random_pose();
        const setting with = {&counted, &choice_sorted, 60, 1 + round};
        make_scene();
        start(&with);
        asked = 0;
        TEST_ASSERT_EQUAL(FXL_OK, fxl_render(&renderer, &pose, other, WIDTH));
        const fxl_counters *counters = &renderer.workspace.counters;
        TEST_ASSERT_TRUE(asked <= counters->in - counters->backfacing + 1);
    }
}

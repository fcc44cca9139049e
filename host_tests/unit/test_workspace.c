/* SPDX-License-Identifier: MIT */
/* Bands of one frame drawn in several workspaces, in turn; and what setting up a renderer or a
 * workspace refuses. */
#include "frame_bands.h"
#include "study/clippers.h"
#include "study/targets.h"
#include "choices.h"
#include "tiny.h"

enum {
    WIDTH = 24,
    HEIGHT = 16,
    BACKGROUND = 200,
    WORDS = 4 * FXL_DISPLAY_LIST_WORDS(6), /* not nearly enough: bands traverse the scene */
    ROOM = 1600
};

static uint8_t whole[WIDTH * HEIGHT], other[WIDTH * HEIGHT];
static uint32_t list[WORDS];
static fxl_draw_entry order[TINY_INSTANCES + 6];
static FXL_ALIGN_8 uint8_t rooms[2][ROOM];
static fxl_renderer renderer;
static fxl_workspace second;

static fxl_memory memory(void)
{
    return (fxl_memory){order, TINY_INSTANCES + 6, list, WORDS, NULL, 0};
}

static tiny_scene *checked_scene(void)
{
    tiny_scene *tiny = tiny_make();
    fxl_scene_fault fault = {"", 0};
    TEST_ASSERT_EQUAL_MESSAGE(FXL_OK, fxl_scene_check(&tiny->scene, &fault), fault.what);
    return tiny;
}

static void start_with_list(uint32_t words)
{
    const fxl_lens lens = unit_lens(WIDTH, HEIGHT);
    fxl_memory tables = memory();
    tables.display_list_capacity = words;
    TEST_ASSERT_EQUAL(FXL_OK,
                      fxl_renderer_init_with(&renderer, &checked_scene()->scene, &lens, &tables));
}

static void start(void)
{
    start_with_list(WORDS);
}

static fxl_pose pose_number(int number)
{
    fxl_pose pose = {{Q16(0.5), Q16(0.25), Q16(-6)}, 0, 0, 0};
    pose.position.z += number * Q16(0.7);
    pose.yaw = (uint32_t)number * DEGREES(5);
    pose.roll = (uint32_t)number * DEGREES(11);
    return pose;
}

/* Every second band in the second workspace: as the whole frame in the renderer's own. */
static void expect_the_same(int frames)
{
    for (int number = 0; number < frames; number++) {
        const fxl_pose pose = pose_number(number);
        frame_draw_pose(&renderer, &pose, whole, HEIGHT, BACKGROUND);
        const fxl_counters counters = renderer.workspace.counters;
        memset(other, 0, sizeof other);
        for (uint16_t first = 0; first < HEIGHT; first = (uint16_t)(first + 2)) {
            fxl_workspace *in = first % 4 == 0 ? &second : &renderer.workspace;
            frame_draw_band(&renderer, in, other, first, 2, BACKGROUND);
        }
        TEST_ASSERT_EQUAL_MEMORY(whole, other, sizeof whole);
        TEST_ASSERT_EQUAL_MEMORY(&counters, &renderer.workspace.counters, sizeof counters);
        TEST_ASSERT_EQUAL_UINT32(0, second.counters.in + second.counters.drawn);
    }
}

/* Frame n + 1 begins in a second renderer between the bands of frame n: two renderers share the
 * scene and nothing else. */
void test_a_frame_begins_between_the_bands_of_the_one_before(void)
{
    static fxl_renderer ahead;
    static uint32_t other_list[WORDS];
    static fxl_draw_entry other_order[TINY_INSTANCES + 6];
    const fxl_lens lens = unit_lens(WIDTH, HEIGHT);
    const fxl_memory tables = {other_order, TINY_INSTANCES + 6, other_list, WORDS, NULL, 0};
    fxl_renderer *turns[2] = {&renderer, &ahead};
    fxl_pose pose = pose_number(0);
    start();
    TEST_ASSERT_EQUAL(FXL_OK, fxl_renderer_init_with(&ahead, renderer.scene, &lens, &tables));
    TEST_ASSERT_EQUAL(FXL_OK, fxl_frame_begin(turns[0], &pose));
    for (int number = 0; number < 6; number++) {
        fxl_renderer *drawn = turns[number % 2], *next = turns[(number + 1) % 2];
        for (uint16_t first = 0; first < HEIGHT; first = (uint16_t)(first + 2)) {
            if (first == 4) {
                pose = pose_number(number + 1);
                TEST_ASSERT_EQUAL(FXL_OK, fxl_frame_begin(next, &pose));
            }
            frame_draw_band(drawn, &drawn->workspace, other, first, 2, BACKGROUND);
        }
        const fxl_pose again = pose_number(number);
        frame_draw_pose(drawn, &again, whole, HEIGHT, BACKGROUND);
        TEST_ASSERT_EQUAL_MEMORY(whole, other, sizeof whole);
    }
}

void test_bands_in_two_workspaces_are_the_frame(void)
{
    start();
    const size_t least = fxl_workspace_size(&renderer);
    TEST_ASSERT_TRUE(least > 0 && least <= ROOM / 2);
    for (size_t size = least; size <= ROOM; size += ROOM / 4) {
        TEST_ASSERT_EQUAL(FXL_OK, fxl_workspace_init(&second, &renderer, rooms[1], size));
        expect_the_same(12);
    }
}

/* A clipper and a target with workspaces of their own. */
void test_a_second_workspace_has_memory_of_its_own(void)
{
    static const fxl_clipper counting = {.clip = fxl_clip_by_view,
                                         .workspace_size = sizeof(fxl_clip_stats)};
    static FXL_ALIGN_8 fxl_clip_stats counts;
    start_with_list(0); /* every band clips its faces */
    TEST_ASSERT_EQUAL(FXL_OK,
                      fxl_renderer_set_clipper(&renderer, &counting, &counts, sizeof counts));
    TEST_ASSERT_EQUAL(FXL_OK, choice_take(&renderer, &choice_spans, rooms[0], ROOM));
    const size_t least = fxl_workspace_size(&renderer);
    TEST_ASSERT_TRUE(least > counting.workspace_size && least <= ROOM);
    memset(rooms[1], 0x5A, ROOM);
    TEST_ASSERT_EQUAL(FXL_E_CAPACITY, fxl_workspace_init(&second, &renderer, rooms[1], least - 1));
    TEST_ASSERT_EACH_EQUAL_HEX8(0x5A, rooms[1], ROOM);
    TEST_ASSERT_EQUAL(FXL_OK, fxl_workspace_init(&second, &renderer, rooms[1], least));
    const fxl_clip_stats *others = (const fxl_clip_stats *)second.cache.clipper_workspace;
    TEST_ASSERT_TRUE(others != &counts && others->distances == 0);
    expect_the_same(12);
    TEST_ASSERT_TRUE(counts.distances > 0 && others->distances > 0);
    for (size_t i = least; i < ROOM; i++) {
        TEST_ASSERT_EQUAL_HEX8(0x5A, rooms[1][i]);
    }
}

void test_a_workspace_of_other_settings_is_refused(void)
{
    const fxl_band band = UNIT_BAND(other, WIDTH, 0, HEIGHT);
    const fxl_pose pose = pose_number(1);
    start();
    TEST_ASSERT_EQUAL(FXL_OK, fxl_workspace_init(&second, &renderer, rooms[1], ROOM));
    TEST_ASSERT_EQUAL(FXL_E_ORDER, fxl_frame_draw_with(&renderer, &second, &band));
    TEST_ASSERT_EQUAL(FXL_OK, fxl_renderer_set_clipper(&renderer, &fxl_clipper_view, NULL, 0));
    TEST_ASSERT_EQUAL(FXL_OK, fxl_frame_begin(&renderer, &pose));
    TEST_ASSERT_EQUAL(FXL_E_ORDER, fxl_frame_draw_with(&renderer, &second, &band));
    TEST_ASSERT_EQUAL_UINT32(2, second.counters.refused_calls);
    TEST_ASSERT_EQUAL(FXL_OK, fxl_workspace_init(&second, &renderer, rooms[1], ROOM));
    TEST_ASSERT_EQUAL(FXL_OK, fxl_frame_draw_with(&renderer, &second, &band));
    start(); /* no setting was changed yet */
    TEST_ASSERT_EQUAL(FXL_OK, fxl_frame_begin(&renderer, &pose));
    memset(&second, 0, sizeof second);
    TEST_ASSERT_EQUAL(FXL_E_ORDER, fxl_frame_draw_with(&renderer, &second, &band));
    TEST_ASSERT_EQUAL(FXL_E_ARGUMENT, fxl_frame_draw_with(&renderer, NULL, &band));
    TEST_ASSERT_EQUAL(FXL_E_ARGUMENT, fxl_frame_draw_with(NULL, &second, &band));
}

void test_a_clipper_of_zeros_and_no_target_are_refused(void)
{
    static const fxl_clipper no_clipper;
    const fxl_config no_target = fxl_config_for(WIDTH, HEIGHT, NULL);
    start();
    const fxl_clipper *clipper = renderer.clipper;
    const fxl_target *target = renderer.target;
    TEST_ASSERT_EQUAL(FXL_E_ARGUMENT, fxl_renderer_set_clipper(&renderer, &no_clipper, NULL, 0));
    TEST_ASSERT_EQUAL(FXL_E_ARGUMENT, fxl_renderer_choose(&renderer, &no_target));
    TEST_ASSERT_EQUAL_PTR(clipper, renderer.clipper);
    TEST_ASSERT_EQUAL_PTR(target, renderer.target);
    TEST_ASSERT_EQUAL_UINT32(2, renderer.workspace.counters.refused_calls);
}

void test_a_workspace_that_cannot_be_is_refused_and_untouched(void)
{
    start();
    const size_t least = fxl_workspace_size(&renderer);
    memset(&second, 0x5A, sizeof second);
    TEST_ASSERT_EQUAL(FXL_E_ARGUMENT, fxl_workspace_init(&second, NULL, rooms[1], ROOM));
    TEST_ASSERT_EQUAL(FXL_E_ARGUMENT, fxl_workspace_init(NULL, &renderer, rooms[1], ROOM));
    TEST_ASSERT_EQUAL(FXL_E_ARGUMENT, fxl_workspace_init(&second, &renderer, NULL, ROOM));
    TEST_ASSERT_EQUAL(FXL_E_ARGUMENT,
                      fxl_workspace_init(&renderer.workspace, &renderer, rooms[1], ROOM));
    TEST_ASSERT_EQUAL(FXL_E_ALIGNMENT,
                      fxl_workspace_init(&second, &renderer, rooms[1] + 4, ROOM - 4));
    TEST_ASSERT_EQUAL(FXL_E_CAPACITY, fxl_workspace_init(&second, &renderer, rooms[1], least - 1));
    renderer.order = NULL; /* as fxl_renderer_init_bare leaves it */
    TEST_ASSERT_EQUAL(0, fxl_workspace_size(&renderer));
    memset(&renderer, 0, sizeof renderer);
    TEST_ASSERT_EQUAL(0, fxl_workspace_size(&renderer));
    TEST_ASSERT_EQUAL(FXL_E_ORDER, fxl_workspace_init(&second, &renderer, rooms[1], ROOM));
    TEST_ASSERT_EACH_EQUAL_HEX8(0x5A, &second, sizeof second);
}

/* The record that it was moved from is overwritten: no pointer leads there. */
void test_a_renderer_may_be_moved(void)
{
    FXL_STATIC_ASSERT(sizeof renderer <= sizeof rooms, "it is moved there");
    fxl_renderer *moved = (fxl_renderer *)(void *)rooms;
    const fxl_pose pose = pose_number(2);
    start();
    frame_draw_pose(&renderer, &pose, whole, HEIGHT, BACKGROUND);
    *moved = renderer;
    memset(&renderer, 0x5A, sizeof renderer);
    frame_draw_pose(moved, &pose, other, HEIGHT, BACKGROUND);
    TEST_ASSERT_EQUAL_MEMORY(whole, other, sizeof whole);
    TEST_ASSERT_EACH_EQUAL_HEX8(0x5A, &renderer, sizeof renderer);
}

/* A clipper that needs no workspace writes only into one that holds its counts. */
void test_counts_want_a_workspace_that_holds_them(void)
{
    static struct {
        FXL_ALIGN_8 fxl_clip_stats stats;
        uint8_t guard[8];
    } room;
    static const fxl_clipper *const clippers[] = {&fxl_clipper_view, &fxl_clipper_world};
    const fxl_pose pose = pose_number(6);
    const fxl_band band = UNIT_BAND(other, WIDTH, 0, HEIGHT);
    for (int i = 0; i < 2; i++) {
        start();
        memset(&room, 0x5A, sizeof room);
        TEST_ASSERT_EQUAL(FXL_OK, fxl_renderer_set_clipper(&renderer, clippers[i], &room, 0));
        TEST_ASSERT_EQUAL(
            FXL_OK, fxl_renderer_set_clipper(&renderer, clippers[i], (uint8_t *)&room + 4, 0));
        for (uint32_t size = 1; size < sizeof(fxl_clip_stats); size++) {
            TEST_ASSERT_EQUAL(FXL_E_CAPACITY,
                              fxl_renderer_set_clipper(&renderer, clippers[i], &room, size));
        }
        TEST_ASSERT_EQUAL(FXL_E_ALIGNMENT, fxl_renderer_set_clipper(&renderer, clippers[i],
                                                                    (uint8_t *)&room + 4, 64));
        TEST_ASSERT_EQUAL(FXL_OK, fxl_frame_begin(&renderer, &pose));
        TEST_ASSERT_EQUAL(FXL_OK, fxl_frame_draw(&renderer, &band));
        TEST_ASSERT_EACH_EQUAL_HEX8(0x5A, &room, sizeof room);
        room.stats = (fxl_clip_stats){0, 0, 0};
        TEST_ASSERT_EQUAL(FXL_OK, fxl_renderer_set_clipper(&renderer, clippers[i], &room,
                                                           sizeof(fxl_clip_stats)));
        TEST_ASSERT_EQUAL(FXL_OK, fxl_frame_begin(&renderer, &pose));
        TEST_ASSERT_TRUE(room.stats.distances > 0);
        TEST_ASSERT_EACH_EQUAL_HEX8(0x5A, room.guard, sizeof room.guard);
    }
}

static fxl_status init_with(const fxl_lens *lens, const fxl_memory *tables)
{
    return fxl_renderer_init_with(&renderer, &checked_scene()->scene, lens, tables);
}

void test_a_lens_that_no_function_made_is_refused(void)
{
    const fxl_lens good = unit_lens(WIDTH, HEIGHT);
    const fxl_memory tables = memory();
    const fxl_lens zero = {0};
    memset(&renderer, 0x5A, sizeof renderer);
    TEST_ASSERT_EQUAL(FXL_E_RANGE, init_with(&zero, &tables));
    for (int member = 0; member < 6; member++) {
        for (int sign = -1; sign <= 1; sign += 2) {
            fxl_lens lens = good;
            lens.width = member == 0 ? (uint16_t)(sign < 0 ? 0 : FXL_SCREEN_MAX + 1) : lens.width;
            lens.height = member == 1 ? (uint16_t)(sign < 0 ? 0 : FXL_SCREEN_MAX + 1) : lens.height;
            lens.focal = member == 2 ? lens.focal * (sign < 0 ? -1 : 50) : lens.focal;
            lens.near_z = member == 3 ? (sign < 0 ? 0 : lens.far_z) : lens.near_z;
            lens.far_z = member == 4 ? (sign < 0 ? -1 : FXL_FAR_MAX + 1) : lens.far_z;
            lens.inset = member == 5 ? (sign < 0 ? -1 : FXL_INSET_MAX + 1) : lens.inset;
            TEST_ASSERT_EQUAL(FXL_E_RANGE, init_with(&lens, &tables));
        }
    }
    TEST_ASSERT_EACH_EQUAL_HEX8(0x5A, &renderer, sizeof renderer);
    for (fxl_angle fov = FXL_FOV_MIN; fov < FXL_FOV_MAX; fov += (FXL_FOV_MAX - FXL_FOV_MIN) / 7) {
        fxl_lens lens;
        for (uint32_t width = 1; width <= FXL_SCREEN_MAX; width = 2 * width + 1) {
            TEST_ASSERT_EQUAL(FXL_OK, fxl_lens_from_fov((uint16_t)width, 1, fov, FXL_NEAR_MIN,
                                                        FXL_FAR_MAX, 0, &lens));
            TEST_ASSERT_TRUE(fxl_lens_is_valid(&lens));
        }
    }
}

void test_tables_that_are_not_aligned_are_refused(void)
{
    const fxl_lens lens = unit_lens(WIDTH, HEIGHT);
    fxl_memory tables = memory();
    memset(&renderer, 0x5A, sizeof renderer);
    for (uint32_t off = 1; off < 4; off++) {
        tables.draw_list = (fxl_draw_entry *)(void *)((uint8_t *)order + off);
        TEST_ASSERT_EQUAL(FXL_E_ALIGNMENT, init_with(&lens, &tables));
        tables = memory();
        tables.display_list = (uint32_t *)(void *)((uint8_t *)list + off);
        TEST_ASSERT_EQUAL(FXL_E_ALIGNMENT, init_with(&lens, &tables));
        tables = memory();
    }
    tables.cache_capacity = 4;
    for (uint32_t off = 1; off < 8; off++) {
        tables.cache = (fxl_cached_vertex *)(void *)(rooms[0] + off);
        TEST_ASSERT_EQUAL(FXL_E_ALIGNMENT, init_with(&lens, &tables));
    }
    TEST_ASSERT_EACH_EQUAL_HEX8(0x5A, &renderer, sizeof renderer);
}

void test_settings_of_a_renderer_that_is_not_initialised(void)
{
    static const fxl_beam beam;
    static const uint8_t lit[256];
    const fxl_beam_set beams = {&beam, 1, lit};
    memset(&renderer, 0, sizeof renderer);
    TEST_ASSERT_EQUAL(FXL_E_ORDER, choice_take(&renderer, &choice_spans, rooms[0], ROOM));
    TEST_ASSERT_EQUAL(FXL_E_ORDER, fxl_renderer_set_clipper(&renderer, &fxl_clipper_view, NULL, 0));
    TEST_ASSERT_EQUAL(FXL_E_ORDER, fxl_attach_beams(&renderer, &beams, rooms[0], ROOM));
    TEST_ASSERT_EQUAL_UINT32(3, renderer.workspace.counters.refused_calls);
    TEST_ASSERT_TRUE(renderer.target == NULL && renderer.order == NULL);
    TEST_ASSERT_NULL(renderer.clipper);
}

void test_face_bounds_without_a_table_are_refused(void)
{
    tiny_scene *tiny = tiny_make();
    fxl_scene_fault fault = {"", 0};
    tiny->scene.face_bounds = NULL;
    for (int i = 0; i < 2; i++) {
        tiny->models[i].first_face_bounds = 0;
    }
    tiny->scene.face_bounds_count = 6;
    TEST_ASSERT_EQUAL(FXL_E_COUNT, fxl_scene_check(&tiny->scene, &fault));
    tiny->scene.face_bounds_count = 0;
    TEST_ASSERT_EQUAL(FXL_OK, fxl_scene_check(&tiny->scene, &fault));
}

/* A workspace needs a renderer with both settings, and memory at eight bytes. */
void test_when_a_workspace_can_be_set_up(void)
{
    const fxl_lens lens = unit_lens(WIDTH, HEIGHT);
    const fxl_memory tables = memory();
    const fxl_scene *scene = &checked_scene()->scene;
    TEST_ASSERT_EQUAL(0, fxl_workspace_size(NULL));
    for (int settings = 0; settings < 4; settings++) {
        const bool both = settings == 3;
        TEST_ASSERT_EQUAL(FXL_OK, fxl_renderer_init_bare(&renderer, scene, &lens, &tables));
        if (settings & 1) {
            TEST_ASSERT_EQUAL(FXL_OK,
                              fxl_renderer_set_clipper(&renderer, &fxl_clipper_view, NULL, 0));
        }
        if (settings & 2) {
            TEST_ASSERT_EQUAL(FXL_OK, choice_take(&renderer, &choice_sorted, NULL, 0));
        }
        TEST_ASSERT_EQUAL(both, fxl_workspace_size(&renderer) > 0);
        TEST_ASSERT_EQUAL(both ? FXL_OK : FXL_E_ORDER,
                          fxl_workspace_init(&second, &renderer, rooms[1], ROOM));
    }
    for (uint32_t off = 1; off < 8; off++) {
        TEST_ASSERT_EQUAL(FXL_E_ALIGNMENT,
                          fxl_workspace_init(&second, &renderer, rooms[1] + off, ROOM - 8));
    }
    TEST_ASSERT_EQUAL(FXL_E_CAPACITY, fxl_workspace_init(&second, &renderer, NULL, 0));
}

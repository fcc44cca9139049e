/* SPDX-License-Identifier: MIT */
/* How memory for a workspace, or for a visibility method, is divided into parts, and what a workspace
 * is set up for. */
#include "tiny_frames.h"
#include "../../lib/draw/renderer.h"
#include "choices.h"
#include "tiny.h"
#include "study/targets.h"

enum {
    WIDTH = 24,
    HEIGHT = 16,
    ROOM = 1600
};

static fxl_draw_entry order[TINY_INSTANCES + 6];
static FXL_ALIGN_8 uint8_t rooms[2][ROOM];
static fxl_renderer renderer;
static fxl_workspace second;

static void start(void)
{
    const fxl_memory tables = {order, TINY_INSTANCES + 6, NULL, 0, NULL, 0};
    tiny_start(&renderer, tiny_make(), WIDTH, HEIGHT, &tables);
}

/* What is over beyond the least keeps vertices: a power of two of them, and no more than the
 * largest model has. Each part follows the one before. */
void test_what_is_over_keeps_vertices(void)
{
    static const uint8_t kept[] = {0, 1, 2, 2, 4, 4, 4, 4, 8, 8};
    start();
    const size_t least = fxl_workspace_size(&renderer), vertex = sizeof(fxl_cached_vertex);
    TEST_ASSERT_EQUAL(6 * sizeof(fxl_draw_entry), least); /* the faces of the sorted model */
    for (size_t n = 0; n < sizeof kept; n++) {
        const size_t sizes[] = {least + n * vertex, least + (n + 1) * vertex - 1};
        for (int i = 0; i < 2; i++) {
            TEST_ASSERT_EQUAL(FXL_OK, fxl_workspace_init(&second, &renderer, rooms[1], sizes[i]));
            TEST_ASSERT_EQUAL_PTR(kept[n] > 0 ? rooms[1] + least : NULL, second.cache.entries);
            TEST_ASSERT_EQUAL_UINT32(kept[n] > 0 ? kept[n] - 1u : 0, second.cache.mask);
        }
        TEST_ASSERT_EQUAL_PTR(rooms[1], second.face_list);
        TEST_ASSERT_NULL(second.cache.clipper_workspace);
        TEST_ASSERT_NULL(second.target_memory);
        TEST_ASSERT_EQUAL_UINT32(0, second.target_memory_size);
    }
}

/* The bytes that a method's submit function asks for in the test below; not a multiple of 8. */
static uint32_t eleven_bytes(const fxl_scene *scene)
{
    (void)scene;
    return 11;
}

static uint32_t forty_bytes(const fxl_lens *lens)
{
    TEST_ASSERT_EQUAL_UINT16(WIDTH, lens->width);
    return 40;
}

/* The order's memory is zeroed, and no byte after it, where its size is no multiple of 8. */
void test_an_order_and_a_target_with_memory(void)
{
    static fxl_target target;
    static choice both;
    target = fxl_palette;
    target.memory_size = forty_bytes;
    both = choice_sorted;
    static fxl_order eleven;
    eleven = fxl_by_distance;
    eleven.memory_size = eleven_bytes;
    both.order = &eleven;
    both.target = &target;
    start();
    memset(rooms[0], 0x5A, ROOM);
    for (uint32_t size = 0; size < 56; size++) { /* of 11 to 15 the target begins at no multiple of 8 */
        TEST_ASSERT_EQUAL(size / 8 == 1 && size >= 11 ? FXL_E_ALIGNMENT : FXL_E_CAPACITY,
                          choice_take(&renderer, &both, rooms[0], size));
    }
    TEST_ASSERT_EACH_EQUAL_HEX8(0x5A, rooms[0], ROOM);
    for (uint32_t size = 56; size < 64; size++) {
        TEST_ASSERT_EQUAL(FXL_OK, choice_take(&renderer, &both, rooms[0], size));
        TEST_ASSERT_EQUAL_PTR(rooms[0], renderer.order_memory);
        TEST_ASSERT_EQUAL_PTR(rooms[0] + 16, renderer.workspace.target_memory);
        TEST_ASSERT_EQUAL_UINT32(size - 16, renderer.workspace.target_memory_size);
    }
    TEST_ASSERT_EACH_EQUAL_HEX8(0, rooms[0], 11);
    TEST_ASSERT_EACH_EQUAL_HEX8(0x5A, rooms[0] + 11, ROOM - 11);
    fxl_config config = fxl_config_for(1, 1, &fxl_palette);
    config.order = &eleven;
    config.tree = rooms[0];
    config.tree_size = 10;
    TEST_ASSERT_EQUAL(FXL_E_CAPACITY, fxl_renderer_choose(&renderer, &config));
    config.tree_size = 11;
    TEST_ASSERT_EQUAL(FXL_OK, fxl_renderer_choose(&renderer, &config));
    TEST_ASSERT_EQUAL(FXL_OK, choice_take(&renderer, &choice_sorted, NULL, 0));
    TEST_ASSERT_NULL(renderer.workspace.target_memory);
    TEST_ASSERT_EQUAL_UINT32(0, renderer.workspace.target_memory_size);
}

/* The order of the parts: faces, clipper, vertices, target. Each begins at a multiple of 8
 * bytes; only the clipper's is zeroed. */
void test_the_parts_of_a_workspace_follow_each_other(void)
{
    static const fxl_clipper one = {.clip = fxl_clip_by_view, .workspace_size = 1};
    static const fxl_clipper nine = {.clip = fxl_clip_by_view, .workspace_size = 9};
    static fxl_target target;
    static choice method;
    target = fxl_palette;
    target.memory_size = forty_bytes;
    method = choice_sorted;
    method.target = &target;
    start();
    const size_t faces = fxl_workspace_size(&renderer), vertices = 2 * sizeof(fxl_cached_vertex);
    memset(rooms[0], 0x5A, ROOM);
    TEST_ASSERT_EQUAL(FXL_OK, fxl_renderer_set_clipper(&renderer, &one, rooms[0], 1));
    TEST_ASSERT_EQUAL_HEX8(0, rooms[0][0]);
    TEST_ASSERT_EQUAL_HEX8(0x5A, rooms[0][1]);
    TEST_ASSERT_EQUAL(FXL_OK, fxl_renderer_set_clipper(&renderer, &nine, rooms[0], 9));
    TEST_ASSERT_EQUAL(FXL_OK, choice_take(&renderer, &method, rooms[0] + 16, 40));
    const size_t least = faces + 16 + 40, size = least + 4 * vertices;
    TEST_ASSERT_EQUAL(least, fxl_workspace_size(&renderer));
    TEST_ASSERT_TRUE(size <= ROOM);
    for (size_t less = 1; less <= least; less++) {
        TEST_ASSERT_EQUAL(FXL_E_CAPACITY,
                          fxl_workspace_init(&second, &renderer, rooms[1], least - less));
    }
    memset(rooms[1], 0x5A, ROOM);
    TEST_ASSERT_EQUAL(FXL_OK, fxl_workspace_init(&second, &renderer, rooms[1], size));
    TEST_ASSERT_EQUAL_PTR(rooms[1], second.face_list);
    TEST_ASSERT_EQUAL_PTR(rooms[1] + faces, second.cache.clipper_workspace);
    TEST_ASSERT_EQUAL_PTR(rooms[1] + faces + 16, second.cache.entries);
    TEST_ASSERT_EQUAL_PTR(rooms[1] + faces + 16 + vertices, second.target_memory);
    TEST_ASSERT_EQUAL_UINT32(40 + 3 * vertices, second.target_memory_size);
    TEST_ASSERT_EACH_EQUAL_HEX8(0, rooms[1] + faces, 16);
    TEST_ASSERT_EACH_EQUAL_HEX8(0x5A, rooms[1] + faces + 16 + vertices, 40 + 3 * vertices);
    /* A byte less than four times the bytes of two vertices is room for one. */
    TEST_ASSERT_EQUAL(FXL_OK, fxl_workspace_init(&second, &renderer, rooms[1], size - 1));
    TEST_ASSERT_EQUAL_UINT32(0, second.cache.mask);
    TEST_ASSERT_EQUAL_UINT32(40 + 4 * vertices - vertices / 2 - 1, second.target_memory_size);
}

/* Of what is over, a target gets what the vertices do not take of a quarter. */
void test_the_rest_is_the_target_s(void)
{
    start();
    const size_t order_bytes = fxl_workspace_size(&renderer);
    TEST_ASSERT_EQUAL(FXL_OK, choice_take(&renderer, &choice_spans, rooms[0], ROOM));
    const size_t least = fxl_workspace_size(&renderer), vertex = sizeof(fxl_cached_vertex);
    TEST_ASSERT_TRUE(least > order_bytes && least + 8 * vertex <= ROOM);
    for (size_t n = 0; n <= 2; n++) {
        const size_t size = least + 4 * n * vertex;
        TEST_ASSERT_EQUAL(FXL_OK, fxl_workspace_init(&second, &renderer, rooms[1], size));
        uint8_t *const after = rooms[1] + order_bytes + n * vertex;
        TEST_ASSERT_EQUAL_PTR(n > 0 ? rooms[1] + order_bytes : NULL, second.cache.entries);
        TEST_ASSERT_EQUAL_PTR(after, second.target_memory);
        TEST_ASSERT_EQUAL_UINT32(rooms[1] + size - after, second.target_memory_size);
    }
}

void test_the_memory_of_a_clipper_is_aligned(void)
{
    start();
    for (uint32_t off = 1; off < 8; off++) {
        TEST_ASSERT_EQUAL(FXL_E_ALIGNMENT,
                          fxl_renderer_set_clipper(&renderer, &fxl_clipper_view, rooms[0] + off,
                                                   sizeof(fxl_clip_stats)));
    }
}

/* rgb565 3.6a */
/* A power of two of entries, enough for the largest of all models and for no more, as far as the
 * bytes go. */
void test_entries_for_the_largest_model(void)
{
    static const uint32_t counts[][2] = {{3, 4}, {4, 4}, {5, 8}, {8, 8}, {9, 16}, {65535, 65536}};
    const size_t entry = sizeof(fxl_cached_vertex);
    for (size_t i = 0; i < sizeof counts / sizeof counts[0]; i++) {
        for (uint32_t largest = 0; largest < 3; largest++) {
            fxl_model models[3] = {{.vertex_count = 3}, {.vertex_count = 3}, {.vertex_count = 3}};
            const fxl_scene scene = {.models = models, .model_count = 3};
            const uint32_t enough = counts[i][1];
            models[largest].vertex_count = counts[i][0];
            TEST_ASSERT_EQUAL_UINT32(enough, fxl_cache_entries(&scene, SIZE_MAX));
            TEST_ASSERT_EQUAL_UINT32(enough, fxl_cache_entries(&scene, enough * entry));
            TEST_ASSERT_EQUAL_UINT32(enough / 2, fxl_cache_entries(&scene, enough * entry - 1));
            TEST_ASSERT_EQUAL_UINT32(1, fxl_cache_entries(&scene, entry));
            TEST_ASSERT_EQUAL_UINT32(0, fxl_cache_entries(&scene, entry - 1));
        }
    }
}

/* --- a workspace that is older than the settings --------------------------------------------- */

/* A frame of which the second workspace may draw the first rows. */
static fxl_status draw_in_the_second(uint32_t yaw)
{
    static uint8_t pixels[WIDTH * HEIGHT];
    const fxl_pose pose = {{Q16(0.5), Q16(0.25), Q16(-6)}, yaw, 0, 0};
    const fxl_band band = {.pixels = pixels,
                           .width = renderer.frame.view.lens.width,
                           .stride = WIDTH,
                           .rows = 2};
    TEST_ASSERT_EQUAL(FXL_OK, fxl_frame_begin(&renderer, &pose));
    return fxl_frame_draw_with(&renderer, &second, &band);
}

static void start_with_a_second(size_t size)
{
    start();
    TEST_ASSERT_EQUAL(FXL_OK, fxl_workspace_init(&second, &renderer, rooms[1], size));
    TEST_ASSERT_EQUAL(FXL_OK, draw_in_the_second(0));
    memset(&renderer, 0x5A, sizeof renderer); /* fxl_renderer_init reads nothing of it */
}

static fxl_status init_again(const fxl_scene *scene, const fxl_lens *lens)
{
    const fxl_memory tables = {order, TINY_INSTANCES + 6, NULL, 0, NULL, 0};
    return fxl_renderer_init_with(&renderer, scene, lens, &tables);
}

/* rgb565 3.6a */
/* Another scene, also one in the same record; another lens; and other frames of the same ones. */
void test_a_workspace_from_before_init_is_refused(void)
{
    const fxl_lens lens = unit_lens(WIDTH, HEIGHT), narrow = unit_lens(WIDTH - 1, HEIGHT);
    fxl_lens nearer = lens;
    nearer.near_z++;
    start_with_a_second(ROOM);
    fxl_scene *scene = &tiny_make()->scene, other = *scene, larger = *scene;
    fxl_model models[4];
    TEST_ASSERT_TRUE(scene->model_count <= 4);
    memcpy(models, scene->models, scene->model_count * sizeof *models);
    TEST_ASSERT_EQUAL(FXL_OK, fxl_scene_check(scene, NULL));
    TEST_ASSERT_EQUAL(FXL_OK, fxl_scene_check(&other, NULL));
    const struct {
        const fxl_scene *scene;
        const fxl_lens *lens;
        fxl_status status;
    } cases[] = {{&other, &lens, FXL_E_ORDER},
                 {scene, &narrow, FXL_E_ORDER},
                 {scene, &nearer, FXL_E_ORDER},
                 {scene, &lens, FXL_OK}};
    for (uint32_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        start_with_a_second(ROOM);
        TEST_ASSERT_EQUAL(FXL_OK, fxl_scene_check(scene, NULL));
        TEST_ASSERT_EQUAL(FXL_OK, init_again(cases[i].scene, cases[i].lens));
        TEST_ASSERT_EQUAL(cases[i].status, draw_in_the_second(0));
    }
    start_with_a_second(ROOM);
    TEST_ASSERT_EQUAL(FXL_OK, fxl_scene_check(scene, NULL));
    TEST_ASSERT_EQUAL(FXL_OK, init_again(scene, &lens));
    TEST_ASSERT_EQUAL(FXL_E_ORDER, draw_in_the_second(DEGREES(3)));
    TEST_ASSERT_EQUAL(FXL_OK, draw_in_the_second(DEGREES(3)));
    start_with_a_second(ROOM);
    larger.models = models;
    larger.draw_list_needed = TINY_INSTANCES + 6;
    *scene = larger;
    TEST_ASSERT_EQUAL(FXL_OK, init_again(scene, &lens));
    TEST_ASSERT_EQUAL(FXL_E_ORDER, draw_in_the_second(0));
}

/* The same tables with more faces than the workspace has room for. */
void test_a_model_that_has_grown_is_refused(void)
{
    const fxl_lens lens = unit_lens(WIDTH, HEIGHT);
    start_with_a_second(ROOM);
    fxl_scene *scene = &tiny_make()->scene;
    TEST_ASSERT_EQUAL(FXL_OK, fxl_scene_check(scene, NULL));
    TEST_ASSERT_EQUAL(FXL_OK, init_again(scene, &lens));
    second.work.setup.room.face_room--;
    TEST_ASSERT_EQUAL(FXL_E_ORDER, draw_in_the_second(0));
}

/* The number of changes stays at the last one, where no other workspace is taken. The renderer's own
 * draws on, and init begins anew. */
void test_changes_are_counted_to_the_last_number(void)
{
    start();
    TEST_ASSERT_EQUAL(FXL_OK, fxl_workspace_init(&second, &renderer, rooms[1], ROOM));
    renderer.workspace.settings_number += 65536; /* as so many changes do */
    TEST_ASSERT_EQUAL(FXL_E_ORDER, draw_in_the_second(0));
    renderer.workspace.settings_number = UINT32_MAX - 1;
    TEST_ASSERT_EQUAL(FXL_OK, fxl_workspace_init(&second, &renderer, rooms[1], ROOM));
    TEST_ASSERT_EQUAL(FXL_OK, draw_in_the_second(0));
    for (int i = 0; i < 3; i++) {
        TEST_ASSERT_EQUAL(FXL_OK, fxl_renderer_set_clipper(&renderer, &fxl_clipper_view, NULL, 0));
        TEST_ASSERT_EQUAL_HEX32(UINT32_MAX, renderer.workspace.settings_number);
        TEST_ASSERT_EQUAL(FXL_E_ORDER, draw_in_the_second(0));
        TEST_ASSERT_EQUAL(FXL_OK, fxl_workspace_init(&second, &renderer, rooms[1], ROOM));
        TEST_ASSERT_EQUAL(FXL_E_ORDER, draw_in_the_second(0));
    }
    memset(&second, 0, sizeof second);
    TEST_ASSERT_EQUAL(FXL_E_ORDER, draw_in_the_second(0));
    start();
    TEST_ASSERT_EQUAL(FXL_OK, fxl_workspace_init(&second, &renderer, rooms[1], ROOM));
    TEST_ASSERT_EQUAL(FXL_OK, draw_in_the_second(0));
}

/* rgb565 3.6a */
/* A centre of the lens is one of the settings; the same one again is no other. */
void test_a_centre_that_moved_is_another_lens(void)
{
    const fxl_q16_16 x = Q16(WIDTH) / 2, y = Q16(HEIGHT) / 2;
    fxl_lens lens;
    start();
    TEST_ASSERT_EQUAL(FXL_OK, fxl_lens_from_fov(WIDTH, HEIGHT, DEGREES(60), Q16(0.25), Q16(64), 0,
                                                &lens));
    TEST_ASSERT_EQUAL(FXL_OK, init_again(renderer.scene, &lens));
    TEST_ASSERT_EQUAL(FXL_OK, fxl_workspace_init(&second, &renderer, rooms[1], ROOM));
    TEST_ASSERT_EQUAL(FXL_OK, fxl_renderer_set_centre(&renderer, x, y));
    TEST_ASSERT_EQUAL(FXL_OK, draw_in_the_second(0));
    TEST_ASSERT_EQUAL(FXL_OK, fxl_renderer_set_centre(&renderer, x + Q16(1), y));
    TEST_ASSERT_EQUAL(FXL_E_ORDER, draw_in_the_second(0));
    TEST_ASSERT_EQUAL_UINT32(1, second.counters.refused_calls);
}

/* --- a record with other contents: init counts changes anew, so their number is the same ------ */

/* An order that keeps a bit for each node of a tree, of which the scene has so many. */
static fxl_status draw_with_nodes(fxl_scene *scene, uint32_t count, bool sets_up)
{
    static const fxl_bsp_node nodes[33];
    static fxl_order with_tree;
    const fxl_lens lens = unit_lens(WIDTH, HEIGHT);
    const choice pair = {&with_tree, &fxl_palette};
    with_tree = fxl_by_distance;
    with_tree.memory_size = eleven_bytes;
    scene->bsp_nodes = nodes;
    scene->bsp_node_count = count;
    TEST_ASSERT_EQUAL(FXL_OK, init_again(scene, &lens));
    TEST_ASSERT_EQUAL(FXL_OK, choice_take(&renderer, &pair, rooms[0], 16));
    if (sets_up) {
        TEST_ASSERT_EQUAL(FXL_OK, fxl_workspace_init(&second, &renderer, rooms[1], ROOM));
    }
    return draw_in_the_second(0);
}

/* rgb565 3.6a */
void test_a_tree_that_has_grown_is_refused(void)
{
    fxl_scene *scene = &tiny_make()->scene;
    TEST_ASSERT_EQUAL(FXL_OK, fxl_scene_check(scene, NULL));
    TEST_ASSERT_EQUAL(FXL_OK, draw_with_nodes(scene, 1, true));
    TEST_ASSERT_EQUAL(FXL_OK, draw_with_nodes(scene, 32, false));
    TEST_ASSERT_EQUAL(FXL_OK, draw_with_nodes(scene, 32, true));
    TEST_ASSERT_EQUAL(FXL_E_ORDER, draw_with_nodes(scene, 65, false));
}

static fxl_status draw_with_clipper(const fxl_clipper *clipper, bool sets_up)
{
    const fxl_lens lens = unit_lens(WIDTH, HEIGHT);
    TEST_ASSERT_EQUAL(FXL_OK, init_again(renderer.scene, &lens));
    TEST_ASSERT_EQUAL(FXL_OK, fxl_renderer_set_clipper(&renderer, clipper, rooms[0], ROOM));
    if (sets_up) {
        TEST_ASSERT_EQUAL(FXL_OK, fxl_workspace_init(&second, &renderer, rooms[1], ROOM));
    }
    return draw_in_the_second(0);
}

/* rgb565 3.6a */
void test_a_clipper_that_needs_more_is_refused(void)
{
    static fxl_clipper clipper;
    clipper = fxl_clipper_view;
    clipper.workspace_size = 8;
    start();
    TEST_ASSERT_EQUAL(FXL_OK, draw_with_clipper(&clipper, true));
    TEST_ASSERT_EQUAL(FXL_OK, draw_with_clipper(&clipper, false));
    clipper.workspace_size = 16;
    TEST_ASSERT_EQUAL(FXL_E_ORDER, draw_with_clipper(&clipper, false));
    TEST_ASSERT_EQUAL(FXL_OK, draw_with_clipper(&clipper, true));
}

/* Where both the workspace and the band cannot be taken, the band is named. */
void test_a_band_without_pixels_is_no_workspace_of_other_settings(void)
{
    const fxl_band empty = {.width = WIDTH, .stride = WIDTH, .rows = 2};
    start();
    memset(&second, 0, sizeof second);
    TEST_ASSERT_EQUAL(FXL_E_ORDER, draw_in_the_second(0));
    TEST_ASSERT_EQUAL(FXL_E_ARGUMENT, fxl_frame_draw_with(&renderer, &second, NULL));
    TEST_ASSERT_EQUAL(FXL_E_ARGUMENT, fxl_frame_draw_with(&renderer, &second, &empty));
    TEST_ASSERT_EQUAL_UINT32(3, second.counters.refused_calls);
}

/* A workspace of zeros and a renderer of zeros have seen the same number of changes. */
void test_a_renderer_of_zeros_has_no_workspace(void)
{
    static uint8_t pixels[WIDTH * 2];
    const fxl_band band = {.pixels = pixels, .width = WIDTH, .stride = WIDTH, .rows = 2};
    memset(&renderer, 0, sizeof renderer);
    memset(&second, 0, sizeof second);
    TEST_ASSERT_EQUAL(FXL_E_ORDER, fxl_frame_draw_with(&renderer, &second, &band));
    TEST_ASSERT_EQUAL_UINT32(1, second.counters.refused_calls);
    TEST_ASSERT_EACH_EQUAL_HEX8(0, pixels, sizeof pixels);
}

/* SPDX-License-Identifier: MIT */
/* Whole frames by lenses whose centre is not the middle of the screen: tiles of one picture, by
 * every clipper and by methods that decide in another order. */
#include "frame_bands.h"
#include "choices.h"
#include "clippers_list.h"
#include "tiny.h"
#include "tiny_frames.h"
#include "study/targets.h"

enum {
    WIDTH = 48,
    HEIGHT = 32,
    PIXELS = WIDTH * HEIGHT,
    COLUMNS = 2,
    ROWS = 2,
    TILE_WIDTH = WIDTH / COLUMNS,
    TILE_HEIGHT = HEIGHT / ROWS,
    BACKGROUND = 200,
    SPANS_SIZE = 4096
};

static fxl_clipper_workspace room;
static uint64_t spans[SPANS_SIZE / 8];
static uint8_t whole[PIXELS], tiled[PIXELS];
static fxl_draw_entry order[64];
static fxl_cached_vertex cache[8];
static fxl_renderer renderer;

static fxl_lens whole_lens(void)
{
    fxl_lens lens;
    TEST_ASSERT_EQUAL(FXL_OK, fxl_lens_from_fov(WIDTH, HEIGHT, FXL_ANGLE_QUARTER, Q16(0.0625),
                                                Q16(1000), 0, &lens));
    return lens;
}

static tiny_scene *checked_scene(void)
{
    tiny_scene *tiny = tiny_make();
    fxl_scene_fault fault = {"", 0};
    TEST_ASSERT_EQUAL_MESSAGE(FXL_OK, fxl_scene_check(&tiny->scene, &fault), fault.what);
    return tiny;
}

static void start(const fxl_lens *lens, const fxl_clipper *clipper, const choice *visibility)
{
    const fxl_memory memory = {order, 64, NULL, 0, cache, 8};
    TEST_ASSERT_EQUAL(FXL_OK,
                      fxl_renderer_init_with(&renderer, &checked_scene()->scene, lens, &memory));
    if (clipper != NULL) {
        TEST_ASSERT_EQUAL(
            FXL_OK, fxl_renderer_set_clipper(&renderer, clipper, &room, clipper->workspace_size));
    }
    TEST_ASSERT_EQUAL(FXL_OK, choice_take(&renderer, visibility, spans, sizeof spans));
}

/* Draws the frame into pixels of rows of WIDTH. */
static void draw(const fxl_pose *pose, uint8_t *pixels)
{
    const fxl_lens *lens = &renderer.frame.view.lens;
    const fxl_band band = {.pixels = pixels,
                           .width = lens->width,
                           .stride = WIDTH,
                           .first_row = 0,
                           .rows = lens->height};
    TEST_ASSERT_EQUAL(FXL_OK, fxl_frame_begin(&renderer, pose));
    fxl_fill_band(&band, BACKGROUND);
    TEST_ASSERT_EQUAL(FXL_OK, fxl_frame_draw(&renderer, &band));
    TEST_ASSERT_EQUAL_UINT32(0, renderer.workspace.counters.refused);
}

/* Draws the picture of `whole` as tiles. */
static void draw_tiles(const fxl_pose *pose, const fxl_clipper *clipper, const choice *visibility)
{
    const fxl_lens lens = whole_lens();
    for (int y = 0; y < HEIGHT; y += TILE_HEIGHT) {
        for (int x = 0; x < WIDTH; x += TILE_WIDTH) {
            fxl_lens tile;
            TEST_ASSERT_EQUAL(FXL_OK, fxl_lens_of_part(&lens, (int16_t)x, (int16_t)y, TILE_WIDTH,
                                                       TILE_HEIGHT, &tile));
            start(&tile, clipper, visibility);
            draw(pose, tiled + y * WIDTH + x);
        }
    }
}

static uint32_t drawn, differing;

static void compare(const fxl_pose *pose, const fxl_clipper *clipper, const choice *visibility)
{
    const fxl_lens lens = whole_lens();
    start(&lens, clipper, visibility);
    draw(pose, whole);
    draw_tiles(pose, clipper, visibility);
    for (int i = 0; i < PIXELS; i++) {
        drawn += whole[i] != BACKGROUND;
        differing += whole[i] != tiled[i];
    }
}

/* Outlines are within two units of 1/65536 pixel of those of the whole, so of all pixels of all
 * rounds none has its centre that near to an edge; and the numbers are the same in every run. */
void test_tiles_are_the_picture(void)
{
    drawn = differing = 0;
    for (int round = 0; round < UNIT_REPEAT / 100; round++) {
        const fxl_pose pose = tiny_pose_between();
        compare(&pose, NULL, &choice_sorted);
    }
    TEST_ASSERT_EQUAL_UINT32(0, differing);
    TEST_ASSERT_TRUE(drawn > PIXELS);
}

void test_tiles_by_every_clipper(void)
{
    for (int which = 0; which < CLIPPERS; which++) {
        drawn = differing = 0;
        for (int round = 0; round < UNIT_REPEAT / 100; round++) {
            const fxl_pose pose = tiny_pose_between();
            compare(&pose, clippers[which], &choice_sorted);
        }
        TEST_ASSERT_EQUAL_UINT32(0, differing);
        TEST_ASSERT_TRUE(drawn > PIXELS / 4);
    }
}

void test_tiles_by_the_clipper_in_the_world(void)
{
    drawn = differing = 0;
    for (int round = 0; round < UNIT_REPEAT / 100; round++) {
        const fxl_pose pose = tiny_pose_between();
        compare(&pose, &fxl_clipper_world, &choice_sorted);
    }
    TEST_ASSERT_TRUE(differing <= drawn / 1000);
    TEST_ASSERT_TRUE(drawn > PIXELS / 4);
}

void test_tiles_by_other_visibility_methods(void)
{
    const choice *const methods[] = {&choice_box, &choice_spans, &choice_spans_box};
    for (int which = 0; which < 3; which++) {
        drawn = differing = 0;
        for (int round = 0; round < UNIT_REPEAT / 100; round++) {
            const fxl_pose pose = tiny_pose_between();
            compare(&pose, NULL, methods[which]);
        }
        TEST_ASSERT_EQUAL_UINT32(0, differing);
        TEST_ASSERT_TRUE(drawn > PIXELS / 4);
    }
}

/* --- a centre that moves ------------------------------------------------------------------ */

void test_a_renderer_moves_its_centre(void)
{
    const fxl_lens lens = whole_lens();
    for (int round = 0; round < UNIT_REPEAT / 100; round++) {
        const fxl_pose pose = tiny_pose_between(), other = tiny_pose_between();
        const fxl_q16_16 x = unit_between(Q16(-WIDTH), Q16(2 * WIDTH));
        const fxl_q16_16 y = unit_between(Q16(-HEIGHT), Q16(2 * HEIGHT));
        fxl_lens moved = lens;
        TEST_ASSERT_EQUAL(FXL_OK, fxl_lens_set_centre(&moved, x, y));
        start(&moved, NULL, &choice_sorted);
        draw(&pose, whole);
        start(&lens, NULL, &choice_sorted);
        draw(&other, tiled);
        TEST_ASSERT_EQUAL(FXL_OK, fxl_renderer_set_centre(&renderer, x, y));
        const fxl_band band = UNIT_BAND(tiled, WIDTH, 0, HEIGHT);
        TEST_ASSERT_EQUAL(FXL_E_ORDER, fxl_frame_draw(&renderer, &band));
        draw(&pose, tiled);
        TEST_ASSERT_EQUAL_MEMORY(whole, tiled, PIXELS);
        TEST_ASSERT_EQUAL(FXL_OK,
                          fxl_renderer_set_centre(&renderer, Q16(WIDTH / 2), Q16(HEIGHT / 2)));
        draw(&pose, tiled);
        start(&lens, NULL, &choice_sorted);
        draw(&pose, whole);
        TEST_ASSERT_EQUAL_MEMORY(whole, tiled, PIXELS);
    }
}

/* A workspace tells frames apart by their number, which a moved centre does not set back. */
void test_frames_go_on_counting(void)
{
    const fxl_lens lens = whole_lens();
    const fxl_pose pose = {{0, 0, Q16(-3)}, 0, 0, 0};
    start(&lens, &fxl_clipper_normalised, &choice_sorted);
    draw(&pose, tiled);
    TEST_ASSERT_EQUAL(FXL_OK, fxl_renderer_set_centre(&renderer, Q16(10), Q16(12)));
    draw(&pose, tiled);
    TEST_ASSERT_EQUAL_UINT32(2, renderer.frame.view.frame);
    const fxl_lens moved = renderer.frame.view.lens;
    start(&moved, &fxl_clipper_normalised, &choice_sorted);
    draw(&pose, whole);
    TEST_ASSERT_EQUAL_MEMORY(whole, tiled, PIXELS);
}

void test_a_wrong_centre_changes_nothing(void)
{
    const fxl_lens lens = whole_lens();
    const fxl_pose pose = {{0, 0, Q16(-3)}, 0, 0, 0};
    start(&lens, NULL, &choice_sorted);
    draw(&pose, whole);
    TEST_ASSERT_EQUAL(FXL_E_ARGUMENT, fxl_renderer_set_centre(NULL, 0, 0));
    TEST_ASSERT_EQUAL(FXL_E_RANGE, fxl_renderer_set_centre(&renderer, Q16(2 * WIDTH) + 1, 0));
    TEST_ASSERT_EQUAL_UINT32(1, renderer.workspace.counters.refused_calls);
    frame_draw_bands(&renderer, tiled, HEIGHT, BACKGROUND);
    TEST_ASSERT_EQUAL_MEMORY(whole, tiled, PIXELS);
    memset(&renderer, 0, sizeof renderer);
    TEST_ASSERT_EQUAL(FXL_E_ORDER, fxl_renderer_set_centre(&renderer, 0, 0));
}

/* SPDX-License-Identifier: MIT */
/* The family's clippers in a renderer: whole frames. */
#include "clippers_list.h"
#include "frame_bands.h"
#include "tiny.h"
#include "tiny_frames.h"

enum {
    WIDTH = 48,
    HEIGHT = 32,
    PIXELS = WIDTH * HEIGHT,
    BACKGROUND = 200,
    LIST_WORDS = 40 * FXL_DISPLAY_LIST_WORDS(8),
    GUARD = 64
};

/* Room and what must not be touched behind it. */
static struct {
    fxl_clipper_workspace room;
    uint8_t guard[GUARD];
} rooms[2];

static uint8_t frames[3][PIXELS];
static fxl_draw_entry order[64];
static uint32_t list[LIST_WORDS];
static fxl_cached_vertex cache[9];
static fxl_renderer renderer;

static void start(uint32_t list_words, uint32_t entries)
{
    tiny_scene *tiny = tiny_make();
    const fxl_memory memory = {order, 64, list, list_words, cache, entries};
    tiny_start(&renderer, tiny, WIDTH, HEIGHT, &memory);
}

static void draw(const fxl_pose *pose, uint32_t rows, uint8_t *frame)
{
    frame_draw_pose(&renderer, pose, frame, rows, BACKGROUND);
}

static void set_clipper(const fxl_clipper *clipper, void *room)
{
    TEST_ASSERT_EQUAL(FXL_OK,
                      fxl_renderer_set_clipper(&renderer, clipper, room, clipper->workspace_size));
}

/* Outlines are less than a hundredth of a pixel apart, so a pixel differs only on an
 * edge, and seldom; whatever bands, list and cache there are, it is the same. */
/* clippers 4.3c-d */
void test_all_draw_the_same_frames(void)
{
    const int rounds = UNIT_REPEAT / 100;
    int differing = 0;
    uint32_t clipped = 0;
    for (int round = 0; round < rounds; round++) {
        fxl_pose pose = tiny_pose_between();
        start(LIST_WORDS, 0);
        draw(&pose, HEIGHT, frames[0]);
        uint32_t in = renderer.workspace.counters.in,
                 backfacing = renderer.workspace.counters.backfacing;
        for (int which = 0; which < CLIPPERS; which++) {
            memset(&rooms[0], 0x5A, sizeof rooms[0]);
            start(LIST_WORDS, 9);
            set_clipper(clippers[which], &rooms[0].room);
            draw(&pose, HEIGHT, frames[1]);
            fxl_counters counters = renderer.workspace.counters;
            clipped += counters.clipped;
            TEST_ASSERT_EQUAL_UINT32(in, counters.in);
            TEST_ASSERT_EQUAL_UINT32(backfacing, counters.backfacing);
            TEST_ASSERT_EQUAL_UINT32(in, counters.backfacing + counters.outside +
                                             counters.degenerate + counters.refused +
                                             counters.drawn);
            TEST_ASSERT_EQUAL_UINT32(0, counters.refused);
            for (int i = 0; i < PIXELS; i++) {
                differing += frames[0][i] != frames[1][i];
                TEST_ASSERT_TRUE(frame_has_near(frames[0], WIDTH, HEIGHT, i, frames[1][i]));
            }
            start((uint32_t)unit_between(0, 60), (uint32_t)unit_between(0, 9));
            set_clipper(clippers[which], &rooms[0].room);
            draw(&pose, (uint32_t)unit_between(1, HEIGHT), frames[2]);
            TEST_ASSERT_EQUAL_MEMORY(frames[1], frames[2], PIXELS);
            renderer.workspace.counters.spilled = counters.spilled;
            TEST_ASSERT_EQUAL_MEMORY(&counters, &renderer.workspace.counters, sizeof counters);
            const uint8_t *behind = (const uint8_t *)&rooms[0] + clippers[which]->workspace_size;
            TEST_ASSERT_EACH_EQUAL_HEX8(0x5A, behind,
                                        sizeof rooms[0] - clippers[which]->workspace_size);
        }
    }
    TEST_ASSERT_TRUE(clipped > (uint32_t)rounds);
    TEST_ASSERT_TRUE(differing <= 1 + rounds / 10);
}

/* Every clipper may follow every other, also in the same room. */
void test_the_clipper_may_change_between_frames(void)
{
    start(LIST_WORDS, 9);
    for (int round = 0; round < 40; round++) {
        fxl_pose pose = tiny_pose_between();
        int which = unit_between(0, CLIPPERS - 1), other = unit_between(0, CLIPPERS - 1);
        set_clipper(clippers[which], &rooms[0].room);
        draw(&pose, HEIGHT, frames[0]);
        set_clipper(clippers[other], &rooms[1].room);
        draw(&pose, HEIGHT, frames[1]);
        set_clipper(clippers[which], &rooms[1].room);
        draw(&pose, HEIGHT, frames[1]);
        TEST_ASSERT_EQUAL_MEMORY(frames[0], frames[1], PIXELS);
    }
}

/* The planes are worked out anew for every pose, without being set again. */
/* clippers 4.2c */
void test_every_frame_has_its_own_planes(void)
{
    for (int i = 0; i < 4 * CLIPPERS; i++) { /* from some poses nothing is seen */
        const int which = i % CLIPPERS;
        fxl_pose poses[2] = {tiny_pose_between(), tiny_pose_between()};
        start(LIST_WORDS, 9);
        set_clipper(clippers[which], &rooms[0].room);
        draw(&poses[0], HEIGHT, frames[0]);
        draw(&poses[1], HEIGHT, frames[1]);
        draw(&poses[0], HEIGHT, frames[2]);
        TEST_ASSERT_EQUAL_MEMORY(frames[0], frames[2], PIXELS);
        start(LIST_WORDS, 9);
        set_clipper(clippers[which], &rooms[1].room);
        draw(&poses[1], HEIGHT, frames[2]);
        TEST_ASSERT_EQUAL_MEMORY(frames[1], frames[2], PIXELS);
    }
}

/* clippers 4.2a */
void test_room_that_is_too_small_is_refused(void)
{
    start(LIST_WORDS, 9);
    for (int which = 0; which < CLIPPERS; which++) {
        const fxl_clipper *clipper = clippers[which];
        TEST_ASSERT_TRUE(clipper->workspace_size > 0 &&
                         clipper->workspace_size <= sizeof(fxl_clipper_workspace));
        TEST_ASSERT_EQUAL(FXL_E_CAPACITY, fxl_renderer_set_clipper(&renderer, clipper, &rooms[0],
                                                                   clipper->workspace_size - 1));
        TEST_ASSERT_EQUAL(FXL_E_ARGUMENT, fxl_renderer_set_clipper(&renderer, clipper, NULL,
                                                                   clipper->workspace_size));
        TEST_ASSERT_TRUE(renderer.clipper == &fxl_clipper_view);
    }
}

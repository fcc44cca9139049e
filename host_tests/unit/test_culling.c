/* SPDX-License-Identifier: MIT */
/* Objects that a sphere leaves out, in whole frames. */
#include "tiny.h"
#include "study/clippers.h"

enum {
    WIDTH = 48,
    HEIGHT = 32
};

static fxl_renderer renderer;
static fxl_draw_entry order[TINY_INSTANCES + 6];
static uint8_t pixels[2][HEIGHT * WIDTH];

static fxl_counters draw(tiny_scene *tiny, const fxl_lens *lens, const fxl_pose *pose, int which,
                         const fxl_clipper *clipper)
{
    const fxl_memory memory = {order, TINY_INSTANCES + 6, NULL, 0, NULL, 0};
    const fxl_band band = {
        .pixels = pixels[which], .width = WIDTH, .stride = WIDTH, .first_row = 0, .rows = HEIGHT};
    TEST_ASSERT_EQUAL(FXL_OK, fxl_scene_check(&tiny->scene, NULL));
    TEST_ASSERT_EQUAL(FXL_OK, fxl_renderer_init_with(&renderer, &tiny->scene, lens, &memory));
    TEST_ASSERT_EQUAL(FXL_OK, fxl_renderer_set_clipper(&renderer, clipper, NULL, 0));
    TEST_ASSERT_EQUAL(FXL_OK, fxl_frame_begin(&renderer, pose));
    fxl_fill_band(&band, 0);
    TEST_ASSERT_EQUAL(FXL_OK, fxl_frame_draw(&renderer, &band));
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
        fxl_counters tight = draw(tiny, &lens, &pose, 0, clipper);
        tiny->models[0].radius = tiny->models[1].radius = FXL_RADIUS_MAX;
        fxl_counters wide_open = draw(tiny, &lens, &pose, 1, clipper);
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
    TEST_ASSERT_TRUE(left_out > UNIT_REPEAT / 100 && drawn > UNIT_REPEAT / 100);
}

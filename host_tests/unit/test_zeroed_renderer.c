/* SPDX-License-Identifier: MIT */
/* A renderer that is all zeros was never initialised: no call may set anything in it. */
#include "tiny.h"
#include "study/methods.h"

static fxl_renderer renderer, zeros;
static FXL_ALIGN_8 uint8_t memory[1024];

static void expect(fxl_status status, fxl_status answer)
{
    TEST_ASSERT_EQUAL(status, answer);
    TEST_ASSERT_EQUAL_UINT32(1, renderer.workspace.counters.refused_calls);
    renderer.workspace.counters.refused_calls = 0;
    TEST_ASSERT_EQUAL_MEMORY(&zeros, &renderer, sizeof zeros);
}

void test_settings_of_a_zeroed_renderer(void)
{
    const fxl_clipper *const clipper = &fxl_clipper_view;
    expect(FXL_E_ORDER, fxl_renderer_set_clipper(&renderer, clipper, NULL, 0));
    expect(FXL_E_ORDER, fxl_renderer_set_centre(&renderer, 0, 0));
    const fxl_visibility *const methods[] = {&fxl_visibility_sorted,    &fxl_visibility_box,
                                             &fxl_visibility_spans,     &fxl_visibility_bsp,
                                             &fxl_visibility_spans_box, &fxl_visibility_bsp_spans,
                                             &fxl_visibility_depth,     &fxl_visibility_billboards,
                                             &fxl_visibility_outlined,  &fxl_visibility_surfaces};
    for (uint32_t i = 0; i < sizeof methods / sizeof methods[0]; i++) {
        expect(FXL_E_ORDER,
               fxl_renderer_set_visibility(&renderer, methods[i], memory, sizeof memory));
    }
}

/* What is set, and what is taken away. */
void test_extras_of_a_zeroed_renderer(void)
{
    static fxl_light light;
    static fxl_surfaces surfaces;
    static fxl_depth depth;
    static fxl_billboards billboards;
    static fxl_rgb565_frame frame;
    static const uint16_t palette[256];
    const fxl_light_settings settings = {.ramp = memory, .levels = 2};
    const fxl_surface_set surface_set = {.surface_count = 0};
    const fxl_billboard_set billboard_set = {.count = 0};
    expect(FXL_E_ORDER, fxl_attach_light(&renderer, &light, &settings));
    expect(FXL_E_ORDER, fxl_attach_light(&renderer, &light, NULL));
    expect(FXL_E_ORDER, fxl_attach_light(&renderer, NULL, NULL));
    expect(FXL_E_ORDER, fxl_renderer_light_surfaces(&renderer, NULL));
    expect(FXL_E_ORDER, fxl_renderer_set_surfaces(&renderer, &surfaces, &surface_set));
    expect(FXL_E_ORDER, fxl_renderer_set_surfaces(&renderer, &surfaces, NULL));
    expect(FXL_E_ORDER, fxl_renderer_set_surfaces_rgb565(&renderer, &surfaces, NULL));
    expect(FXL_E_ORDER, fxl_renderer_set_rgb565(&renderer, &frame, palette, 0));
    expect(FXL_E_ORDER,
           fxl_renderer_set_depth(&renderer, &depth, &fxl_visibility_depth, memory, sizeof memory));
    expect(FXL_E_ORDER, fxl_renderer_set_billboards(&renderer, &billboards, &billboard_set));
    expect(FXL_E_ORDER, fxl_renderer_set_billboards(&renderer, NULL, NULL));
    expect(FXL_E_ORDER,
           fxl_renderer_set_billboards_by_depth(&renderer, &billboards, &billboard_set));
    expect(FXL_E_ORDER, fxl_renderer_set_beams(&renderer, NULL, 0, NULL, NULL, 0));
}

/* A world counts the calls that it refuses in itself. */
void test_a_world_refuses_a_zeroed_renderer(void)
{
    static fxl_world world;
    static fxl_instance instances[TINY_INSTANCES];
    static fxl_world_slot slots[TINY_INSTANCES];
    static fxl_world_colours colours;
    tiny_scene *tiny = tiny_make();
    const fxl_world_memory of = {
        .instances = instances, .slots = slots, .capacity = TINY_INSTANCES};
    TEST_ASSERT_EQUAL(FXL_OK, fxl_scene_check(&tiny->scene, NULL));
    TEST_ASSERT_EQUAL(FXL_OK, fxl_world_init(&world, &tiny->scene, &of));
    TEST_ASSERT_EQUAL(FXL_E_RANGE, fxl_world_attach(&world, &renderer));
    TEST_ASSERT_EQUAL(FXL_E_INDEX, fxl_world_detach(&world, &renderer));
    TEST_ASSERT_EQUAL(FXL_E_INDEX, fxl_world_set_colours(&world, &renderer, &colours));
    TEST_ASSERT_EQUAL(FXL_E_INDEX, fxl_world_set_colours(&world, &renderer, NULL));
    TEST_ASSERT_EQUAL_MEMORY(&zeros, &renderer, sizeof zeros);
}

/* No frame begins, and none is drawn. */
void test_frames_of_a_zeroed_renderer(void)
{
    const fxl_pose pose = {.position = {0, 0, 0}};
    const fxl_band band = {.pixels = memory, .width = 1, .stride = 1, .first_row = 0, .rows = 1};
    const fxl_band_565 colours = {.pixels = (uint16_t *)(void *)memory, .width = 1, .stride = 1,
                                  .first_row = 0, .rows = 1};
    fxl_picked picked;
    expect(FXL_E_ORDER, fxl_frame_begin(&renderer, &pose));
    expect(FXL_E_ORDER, fxl_render(&renderer, &pose, memory, 1));
    expect(FXL_E_ORDER, fxl_render_rgb565(&renderer, &pose, colours.pixels, 1));
    expect(FXL_E_ORDER, fxl_frame_draw(&renderer, &band));
    expect(FXL_E_ORDER, fxl_frame_draw_rgb565(&renderer, &colours));
    expect(FXL_E_ORDER, fxl_pick_face(&renderer, 0, 0, &picked));
    TEST_ASSERT_EQUAL_UINT32(0, fxl_workspace_size(&renderer));
}

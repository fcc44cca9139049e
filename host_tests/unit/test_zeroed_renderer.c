/* SPDX-License-Identifier: MIT */
/* A renderer that is all zeros was never initialised: no call may set anything in it. */
#include "tiny.h"
#include "study/targets.h"

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
    const fxl_target *const targets[] = {&fxl_palette,          &fxl_palette_box,
                                         &fxl_palette_spans,    &fxl_palette_spans_box,
                                         &fxl_palette_depth_16, &fxl_palette_depth_32,
                                         &fxl_rgb565,           &fxl_rgb565_depth_16};
    static const uint16_t palette[256];
    for (uint32_t i = 0; i < 2 * sizeof targets / sizeof targets[0]; i++) {
        fxl_config config = fxl_config_for(1, 1, targets[i / 2]);
        config.order = i % 2 ? &fxl_by_tree : &fxl_by_distance;
        config.palette = palette;
        config.depth = config.tree = memory;
        config.depth_size = config.tree_size = sizeof memory;
        expect(FXL_E_ORDER, fxl_renderer_choose(&renderer, &config));
    }
}

/* What is set, and what is taken away. */
void test_extras_of_a_zeroed_renderer(void)
{
    static fxl_light light;
    static fxl_surfaces surfaces;
    static fxl_billboards billboards;
    static fxl_lit_surfaces lit;
    static fxl_outlines outlines;
    static fxl_lines lines;
    static const uint32_t line_map[2];
    static const fxl_line_set line_set = {NULL, 0, line_map};
    const fxl_outline_style style = {.line = 1};
    const fxl_light_settings settings = {.ramp = memory, .levels = 2};
    const fxl_surface_set surface_set = {.surface_count = 0};
    const fxl_billboard_set billboard_set = {.count = 0};
    expect(FXL_E_ORDER, fxl_attach_light(&renderer, &light, &settings));
    expect(FXL_E_ORDER, fxl_attach_light(&renderer, &light, NULL));
    expect(FXL_E_ORDER, fxl_attach_light(&renderer, NULL, NULL));
    expect(FXL_E_ORDER, fxl_attach_lit(&renderer, &lit));
    expect(FXL_E_ORDER, fxl_attach_lit(&renderer, NULL));
    expect(FXL_E_ORDER, fxl_attach_surfaces(&renderer, &surfaces, &surface_set,
                                            FXL_SURFACES_OF(fxl_palette)));
    expect(FXL_E_ORDER, fxl_attach_surfaces(&renderer, &surfaces, NULL, NULL));
    expect(FXL_E_ORDER, fxl_attach_billboards(&renderer, &billboards, &billboard_set,
                                              FXL_SPRITES_OF(fxl_palette)));
    expect(FXL_E_ORDER, fxl_attach_billboards(&renderer, NULL, NULL, NULL));
    expect(FXL_E_ORDER, fxl_attach_beams(&renderer, NULL, NULL, 0));
    expect(FXL_E_ORDER, fxl_attach_outlines(&renderer, &outlines, &style));
    expect(FXL_E_ORDER, fxl_attach_outlines(&renderer, NULL, NULL));
    expect(FXL_E_ORDER, fxl_attach_lines(&renderer, &lines, &line_set));
    expect(FXL_E_ORDER, fxl_attach_lines(&renderer, NULL, NULL));
    expect(FXL_E_ORDER, fxl_attach_horizon(&renderer, NULL));
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
    fxl_picked picked;
    expect(FXL_E_ORDER, fxl_frame_begin(&renderer, &pose));
    expect(FXL_E_ORDER, fxl_render(&renderer, &pose, memory, 1));
    expect(FXL_E_ORDER, fxl_frame_draw(&renderer, &band));
    expect(FXL_E_ORDER, fxl_pick_face(&renderer, 0, 0, &picked));
    TEST_ASSERT_EQUAL_UINT32(0, fxl_workspace_size(&renderer));
}

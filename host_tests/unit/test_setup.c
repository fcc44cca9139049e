/* SPDX-License-Identifier: MIT */
/* A plan that sets a scene up: what it writes, what it refuses, and that it draws what the calls by
 * hand draw. */
#include "tiny_frames.h"
#include "unit.h"

enum {
    WIDTH = 48,
    HEIGHT = 32,
    LARGE = 8192
};

static uint64_t memory[LARGE / 8], again[LARGE / 8];
static uint8_t pixels[2][WIDTH * HEIGHT], ramp[FXL_LIGHT_RAMP_BYTES(2)];
static fxl_scene scene;
static fxl_config config;
static fxl_setup_plan plan;
static fxl_setup setup;
static fxl_renderer by_hand;
static fxl_light_settings lamp;
static const fxl_pose poses[] = {{.position = {0, 0, FXL_UNITS(-6)}},
                                 {.position = {0, FXL_UNITS(1), FXL_UNITS(-6)}},
                                 {.position = {FXL_UNITS(1), 0, FXL_UNITS(-6)}}};

void setUp(void)
{
    tiny_scene *made = tiny_make();
    TEST_ASSERT_EQUAL(FXL_OK, fxl_scene_check(&made->scene, NULL));
    scene = made->scene;
    config = fxl_config_default(WIDTH, HEIGHT);
    memset(&setup, 0, sizeof setup);
    memset(&plan, 0, sizeof plan);
    plan.scene = &scene;
    plan.config = &config;
    plan.init_renderer = fxl_renderer_init;
    plan.start = &poses[2];
    lamp = (fxl_light_settings){.ambient = FXL_Q2_30_ONE / 2, .ramp = ramp, .levels = 2};
    for (uint32_t i = 0; i < sizeof ramp; i++) {
        ramp[i] = (uint8_t)(i * 7);
    }
}

static fxl_status init(size_t size)
{
    return fxl_setup_init(&setup, &plan, HEIGHT, memory, size);
}

static void expect_sentence(const char *said, const char *argument, const char *range)
{
    TEST_ASSERT_NOT_NULL(said);
    TEST_ASSERT_NOT_NULL_MESSAGE(strstr(said, argument), said);
    TEST_ASSERT_NOT_NULL_MESSAGE(strstr(said, range), said);
}

/* A refusal before the first step: nothing is written but memory_missing. */
static void refuse(fxl_status expected, const fxl_setup_plan *of, uint16_t rows, void *block,
                   size_t size, const char *argument, const char *range)
{
    static fxl_setup before;
    memset(&setup, 0x5A, sizeof setup);
    setup.memory_missing = 0;
    before = setup;
    memset(again, 0x5A, sizeof again);
    memcpy(memory, again, sizeof memory);
    TEST_ASSERT_EQUAL(expected, fxl_setup_init(&setup, of, rows, block, size));
    TEST_ASSERT_EQUAL(expected == FXL_E_CAPACITY, setup.memory_missing != 0);
    expect_sentence(fxl_setup_explain(&setup, of, rows, block, size), argument, range);
    setup.memory_missing = 0;
    TEST_ASSERT_EQUAL_MEMORY(&before, &setup, sizeof setup);
    TEST_ASSERT_EQUAL_MEMORY(again, memory, sizeof memory);
}

void test_arguments_that_are_refused(void)
{
    refuse(FXL_E_ARGUMENT, NULL, HEIGHT, memory, LARGE, "plan", "not be null");
    refuse(FXL_E_ARGUMENT, &plan, HEIGHT, NULL, LARGE, "memory", "not be null");
    refuse(FXL_E_ALIGNMENT, &plan, HEIGHT, (uint8_t *)memory + 4, LARGE - 8, "memory", "8 bytes");
    TEST_ASSERT_EQUAL(FXL_E_ARGUMENT, fxl_setup_init(NULL, &plan, HEIGHT, memory, LARGE));
    expect_sentence(fxl_setup_explain(NULL, &plan, HEIGHT, memory, LARGE), "setup", "not be null");
    plan.scene = NULL;
    refuse(FXL_E_ARGUMENT, &plan, HEIGHT, memory, LARGE, "plan->scene", "not be null");
    plan.scene = &scene;
    plan.config = NULL;
    refuse(FXL_E_ARGUMENT, &plan, HEIGHT, memory, LARGE, "plan->config", "not be null");
    plan.config = &config;
    plan.init_renderer = NULL;
    refuse(FXL_E_ARGUMENT, &plan, HEIGHT, memory, LARGE, "plan->init_renderer", "not be null");
    plan.init_renderer = fxl_renderer_init;
    config.target = NULL;
    refuse(FXL_E_ARGUMENT, &plan, HEIGHT, memory, LARGE, "target", "not be null");
    config.target = &fxl_palette_depth_16;
    refuse(FXL_E_RANGE, &plan, 0, memory, LARGE, "rows", "1..plan->config->height");
    refuse(FXL_E_RANGE, &plan, HEIGHT + 1, memory, LARGE, "rows", "1..plan->config->height");
    config.width = FXL_SCREEN_MAX + 1;
    refuse(FXL_E_RANGE, &plan, HEIGHT, memory, LARGE, "width", "1024");
    config.width = WIDTH;
    config.height = FXL_SCREEN_MAX + 1;
    refuse(FXL_E_RANGE, &plan, HEIGHT, memory, LARGE, "height", "1024");
    config.height = HEIGHT;
    scene.draw_list_needed = 0;
    refuse(FXL_E_ORDER, &plan, HEIGHT, memory, LARGE, "plan->scene", "checked");
}

/* The least memory is what the parts need; a byte less is refused, with the bytes that are missing.
 * */
void test_too_little_memory(void)
{
    const uint32_t order = (uint32_t)(scene.draw_list_needed * sizeof(fxl_draw_entry) + 7u) & ~7u;
    for (uint32_t i = 0; i < 2; i++) {
        const uint32_t least = order + (i > 0 ? FXL_DEPTH_BYTES(WIDTH, 4, 16) : 0);
        config.target = i > 0 ? &fxl_palette_depth_16 : &fxl_palette;
        TEST_ASSERT_EQUAL(FXL_OK, fxl_setup_init(&setup, &plan, 4, memory, least));
        refuse(FXL_E_CAPACITY, &plan, 4, memory, least - 1, "memory_size", "memory_missing");
        TEST_ASSERT_EQUAL(FXL_E_CAPACITY, fxl_setup_init(&setup, &plan, 4, memory, least - 5));
        TEST_ASSERT_EQUAL(5, setup.memory_missing);
        TEST_ASSERT_EQUAL(FXL_E_CAPACITY, fxl_setup_init(&setup, &plan, 4, memory, 0));
        TEST_ASSERT_EQUAL(least, setup.memory_missing);
    }
}

/* A renderer that the program sets up, with tables of its own: it is handed what the depth leaves.
 * */
static fxl_status own_answer;

static fxl_status init_own(fxl_renderer *renderer, const fxl_scene *of, const fxl_config *with,
                           void *rest, size_t size)
{
    TEST_ASSERT_EQUAL_PTR(&setup.renderer, renderer);
    TEST_ASSERT_EQUAL_PTR(&setup.scene, of);
    TEST_ASSERT_EQUAL_PTR(memory, with->depth);
    TEST_ASSERT_EQUAL(FXL_DEPTH_BYTES(WIDTH, 4, 16), with->depth_size);
    TEST_ASSERT_EQUAL_PTR((uint8_t *)memory + with->depth_size, rest);
    TEST_ASSERT_EQUAL(24, size);
    return own_answer == FXL_OK ? fxl_renderer_init(renderer, of, with, again, sizeof again)
                                : own_answer;
}

void test_tables_of_the_programs_own(void)
{
    const uint32_t depth = FXL_DEPTH_BYTES(WIDTH, 4, 16);
    config.target = &fxl_palette_depth_16;
    plan.init_renderer = init_own;
    plan.has_tables = true;
    own_answer = FXL_OK;
    refuse(FXL_E_CAPACITY, &plan, 4, memory, depth - 1, "memory_size", "memory_missing");
    TEST_ASSERT_EQUAL(FXL_OK, fxl_setup_init(&setup, &plan, 4, memory, depth + 24));
    TEST_ASSERT_NULL(fxl_setup_explain(&setup, &plan, 4, memory, depth + 24));
    TEST_ASSERT_EQUAL(FXL_OK, fxl_render(&setup.renderer, &poses[0], pixels[0], WIDTH));
    own_answer = FXL_E_RANGE;
    TEST_ASSERT_EQUAL(FXL_E_RANGE, fxl_setup_init(&setup, &plan, 4, memory, depth + 24));
    TEST_ASSERT_EQUAL(FXL_SETUP_RENDERER, setup.step);
    TEST_ASSERT_NOT_NULL(fxl_setup_explain(&setup, &plan, 4, memory, depth + 24));
}

static void draw_both(uint32_t frame)
{
    const fxl_pose *eye = fxl_setup_frame(&setup, frame);
    memset(pixels, 0, sizeof pixels);
    TEST_ASSERT_EQUAL(FXL_OK, fxl_render(&setup.renderer, eye, pixels[0], WIDTH));
    TEST_ASSERT_EQUAL(FXL_OK, fxl_render(&by_hand, eye, pixels[1], WIDTH));
    TEST_ASSERT_EQUAL_MEMORY(pixels[1], pixels[0], sizeof pixels[0]);
}

void test_it_draws_what_the_calls_by_hand_draw(void)
{
    static fxl_light light;
    config.background = 3;
    plan.order = &fxl_by_distance;
    plan.path = poses;
    plan.path_count = 2;
    plan.light = &lamp;
    plan.attach_light = fxl_attach_light;
    plan.set_centre = fxl_renderer_set_centre;
    plan.centre_x = FXL_UNITS(20);
    plan.centre_y = FXL_UNITS(10);
    TEST_ASSERT_EQUAL(FXL_OK, init(LARGE));
    TEST_ASSERT_NULL(fxl_setup_explain(&setup, &plan, HEIGHT, memory, LARGE));
    TEST_ASSERT_EQUAL(FXL_OK, fxl_renderer_init(&by_hand, &scene, &config, again, sizeof again));
    TEST_ASSERT_EQUAL(FXL_OK, fxl_renderer_set_centre(&by_hand, FXL_UNITS(20), FXL_UNITS(10)));
    TEST_ASSERT_EQUAL(FXL_OK, fxl_attach_light(&by_hand, &light, &lamp));
    for (uint32_t frame = 0; frame < 3; frame++) {
        draw_both(frame);
        TEST_ASSERT_EQUAL_PTR(&poses[frame % 2], fxl_setup_frame(&setup, frame));
    }
    TEST_ASSERT_EQUAL_PTR(&poses[1], fxl_setup_frame(&setup, UINT32_MAX)); /* odd */
    /* A part that a program sets up anew by hand. */
    lamp.ambient = FXL_Q2_30_ONE;
    TEST_ASSERT_EQUAL(FXL_OK, fxl_attach_light(&setup.renderer, &setup.light, &lamp));
    TEST_ASSERT_EQUAL(FXL_OK, fxl_attach_light(&by_hand, &light, &lamp));
    draw_both(0);
}

void test_another_core_draws_a_band(void)
{
    static fxl_workspace workspace;
    static uint64_t room[LARGE / 8];
    fxl_band band = {.pixels = pixels[1], .width = WIDTH, .stride = WIDTH, .rows = HEIGHT};
    config.target = &fxl_palette_depth_16;
    TEST_ASSERT_EQUAL(FXL_OK, init(LARGE));
    TEST_ASSERT_EQUAL(FXL_OK, fxl_render(&setup.renderer, &poses[0], pixels[0], WIDTH));
    TEST_ASSERT_EQUAL(FXL_OK, fxl_workspace_init(&workspace, &setup.renderer, room, sizeof room));
    TEST_ASSERT_EQUAL(FXL_OK, fxl_frame_begin(&setup.renderer, &poses[0]));
    fxl_frame_fill(&setup.renderer, &band, config.background);
    TEST_ASSERT_EQUAL(FXL_OK, fxl_frame_draw_with(&setup.renderer, &workspace, &band));
    TEST_ASSERT_EQUAL_MEMORY(pixels[0], pixels[1], sizeof pixels[0]);
}

void test_motions_move_copies(void)
{
    static fxl_placement placements[TINY_INSTANCES];
    static fxl_motion motion = {.scale_low = FXL_Q16_16_ONE, .scale_high = FXL_Q16_16_ONE,
                                .key_count = 2, .extent = {FXL_UNITS(1), 0, 0}};
    static fxl_motion_key keys[2] = {{.scale = FXL_Q16_16_ONE},
                                     {.frame = 4, .centre = {FXL_UNITS(1), 0, 0},
                                      .scale = FXL_Q16_16_ONE}};
    const fxl_motion_set set = {&motion, 1, keys, 2};
    tiny_scene *made = tiny_make();
    tiny_place_from(made, placements, TINY_INSTANCES - 1);
    TEST_ASSERT_EQUAL(FXL_OK, fxl_scene_check_all(&made->scene, NULL));
    scene = made->scene;
    plan.motions = &set;
    plan.begin_motions = fxl_motion_begin;
    plan.play_motions = fxl_motion_play;
    TEST_ASSERT_EQUAL(FXL_OK, init(LARGE));
    TEST_ASSERT_EQUAL_PTR(memory, setup.scene.instances);
    TEST_ASSERT_EQUAL_PTR(&poses[2], fxl_setup_frame(&setup, 2)); /* without a path */
    TEST_ASSERT_EQUAL(FXL_UNITS(1) / 2, setup.scene.instances[TINY_INSTANCES - 1].centre.x);
    TEST_ASSERT_EQUAL(FXL_OK, fxl_render(&setup.renderer, &poses[0], pixels[0], WIDTH));
    const size_t least = TINY_INSTANCES * sizeof(fxl_instance) + sizeof(fxl_placement) +
                         scene.draw_list_needed * sizeof(fxl_draw_entry);
    TEST_ASSERT_EQUAL(FXL_E_CAPACITY, init(least - 8));
    TEST_ASSERT_EQUAL(FXL_OK, init(least + 16)); /* each share is rounded up to 8 bytes */
    motion.key_count = 2;
    scene.placements = NULL;
    TEST_ASSERT_EQUAL(FXL_E_ARGUMENT, init(LARGE));
    TEST_ASSERT_EQUAL(FXL_SETUP_MOTIONS, setup.step);
    expect_sentence(fxl_setup_explain(&setup, &plan, HEIGHT, memory, LARGE), "set", "placements");
}

/* A step that is refused is named, and nothing can be drawn. */
static void refuse_step(uint8_t step, fxl_status status, const char *argument, const char *range)
{
    TEST_ASSERT_EQUAL(status, init(LARGE));
    TEST_ASSERT_EQUAL(step, setup.step);
    TEST_ASSERT_EQUAL(status, setup.status);
    TEST_ASSERT_NULL(setup.plan);
    TEST_ASSERT_NULL(fxl_setup_frame(&setup, 0));
    expect_sentence(fxl_setup_explain(&setup, &plan, HEIGHT, memory, LARGE), argument, range);
}

void test_steps_that_are_refused(void)
{
    static const fxl_surface_set no_surfaces;
    static const fxl_billboard_set no_billboards;
    static const fxl_line_set no_lines;
    static const fxl_horizon no_horizon = {NULL, NULL, 1};
    config.fov = 60;
    refuse_step(FXL_SETUP_RENDERER, FXL_E_RANGE, "config->fov", "FXL_DEGREES(10)");
    config = fxl_config_default(WIDTH, HEIGHT);
    config.target = &fxl_rgb565;
    refuse_step(FXL_SETUP_RENDERER, FXL_E_ARGUMENT, "config->palette", "256 colours");
    config = fxl_config_default(WIDTH, HEIGHT);
    plan.attach_light = fxl_attach_light;
    plan.light = &lamp;
    lamp.levels = 1;
    refuse_step(FXL_SETUP_LIGHT, FXL_E_COUNT, "settings->levels", "2..64");
    lamp.levels = 2;
    plan.attach_surfaces = fxl_attach_surfaces;
    plan.surfaces = &no_surfaces;
    plan.painter = FXL_SURFACES_OF(fxl_palette);
    refuse_step(FXL_SETUP_SURFACES, FXL_E_ARGUMENT, "set->face_map", "not be null");
    plan.attach_surfaces = NULL;
    plan.attach_billboards = fxl_attach_billboards;
    plan.billboards = &no_billboards;
    plan.sprite_painter = FXL_SPRITES_OF(fxl_palette);
    refuse_step(FXL_SETUP_BILLBOARDS, FXL_E_ARGUMENT, "set->model_map", "not be null");
    plan.attach_billboards = NULL;
    plan.attach_beams = fxl_attach_beams;
    plan.beam_memory_size = fxl_beam_light_workspace_size;
    refuse_step(FXL_SETUP_BEAMS, FXL_E_ARGUMENT, "set->beams", "not be null");
    plan.attach_beams = NULL;
    plan.beam_memory_size = NULL;
    plan.set_centre = fxl_renderer_set_centre;
    plan.centre_x = FXL_UNITS(1000);
    refuse_step(FXL_SETUP_CENTRE, FXL_E_RANGE, "centre", "focal lengths");
    config.fov = 60;
    refuse_step(FXL_SETUP_RENDERER, FXL_E_RANGE, "config->fov", "FXL_DEGREES(10)");
    config = fxl_config_default(WIDTH, HEIGHT);
    plan.set_centre = NULL;
    plan.set_orthographic = fxl_renderer_set_orthographic;
    plan.scale = FXL_ORTHOGRAPHIC_SCALE_MIN - 1;
    config.fov = 60; /* the renderer is refused first */
    refuse_step(FXL_SETUP_RENDERER, FXL_E_RANGE, "config->fov", "FXL_DEGREES(10)");
    config = fxl_config_default(WIDTH, HEIGHT);
    refuse_step(FXL_SETUP_CENTRE, FXL_E_RANGE, "plan->scale", "FXL_ORTHOGRAPHIC_SCALE_MAX");
    plan.scale = FXL_ORTHOGRAPHIC_SCALE_MAX + 1;
    refuse_step(FXL_SETUP_CENTRE, FXL_E_RANGE, "plan->scale", "FXL_ORTHOGRAPHIC_SCALE_MAX");
    plan.scale = FXL_UNITS(20); /* the centre comes after it */
    plan.set_centre = fxl_renderer_set_centre;
    plan.centre_x = FXL_UNITS(2000);
    refuse_step(FXL_SETUP_CENTRE, FXL_E_RANGE, "centre", "1536 pixels");
    plan.centre_x = FXL_UNITS(-20);
    TEST_ASSERT_EQUAL(FXL_OK, init(LARGE));
    TEST_ASSERT_EQUAL_INT32(FXL_UNITS(20), setup.renderer.frame.view.lens.focal);
    TEST_ASSERT_EQUAL_INT32(FXL_UNITS(-20), setup.renderer.frame.view.lens.centre_x);
    plan.set_centre = NULL;
    plan.set_orthographic = NULL;
    plan.attach_lines = fxl_attach_lines;
    plan.lines = &no_lines;
    refuse_step(FXL_SETUP_LINES, FXL_E_ARGUMENT, "set->line", "not be null");
    plan.attach_lines = NULL;
    plan.attach_horizon = fxl_attach_horizon;
    plan.horizon = &no_horizon;
    refuse_step(FXL_SETUP_HORIZON, FXL_E_ARGUMENT, "horizon->sines", "not be null");
    plan.attach_lines = fxl_attach_lines;
    plan.attach_beams = fxl_attach_beams; /* what comes after a refused step is not tried */
    plan.attach_surfaces = fxl_attach_surfaces;
    plan.attach_lit = fxl_attach_lit;
    plan.attach_billboards = fxl_attach_billboards;
    refuse_step(FXL_SETUP_BEAMS, FXL_E_ARGUMENT, "set->beams", "not be null");
    plan.attach_beams = NULL;
    plan.attach_surfaces = NULL;
    plan.attach_billboards = NULL;
    plan.attach_lines = NULL;
    plan.attach_horizon = NULL;
    TEST_ASSERT_EQUAL(FXL_OK, init(LARGE)); /* with light, and light at corners of no surface */
    TEST_ASSERT_EQUAL(FXL_SETUP_DONE, setup.step);
    plan.path = poses;
    TEST_ASSERT_EQUAL_PTR(plan.start, fxl_setup_frame(&setup, 1)); /* a path of no poses */
    TEST_ASSERT_NULL(fxl_setup_frame(NULL, 0));
}

/* Any plan, rows and size: what is refused has a sentence, and what is not has none. */
void test_random_plans(void)
{
    static const fxl_target *const targets[] = {&fxl_palette, &fxl_palette_depth_16, NULL,
                                                &fxl_palette_depth_32, &fxl_rgb565};
    uint32_t sound = 0;
    for (uint32_t i = 0; i < UNIT_REPEAT / 4; i++) {
        config.width = (uint16_t)unit_between(0, 64);
        config.height = (uint16_t)unit_between(0, 64);
        config.target = targets[unit_between(0, 4)];
        plan.light = &lamp;
        plan.attach_light = unit_between(0, 1) ? fxl_attach_light : NULL;
        lamp.levels = (uint32_t)unit_between(1, 20);
        const uint16_t rows = (uint16_t)unit_between(0, 64);
        const size_t size = (size_t)unit_between(0, LARGE);
        const fxl_status status = fxl_setup_init(&setup, &plan, rows, memory, size);
        const char *said = fxl_setup_explain(&setup, &plan, rows, memory, size);
        TEST_ASSERT_EQUAL_MESSAGE(status == FXL_OK, said == NULL, said != NULL ? said : "nothing");
        sound += status == FXL_OK;
    }
    TEST_ASSERT_GREATER_THAN(UNIT_REPEAT / 400, sound);
}

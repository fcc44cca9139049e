/* SPDX-License-Identifier: MIT */
/* A scene set up in every way. A frame into each target with whatever may be attached: either two
 * things do not go together, and both are named, or the frame is drawn. And setups in exactly the
 * memory that they ask for: each draws what the calls by hand draw, or is refused with a sentence; a
 * step that refuses ends a setup. Takes no input and records nothing. */
#include <stdlib.h>

#include "any_frame.h"
#include "fixel/setup.h"
#include "study/study.h"

enum {
    LIGHT = 1,
    OUTLINES = 2,
    BEAMS = 4,
    SETS = 8
};

typedef struct {
    fxl_renderer renderer;
    fxl_light light;
    fxl_lit_surfaces lit;
    fxl_outlines outlines;
    draw_room room;
    void *pixels;
} attached;

static void attach(attached *to, uint32_t set)
{
    fxl_renderer *renderer = &to->renderer;
    attach_light(renderer, &to->light, set & LIGHT);
    DEMAND(fxl_attach_lit(renderer, set & LIGHT ? &to->lit : NULL) == FXL_OK);
    attach_outlines(renderer, &to->outlines, set & OUTLINES);
    attach_horizon(renderer, set & OUTLINES);
    attach_beams(renderer, &to->room, set & BEAMS);
}

/* The frame that fxl_render has drawn, as another core would draw it: the same pixels. */
static void draw_as_another(const attached *to)
{
    static fxl_workspace workspace;
    const fxl_renderer *renderer = &to->renderer;
    const fxl_lens *lens = &renderer->frame.view.lens;
    const size_t size = fxl_workspace_size(renderer);
    const size_t bytes = (size_t)lens->width * lens->height * renderer->target->pixel_bits / 8u;
    void *memory = draw_memory(size), *pixels = draw_memory(bytes);
    fxl_band band = draw_band(lens, pixels, 0, lens->height);
    band.palette = renderer->palette;
    DEMAND(fxl_workspace_init(&workspace, renderer, memory, size) == FXL_OK);
    fxl_frame_fill(renderer, &band, renderer->frame.background);
    DEMAND(fxl_frame_draw_with(renderer, &workspace, &band) == FXL_OK);
    DEMAND(memcmp(pixels, to->pixels, bytes) == 0);
    free(memory);
    free(pixels);
}

/* A rectangle of the frame that was drawn has its pixels. */
static void demand_rectangle(attached *to, const fxl_pose *pose)
{
    fxl_renderer *renderer = &to->renderer;
    const fxl_lens *lens = &renderer->frame.view.lens;
    const uint32_t bytes = renderer->target->pixel_bits / 8u;
    fxl_band band = {.width = lens->width,
                     .first_row = lens->height / 3,
                     .palette = bytes == 2 ? to->room.palette : NULL,
                     .first_column = lens->width / 3};
    band.columns = band.stride = (uint16_t)((lens->width + 1) / 2);
    band.rows = (uint16_t)((lens->height + 1) / 2);
    band.pixels = draw_memory((size_t)band.columns * band.rows * bytes);
    DEMAND(fxl_frame_begin(renderer, pose) == FXL_OK);
    fxl_frame_fill(renderer, &band, renderer->frame.background);
    DEMAND(fxl_frame_draw(renderer, &band) == FXL_OK);
    for (uint32_t row = 0; row < band.rows; row++) {
        const size_t at = (size_t)(band.first_row + row) * lens->width + band.first_column;
        DEMAND(memcmp(band.pixels + row * band.columns * bytes,
                      (const uint8_t *)to->pixels + at * bytes, band.columns * bytes) == 0);
    }
    free(band.pixels);
}

static void draw_set(attached *to, uint32_t set, const fxl_pose *pose)
{
    const char *names[2] = {NULL, NULL};
    fxl_renderer *renderer = &to->renderer;
    attach(to, set);
    const bool conflict = fxl_renderer_conflict(renderer, names);
    DEMAND(conflict == (names[0] != NULL && names[1] != NULL));
    DEMAND(fxl_render(renderer, pose, to->pixels, renderer->frame.view.lens.width) ==
           (conflict ? FXL_E_COMBINATION : FXL_OK));
    DEMAND(conflict == (fxl_render_explain(renderer, pose, to->pixels,
                                           renderer->frame.view.lens.width, NULL) != NULL));
    if (!conflict) {
        draw_all_picks(renderer, set & OUTLINES ? NULL : to->pixels);
        draw_as_another(to);
        demand_rectangle(to, pose);
    }
}

/* Horizons that are refused. */
static void misuse_horizon(fxl_renderer *renderer)
{
    static fxl_renderer none;
    static const fxl_q2_30 sines[] = {0, 1}, falling[] = {1, 0}, large[] = {FXL_Q2_30_ONE + 1, 0};
    static const uint8_t colours[] = {1, 2, 3};
    const fxl_horizon sound = {sines, colours, 2};
    const struct {
        fxl_horizon horizon;
        fxl_status status;
    } cases[] = {{{NULL, colours, 2}, FXL_E_ARGUMENT},
                 {{sines, NULL, 2}, FXL_E_ARGUMENT},
                 {{sines, colours, 0}, FXL_E_COUNT},
                 {{sines, colours, FXL_HORIZON_MAX + 1}, FXL_E_COUNT},
                 {{falling, colours, 2}, FXL_E_RANGE},
                 {{large, colours, 2}, FXL_E_RANGE}};
    for (uint32_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        DEMAND(fxl_attach_horizon(renderer, &cases[i].horizon) == cases[i].status);
    }
    DEMAND(fxl_attach_horizon(NULL, &sound) == FXL_E_ARGUMENT);
    DEMAND(fxl_attach_horizon(&none, &sound) == FXL_E_ORDER);
}

/* What fxl_renderer_choose refuses, of a renderer without attachments. */
static void misuse(attached *to)
{
    static fxl_renderer none;
    fxl_renderer *renderer = &to->renderer;
    const char *names[2];
    fxl_config config = fxl_config_for(1, 1, &fxl_rgb565_depth_16);
    DEMAND(fxl_renderer_choose(NULL, &config) == FXL_E_ARGUMENT);
    DEMAND(fxl_renderer_choose(&none, &config) == FXL_E_ORDER);
    DEMAND(fxl_renderer_choose(renderer, NULL) == FXL_E_ARGUMENT);
    DEMAND(fxl_renderer_choose(renderer, &config) == FXL_E_ARGUMENT);
    config.palette = (const uint16_t *)(const void *)((uint8_t *)to->room.palette + 1);
    DEMAND(fxl_renderer_choose(renderer, &config) == FXL_E_ALIGNMENT);
    config.palette = to->room.palette;
    DEMAND(fxl_renderer_choose(renderer, &config) == FXL_E_CAPACITY);
    config.depth = (uint8_t *)to->room.depth + 4;
    DEMAND(fxl_renderer_choose(renderer, &config) == FXL_E_ALIGNMENT);
    config.depth = NULL;
    config.depth_size = to->room.depth_size;
    DEMAND(fxl_renderer_choose(renderer, &config) == FXL_E_ARGUMENT);
    config.target = NULL;
    DEMAND(fxl_renderer_choose(renderer, &config) == FXL_E_ARGUMENT);
    DEMAND(!fxl_renderer_conflict(NULL, names) && !fxl_renderer_conflict(renderer, NULL));
    DEMAND(!fxl_renderer_conflict(renderer, names));
    DEMAND(fxl_attach_outlines(NULL, NULL, NULL) == FXL_E_ARGUMENT);
    DEMAND(fxl_attach_outlines(&none, NULL, NULL) == FXL_E_ORDER);
    const fxl_outline_style style = {.line = 1};
    DEMAND(fxl_attach_outlines(renderer, NULL, &style) == FXL_E_ARGUMENT);
    DEMAND(fxl_attach_outlines(renderer, (fxl_outlines *)(void *)((uint8_t *)&to->outlines + 4),
                               &style) == FXL_E_ALIGNMENT);
    DEMAND(fxl_attach_light(NULL, NULL, NULL) == FXL_E_ARGUMENT);
    DEMAND(fxl_attach_lit(NULL, NULL) == FXL_E_ARGUMENT);
    DEMAND(fxl_attach_beams(NULL, NULL, NULL, 0) == FXL_E_ARGUMENT);
    DEMAND(fxl_attach_surfaces(NULL, NULL, NULL, NULL) == FXL_E_ARGUMENT);
    DEMAND(fxl_attach_billboards(NULL, NULL, NULL, NULL) == FXL_E_ARGUMENT);
    DEMAND(fxl_attach_surfaces(renderer, NULL, NULL, NULL) == FXL_OK);
    DEMAND(fxl_attach_billboards(renderer, NULL, NULL, NULL) == FXL_OK);
}

void draw_attached(const fxl_scene *scene, const fxl_lens *lens, const fxl_pose *pose)
{
    static attached made;
    draw_open_room(&made.room, scene, lens, 0);
    made.pixels = draw_memory(2 * (size_t)lens->width * lens->height);
    draw_init(&made.renderer, &made.room, scene, lens);
    misuse(&made);
    misuse_horizon(&made.renderer);
    for (uint32_t i = 0; i < DRAW_TARGETS; i++) {
        for (uint32_t set = 0; set < SETS; set++) {
            draw_init(&made.renderer, &made.room, scene, lens);
            draw_choose_in(&made.renderer, &made.room, NULL, draw_targets[i]);
            draw_set(&made, set, pose);
        }
        if (scene->bsp_nodes) {
            draw_init(&made.renderer, &made.room, scene, lens);
            draw_choose_in(&made.renderer, &made.room, &fxl_by_tree, draw_targets[i]);
            draw_set(&made, OUTLINES * (i & 1u), pose);
        }
    }
    draw_close_room(&made.room);
    free(made.pixels);
}

/* --- setups ------------------------------------------------------------------- */

enum {
    PLAN_LIGHT = 1,
    PLAN_BEAMS = 2,
    PLAN_TREE = 4,
    PLANS = 8
};

static uint16_t palette[256];
static uint8_t ramp[2 * 256];

static fxl_setup_plan plan_of(const fxl_scene *scene, const fxl_config *config,
                              const fxl_light_settings *light, uint32_t set)
{
    fxl_setup_plan plan;
    memset(&plan, 0, sizeof plan);
    plan.scene = scene;
    plan.config = config;
    plan.init_renderer = fxl_renderer_init;
    if (set & PLAN_LIGHT) {
        plan.light = light;
        plan.attach_light = fxl_attach_light;
    }
    if ((set & PLAN_BEAMS) && scene->beam_count > 0) {
        plan.beam_memory_size = fxl_beam_light_workspace_size;
        plan.attach_beams = fxl_attach_beams;
    }
    if (set & PLAN_TREE) {
        plan.order = &fxl_by_tree;
        plan.pieces_size = 4096;
    }
    return plan;
}

/* The pixels that two renderers draw of one scene are the same. */
static void demand_same(fxl_renderer *by_setup, fxl_renderer *by_hand, const fxl_pose *pose,
                        const fxl_config *config)
{
    const size_t bytes = (size_t)config->width * config->height * config->target->pixel_bits / 8u;
    void *one = draw_memory(bytes), *other = draw_memory(bytes);
    const fxl_status status = fxl_render(by_setup, pose, one, config->width);
    DEMAND(status == fxl_render(by_hand, pose, other, config->width));
    DEMAND(status != FXL_OK || memcmp(one, other, bytes) == 0);
    free(one);
    free(other);
}

static void draw_plan(const fxl_setup_plan *plan, const fxl_pose *pose)
{
    static fxl_setup setup;
    static fxl_renderer by_hand;
    static fxl_light light;
    uint64_t small[1];
    const uint16_t rows = plan->config->height;
    DEMAND(fxl_setup_init(&setup, plan, rows, small, 0) == FXL_E_CAPACITY);
    DEMAND(fxl_setup_explain(&setup, plan, rows, small, 0) != NULL);
    const size_t size = setup.memory_missing;
    void *memory = draw_memory(size), *other = draw_memory(size);
    DEMAND(fxl_setup_init(&setup, plan, rows, memory, size - 1) == FXL_E_CAPACITY);
    DEMAND(setup.memory_missing == 1);
    DEMAND(fxl_setup_init(&setup, plan, rows, memory, size) == FXL_OK);
    fxl_config config = setup.config; /* the same places in another block */
    config.depth = (uint8_t *)other + ((uint8_t *)setup.config.depth - (uint8_t *)memory);
    config.tree = (uint8_t *)other + ((uint8_t *)setup.config.tree - (uint8_t *)memory);
    const size_t before = (size_t)((uint8_t *)config.depth - (uint8_t *)other) + config.depth_size;
    DEMAND(fxl_renderer_init(&by_hand, plan->scene, &config, (uint8_t *)other + before,
                             size - before) == FXL_OK);
    if (plan->attach_beams != NULL) {
        const fxl_beam_set set = {plan->scene->beams, plan->scene->beam_count, plan->scene->lit};
        DEMAND(fxl_attach_beams(&by_hand, &set, other,
                                fxl_beam_light_workspace_size(set.beams, set.count)) == FXL_OK);
    }
    DEMAND(fxl_attach_light(&by_hand, &light, plan->light) == FXL_OK);
    DEMAND(fxl_setup_frame(&setup, 7) == plan->start);
    demand_same(&setup.renderer, &by_hand, pose, plan->config);
    free(memory);
    free(other);
}

/* Steps of a plan that do nothing: the status that each of them answers. */
static fxl_status refusal;

#define STEP(name, ...) \
    static fxl_status name(__VA_ARGS__) \
    { \
        return refusal; \
    }
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-parameter"
STEP(step_centre, fxl_renderer *renderer, fxl_q16_16 x, fxl_q16_16 y)
STEP(step_motions, fxl_motion_player *player, const fxl_motion_set *set, fxl_scene *scene, const fxl_motion_memory *memory)
STEP(step_beams, fxl_renderer *renderer, const fxl_beam_set *set, void *memory, uint32_t size)
STEP(step_light, fxl_renderer *renderer, fxl_light *of, const fxl_light_settings *settings)
STEP(step_surfaces, fxl_renderer *renderer, fxl_surfaces *of, const fxl_surface_set *set, const fxl_painter *painter)
STEP(step_lit, fxl_renderer *renderer, fxl_lit_surfaces *of)
STEP(step_billboards, fxl_renderer *renderer, fxl_billboards *of, const fxl_billboard_set *set,
     const fxl_sprite_painter *painter)

static void play(const fxl_motion_player *player, uint32_t frame)
{
}

static uint32_t beam_memory_size(const fxl_beam *beams, uint32_t beam_count)
{
    return 8u * beam_count;
}
#pragma GCC diagnostic pop

/* The step, and no later one, refuses; where no step refuses, the setup is done. */
static void demand_step(const fxl_setup_plan *plan, fxl_status status, uint8_t step)
{
    static fxl_setup setup;
    DEMAND(fxl_setup_init(&setup, plan, 1, NULL, 0) == FXL_E_ARGUMENT);
    uint64_t none[1];
    DEMAND(fxl_setup_init(&setup, plan, 1, none, 0) == FXL_E_CAPACITY);
    const size_t size = setup.memory_missing;
    void *memory = draw_memory(size);
    refusal = status;
    DEMAND(fxl_setup_init(&setup, plan, 1, memory, size) == status);
    DEMAND(setup.status == status && setup.step == step);
    DEMAND((fxl_setup_frame(&setup, 7) == NULL) == (status != FXL_OK || plan->path_count == 0));
    free(memory);
}

/* Each step of a plan refuses, then none does. */
static void demand_steps(const fxl_scene *scene, const fxl_config *config, const fxl_pose *pose)
{
    fxl_setup_plan plan;
    memset(&plan, 0, sizeof plan);
    plan.scene = scene;
    plan.config = config;
    plan.init_renderer = fxl_renderer_init;
    plan.order = &fxl_by_distance;
    plan.play_motions = play;
    plan.beam_memory_size = beam_memory_size;
    plan.path = pose;
    demand_step(&plan, FXL_OK, FXL_SETUP_DONE);
    plan.path_count = 1;
    plan.attach_billboards = step_billboards;
    demand_step(&plan, FXL_E_ORDER, FXL_SETUP_BILLBOARDS);
    plan.attach_lit = step_lit;
    demand_step(&plan, FXL_E_ORDER, FXL_SETUP_LIT);
    plan.attach_surfaces = step_surfaces;
    demand_step(&plan, FXL_E_ORDER, FXL_SETUP_SURFACES);
    plan.attach_light = step_light;
    demand_step(&plan, FXL_E_ORDER, FXL_SETUP_LIGHT);
    plan.attach_beams = step_beams;
    demand_step(&plan, FXL_E_ORDER, FXL_SETUP_BEAMS);
    plan.set_centre = step_centre;
    demand_step(&plan, FXL_E_ORDER, FXL_SETUP_CENTRE);
    demand_step(&plan, FXL_OK, FXL_SETUP_DONE);
    plan.begin_motions = step_motions;
    demand_step(&plan, FXL_E_ORDER, FXL_SETUP_MOTIONS);
}

/* A call that is refused before the first step has a sentence. */
static void demand_refused(fxl_setup *setup, const fxl_setup_plan *plan, uint16_t rows,
                           void *memory, fxl_status status)
{
    DEMAND(fxl_setup_init(setup, plan, rows, memory, 0) == status);
    DEMAND(setup == NULL || fxl_setup_explain(setup, plan, rows, memory, 0) != NULL);
}

static void demand_refusals(const fxl_scene *scene, const fxl_config *config)
{
    static fxl_setup setup;
    static const fxl_scene unchecked;
    uint64_t memory[2];
    fxl_config other = *config;
    fxl_setup_plan plan, bare;
    memset(&plan, 0, sizeof plan);
    bare = plan;
    plan.scene = scene;
    plan.config = &other;
    plan.init_renderer = fxl_renderer_init;
    demand_refused(NULL, &plan, 1, memory, FXL_E_ARGUMENT);
    demand_refused(&setup, NULL, 1, memory, FXL_E_ARGUMENT);
    demand_refused(&setup, &plan, 1, NULL, FXL_E_ARGUMENT);
    demand_refused(&setup, &bare, 1, memory, FXL_E_ARGUMENT);
    bare.scene = scene;
    demand_refused(&setup, &bare, 1, memory, FXL_E_ARGUMENT);
    bare.scene = &unchecked;
    bare.config = config;
    demand_refused(&setup, &bare, 1, memory, FXL_E_ARGUMENT);
    bare.init_renderer = fxl_renderer_init;
    demand_refused(&setup, &bare, 1, memory, FXL_E_ORDER);
    demand_refused(&setup, &plan, 1, (uint8_t *)memory + 4, FXL_E_ALIGNMENT);
    other.target = NULL;
    demand_refused(&setup, &plan, 1, memory, FXL_E_ARGUMENT);
    other.target = &fxl_rgb565_depth_16;
    demand_refused(&setup, &plan, 0, memory, FXL_E_RANGE);
    demand_refused(&setup, &plan, (uint16_t)(config->height + 1u), memory, FXL_E_RANGE);
    other.height = FXL_SCREEN_MAX + 1;
    demand_refused(&setup, &plan, 1, memory, FXL_E_RANGE);
    other = *config;
    other.width = FXL_SCREEN_MAX + 1;
    demand_refused(&setup, &plan, 1, memory, FXL_E_RANGE);
    memset(&setup, 0, sizeof setup);
    DEMAND(fxl_setup_frame(NULL, 0) == NULL && fxl_setup_frame(&setup, 0) == NULL);
}

void draw_setup(const fxl_scene *scene, const fxl_lens *lens, const fxl_pose *pose)
{
    static const fxl_target *const targets[] = {&fxl_palette, &fxl_rgb565_depth_16};
    fxl_light_settings settings;
    memset(&settings, 0, sizeof settings);
    settings.ambient = FXL_Q2_30_ONE / 2;
    settings.levels = 2;
    settings.ramp = ramp;
    for (uint32_t i = 0; i < 2; i++) {
        fxl_config config = fxl_config_for(lens->width, lens->height, targets[i]);
        config.palette = palette;
        for (uint32_t set = 0; set < PLANS; set++) {
            const fxl_setup_plan plan = plan_of(scene, &config, &settings, set);
            draw_plan(&plan, pose);
        }
        demand_refusals(scene, &config);
        demand_steps(scene, &config, pose);
    }
}

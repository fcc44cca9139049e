/* SPDX-License-Identifier: MIT */
/* Setups of a scene in exactly the memory that they ask for: each draws what the calls by hand
 * draw, or is refused with a sentence; a step that refuses ends a setup. Takes no input and records
 * nothing. */
#include <stdlib.h>
#include <string.h>

#include "answers.h"
#include "draw.h"
#include "fixel/setup.h"

enum {
    LIGHT = 1,
    BEAMS = 2,
    TREE = 4,
    SETS = 8
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
    if (set & LIGHT) {
        plan.light = light;
        plan.attach_light = fxl_attach_light;
    }
    if ((set & BEAMS) && scene->beam_count > 0) {
        plan.beam_memory_size = fxl_beam_light_workspace_size;
        plan.attach_beams = fxl_attach_beams;
    }
    if (set & TREE) {
        plan.order = &fxl_by_tree;
        plan.pieces_size = 4096;
    }
    return plan;
}

/* place pixel-format: random input */
/* The pixels that two renderers draw of one scene are the same. */
static void demand_same(fxl_renderer *by_setup, fxl_renderer *by_hand, const fxl_pose *pose,
                        const fxl_config *config)
{
    const size_t bytes = (size_t)config->width * config->height * config->target->pixel_bits / 8u;
    void *one = malloc(bytes), *other = malloc(bytes);
    DEMAND(one != NULL && other != NULL);
    const fxl_status status = fxl_render(by_setup, pose, one, config->width);
    DEMAND(status == fxl_render(by_hand, pose, other, config->width));
    DEMAND(status != FXL_OK || memcmp(one, other, bytes) == 0);
    free(one);
    free(other);
}

static void draw(const fxl_setup_plan *plan, const fxl_pose *pose)
{
    static fxl_setup setup;
    static fxl_renderer by_hand;
    static fxl_light light;
    uint64_t small[1];
    const uint16_t rows = plan->config->height;
    DEMAND(fxl_setup_init(&setup, plan, rows, small, 0) == FXL_E_CAPACITY);
    DEMAND(fxl_setup_explain(&setup, plan, rows, small, 0) != NULL);
    const size_t size = setup.memory_missing;
    void *memory = malloc(size), *other = malloc(size);
    DEMAND(memory != NULL && other != NULL);
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

static fxl_status step_centre(fxl_renderer *renderer, fxl_q16_16 x, fxl_q16_16 y)
{
    (void)renderer;
    (void)x;
    (void)y;
    return refusal;
}

static fxl_status step_motions(fxl_motion_player *player, const fxl_motion_set *set,
                               fxl_scene *scene, const fxl_motion_memory *memory)
{
    (void)player;
    (void)set;
    (void)scene;
    (void)memory;
    return refusal;
}

static void play(const fxl_motion_player *player, uint32_t frame)
{
    (void)player;
    (void)frame;
}

static uint32_t beam_memory_size(const fxl_beam *beams, uint32_t beam_count)
{
    (void)beams;
    return 8u * beam_count;
}

static fxl_status step_beams(fxl_renderer *renderer, const fxl_beam_set *set, void *memory,
                             uint32_t size)
{
    (void)renderer;
    (void)set;
    (void)memory;
    (void)size;
    return refusal;
}

static fxl_status step_light(fxl_renderer *renderer, fxl_light *of,
                             const fxl_light_settings *settings)
{
    (void)renderer;
    (void)of;
    (void)settings;
    return refusal;
}

static fxl_status step_surfaces(fxl_renderer *renderer, fxl_surfaces *of,
                                const fxl_surface_set *set, const fxl_painter *painter)
{
    (void)renderer;
    (void)of;
    (void)set;
    (void)painter;
    return refusal;
}

static fxl_status step_lit(fxl_renderer *renderer, fxl_lit_surfaces *of)
{
    (void)renderer;
    (void)of;
    return refusal;
}

static fxl_status step_billboards(fxl_renderer *renderer, fxl_billboards *of,
                                  const fxl_billboard_set *set, const fxl_sprite_painter *painter)
{
    (void)renderer;
    (void)of;
    (void)set;
    (void)painter;
    return refusal;
}

/* The step, and no later one, refuses; where no step refuses, the setup is done. */
static void demand_step(const fxl_setup_plan *plan, fxl_status status, uint8_t step)
{
    static fxl_setup setup;
    DEMAND(fxl_setup_init(&setup, plan, 1, NULL, 0) == FXL_E_ARGUMENT);
    uint64_t none[1];
    DEMAND(fxl_setup_init(&setup, plan, 1, none, 0) == FXL_E_CAPACITY);
    const size_t size = setup.memory_missing;
    void *memory = malloc(size);
    DEMAND(memory != NULL);
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
        for (uint32_t set = 0; set < SETS; set++) {
            const fxl_setup_plan plan = plan_of(scene, &config, &settings, set);
            draw(&plan, pose);
        }
        demand_refusals(scene, &config);
        demand_steps(scene, &config, pose);
    }
}

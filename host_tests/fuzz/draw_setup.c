/* SPDX-License-Identifier: MIT */
/* Setups of a scene in exactly the memory that they ask for: each draws what the calls by hand draw,
 * or is refused with a sentence. Takes no input and records nothing. */
#include <stdlib.h>
#include <string.h>

#include "demand.h"
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

void draw_setup(const fxl_scene *scene, const fxl_lens *lens, const fxl_pose *pose)
{
    static const fxl_target *const targets[] = {&fxl_palette, &fxl_rgb565_depth_16};
    fxl_light_settings light;
    memset(&light, 0, sizeof light);
    light.ambient = FXL_Q2_30_ONE / 2;
    light.levels = 2;
    light.ramp = ramp;
    for (uint32_t i = 0; i < 2; i++) {
        fxl_config config = fxl_config_for(lens->width, lens->height, targets[i]);
        config.palette = palette;
        for (uint32_t set = 0; set < SETS; set++) {
            const fxl_setup_plan plan = plan_of(scene, &config, &light, set);
            draw(&plan, pose);
        }
    }
}

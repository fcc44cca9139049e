/* SPDX-License-Identifier: MIT */
/* Sets an exported scene up. The plan has the functions: what a scene lacks is not linked. */
#include "setup.h"

#include "../math/arith.h"
#include "../math/memory.h"

static uint32_t aligned(size_t bytes)
{
    return ((uint32_t)bytes + 7u) & ~7u;
}

/* A checked scene has at most FXL_SCENE_INSTANCES_MAX instances, each with a record of less than 64
 * bytes, and draw_list_needed entries of 12 bytes for at most 131,070: the sum of all shares is
 * below 2^24 but for the depth buffer, which is at most 2^22 + 8, and the tree's below 2^20. */
FXL_COLD fxl_status fxl_setup_divide(const fxl_setup *setup, const fxl_setup_plan *plan,
                                     uint16_t rows, const void *memory, fxl_setup_shares *shares)
{
    if (setup == NULL || plan == NULL || memory == NULL || plan->scene == NULL ||
        plan->config == NULL || plan->config->target == NULL || plan->init_renderer == NULL) {
        return FXL_E_ARGUMENT;
    }
    const fxl_scene *scene = plan->scene;
    const fxl_config *config = plan->config;
    const uint32_t depth_bits = config->target->depth_bits;
    if (((uintptr_t)memory & 7u) != 0) {
        return FXL_E_ALIGNMENT;
    }
    if (scene->draw_list_needed == 0) {
        return FXL_E_ORDER;
    }
    if (config->width > FXL_SCREEN_MAX || config->height > FXL_SCREEN_MAX ||
        (depth_bits != 0 && (rows < 1 || rows > config->height))) {
        return FXL_E_RANGE;
    }
    memset(shares, 0, sizeof *shares);
    if (plan->begin_motions != NULL) {
        shares->instances = aligned(scene->instance_count * sizeof(fxl_instance));
        shares->motions =
            shares->instances +
            aligned((scene->instance_count - scene->first_turned) * sizeof(fxl_placement));
    }
    if (plan->beam_memory_size != NULL) {
        shares->beams = aligned(plan->beam_memory_size(scene->beams, scene->beam_count));
    }
    if (plan->order != NULL && plan->order->memory_size != NULL) {
        shares->tree = aligned(plan->order->memory_size(scene)) + aligned(plan->pieces_size);
    }
    if (depth_bits != 0) {
        shares->depth = FXL_DEPTH_BYTES(config->width, rows, depth_bits);
    }
    if (plan->attach_lines != NULL) {
        shares->lines = aligned(sizeof(fxl_lines));
    }
    shares->before_renderer =
        shares->motions + shares->beams + shares->tree + shares->lines + shares->depth;
    if (!plan->has_tables) {
        shares->renderer = aligned(scene->draw_list_needed * sizeof(fxl_draw_entry));
    }
    return FXL_OK;
}

/* Sets up the renderer, over copies of what moves. block: of the size that the shares ask for. */
static FXL_COLD fxl_status begin(fxl_setup *setup, const fxl_setup_plan *plan,
                                 const fxl_setup_shares *shares, uint8_t *block, size_t size)
{
    fxl_config *config = &setup->config;
    fxl_status status = FXL_OK;
    setup->step = FXL_SETUP_MOTIONS;
    if (plan->begin_motions != NULL) {
        const fxl_motion_memory copies = {
            (fxl_instance *)(void *)block, setup->scene.instance_count,
            (fxl_placement *)(void *)(block + shares->instances),
            setup->scene.instance_count - setup->scene.first_turned};
        status = plan->begin_motions(&setup->motion, plan->motions, &setup->scene, &copies);
    }
    if (status != FXL_OK) {
        return status;
    }
    setup->step = FXL_SETUP_RENDERER;
    config->order = plan->order;
    config->tree = block + shares->motions + shares->beams;
    config->tree_size = shares->tree;
    config->depth = block + shares->before_renderer - shares->depth;
    config->depth_size = shares->depth;
    status = plan->init_renderer(&setup->renderer, &setup->scene, config,
                                 block + shares->before_renderer, size - shares->before_renderer);
    if (status == FXL_OK && plan->set_orthographic != NULL) {
        setup->step = FXL_SETUP_CENTRE;
        status = plan->set_orthographic(&setup->renderer, plan->scale);
    }
    if (status == FXL_OK && plan->set_centre != NULL) {
        setup->step = FXL_SETUP_CENTRE;
        status = plan->set_centre(&setup->renderer, plan->centre_x, plan->centre_y);
    }
    return status;
}

/* Attaches what the plan has to the renderer. block: as that of begin. */
static FXL_COLD fxl_status attach(fxl_setup *setup, const fxl_setup_plan *plan,
                                  const fxl_setup_shares *shares, uint8_t *block)
{
    fxl_renderer *renderer = &setup->renderer;
    fxl_status status = FXL_OK;
    if (plan->attach_beams != NULL) {
        const fxl_beam_set set = {setup->scene.beams, setup->scene.beam_count, setup->scene.lit};
        setup->step = FXL_SETUP_BEAMS;
        status = plan->attach_beams(renderer, &set, block + shares->motions, shares->beams);
    }
    if (status == FXL_OK && plan->attach_light != NULL) {
        setup->step = FXL_SETUP_LIGHT;
        status = plan->attach_light(renderer, &setup->light, plan->light);
    }
    if (status == FXL_OK && plan->attach_surfaces != NULL) {
        setup->step = FXL_SETUP_SURFACES;
        status =
            plan->attach_surfaces(renderer, &setup->surfaces, plan->surfaces, plan->painter);
    }
    if (status == FXL_OK && plan->attach_lit != NULL) {
        setup->step = FXL_SETUP_LIT;
        status = plan->attach_lit(renderer, &setup->lit);
    }
    if (status == FXL_OK && plan->attach_billboards != NULL) {
        setup->step = FXL_SETUP_BILLBOARDS;
        status = plan->attach_billboards(renderer, &setup->billboards, plan->billboards,
                                         plan->sprite_painter);
    }
    if (status == FXL_OK && plan->attach_lines != NULL) {
        setup->step = FXL_SETUP_LINES;
        fxl_lines *lines = (fxl_lines *)(void *)(block + shares->motions + shares->beams + shares->tree);
        status = plan->attach_lines(renderer, lines, plan->lines);
    }
    if (status == FXL_OK && plan->attach_horizon != NULL) {
        setup->step = FXL_SETUP_HORIZON;
        status = plan->attach_horizon(renderer, plan->horizon);
    }
    return status;
}

FXL_COLD fxl_status fxl_setup_init(fxl_setup *setup, const fxl_setup_plan *plan, uint16_t rows,
                                   void *memory, size_t memory_size)
{
    fxl_setup_shares shares;
    uint8_t *block = (uint8_t *)memory;
    fxl_status status = fxl_setup_divide(setup, plan, rows, memory, &shares);
    if (status != FXL_OK) {
        return status;
    }
    const size_t least = (size_t)shares.before_renderer + shares.renderer;
    if (memory_size < least) {
        setup->memory_missing = least - memory_size;
        return FXL_E_CAPACITY;
    }
    memset(setup, 0, sizeof *setup);
    setup->scene = *plan->scene;
    setup->config = *plan->config;
    status = begin(setup, plan, &shares, block, memory_size);
    if (status == FXL_OK) {
        status = attach(setup, plan, &shares, block);
    }
    setup->status = status;
    if (status == FXL_OK) {
        setup->step = FXL_SETUP_DONE;
        setup->plan = plan;
    }
    return status;
}

const fxl_pose *fxl_setup_frame(fxl_setup *setup, uint32_t frame)
{
    if (setup == NULL || setup->plan == NULL) {
        return NULL;
    }
    const fxl_setup_plan *plan = setup->plan;
    if (plan->play_motions != NULL) {
        plan->play_motions(&setup->motion, frame);
    }
    if (plan->path == NULL || plan->path_count == 0) {
        return plan->start;
    }
    uint32_t remainder;
    (void)fxl_divide_u32(frame, plan->path_count, &remainder);
    return &plan->path[remainder];
}

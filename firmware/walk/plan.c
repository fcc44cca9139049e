/* SPDX-License-Identifier: MIT */
#include "plan.h"

#include "fixel/all.h"

/* What fxl_renderer_init_with has chosen already: a small program chooses nothing. */
#if defined WALK_WITHOUT_BSP && defined WALK_WITHOUT_DEPTH && defined WALK_WITHOUT_RGB565 && \
    !defined WALK_TARGET && !defined WALK_BY_TREE && (!defined WALK_DEPTH_BITS || WALK_DEPTH_BITS == 0)
#define ONLY_THE_RENDERERS_OWN
#endif

#if !defined WALK_WITHOUT_SURFACES || defined WALK_SURFACES
#define HAS_SURFACES
#endif

static walk_plan *under_way; /* for init_renderer */

static uint32_t aligned(size_t bytes)
{
    return ((uint32_t)bytes + 7u) & ~7u;
}

static walk_shares shares_of(const walk_plan *of)
{
    const fxl_scene_image *image = of->image;
    const fxl_target *target = of->methods->draws.target;
    walk_shares found = {0, 0, 0, aligned(of->methods->clipper->workspace_size), 0};

    if (target->pixel_bits == 16) {
        found.palette = 256u * sizeof(uint16_t);
    }
#if defined HAS_SURFACES
    if (image->surfaces.face_map != NULL && of->methods->draws.surfaces != NULL) {
        found.surfaces = aligned(sizeof(fxl_surface_set) + image->surfaces.texture_count * sizeof(fxl_texture));
    }
#endif
#if !defined WALK_WITHOUT_BILLBOARDS
    if (image->billboards.model_map != NULL && of->methods->draws.sprites != NULL) {
        found.billboards = aligned(sizeof(fxl_billboard_set) +
                                   image->billboards.count * (sizeof(fxl_billboard) + sizeof(fxl_sprite)));
    }
#endif
    if (target->memory_size != NULL && target->depth_bits == 0) {
        found.target = aligned(target->memory_size(&image->lens));
    }
    return found;
}

static uint32_t sum_of(const walk_shares *of)
{
    return of->palette + of->surfaces + of->billboards + of->clipper + of->target;
}

/* The palette in RGB565. */
static const uint16_t *make_palette(const fxl_scene_image *image, uint8_t *memory)
{
    uint16_t *const palette = (uint16_t *)(void *)memory;
    uint32_t i;

    for (i = 0; i < 256; i++) {
        const uint8_t *colour = image->palette + 3 * i;
        palette[i] = FXL_RGB565(colour[0], colour[1], colour[2]);
    }
    return palette;
}

/* The lens of an image. */
static fxl_status lens_of(const fxl_scene_image *image, fxl_lens *lens)
{
    *lens = image->lens;
#if !defined WALK_WITHOUT_ORTHOGRAPHIC
    if (image->scale != 0) {
        const fxl_status status =
            fxl_lens_orthographic(lens->width, lens->height, image->scale, lens->near_z, lens->far_z, lens);
        return status != FXL_OK ? status
                                : fxl_lens_set_centre(lens, image->lens.centre_x, image->lens.centre_y);
    }
#endif
    return FXL_OK;
}

/* In the place of fxl_renderer_init: with the image's lens, the caller's tables, and a clipper and a
 * target that may be others. */
static fxl_status init_renderer(fxl_renderer *renderer, const fxl_scene *scene,
                                const fxl_config *config, void *memory, size_t size)
{
    walk_plan *const of = under_way;
    const fxl_scene *drawn = of->scene != NULL ? of->scene : scene;
    fxl_memory tables = of->tables;
    fxl_lens lens;
    fxl_status status = lens_of(of->image, &lens);

    of->used = of->size - (uint32_t)size;
    if (tables.display_list == NULL) {
        tables.display_list = memory;
        tables.display_list_capacity = (of->list_most < size ? of->list_most : (uint32_t)size) / 4;
    }
    of->entries = drawn->draw_list_needed;
    if (status == FXL_OK) {
        status = fxl_renderer_init_with(renderer, drawn, &lens, &tables);
    }
    if (status == FXL_OK) {
        status = fxl_renderer_set_clipper(renderer, of->methods->clipper, of->clipper_memory,
                                          of->taken.clipper);
    }
#if defined ONLY_THE_RENDERERS_OWN
    (void)config;
    return status;
#else
    fxl_config chosen = *config;

    if (of->taken.target > 0) {
        chosen.depth = of->clipper_memory + of->taken.clipper;
        chosen.depth_size = of->taken.target;
    }
    return status == FXL_OK ? fxl_renderer_choose(renderer, &chosen) : status;
#endif
}

/* In the place of init_renderer, where nothing but sizes is asked for. */
static fxl_status measure(fxl_renderer *renderer, const fxl_scene *scene, const fxl_config *config,
                          void *memory, size_t size)
{
    (void)renderer;
    (void)scene;
    (void)config;
    (void)memory;
    (void)size;
    return FXL_E_CAPACITY;
}

/* The parts that ask for memory: the scene, beams, order, target. */
static void plan_parts(walk_plan *of, fxl_setup_plan *plan)
{
    const fxl_scene_image *image = of->image;
    fxl_config *config = &of->config;

    config->width = image->lens.width;
    config->height = image->lens.height;
    config->background = image->background;
    config->target = of->methods->draws.target;
    of->scene = plan->scene;
    plan->scene = &image->scene;
    plan->config = config;
    plan->order = of->methods->order;
    plan->init_renderer = measure;
    plan->has_tables = true;
    plan->palette = image->palette;
    if (image->scene.beam_count > 0) {
        plan->beam_memory_size = fxl_beam_light_workspace_size;
        plan->attach_beams = fxl_attach_beams;
    }
}

/* Whether instances are to be cut to the leaves of the tree. */
static bool has_movers(const fxl_scene *scene)
{
    const uint8_t layer = scene->instances[scene->bsp_instance].layer;
    uint32_t count = 0, i;

    for (i = 0; i < scene->instance_count; i++) {
        count += scene->instances[i].layer == layer;
    }
    return count > 1;
}

/* Gives half of what is left to what draws in fewer instructions with more: rows of a depth buffer, a target's
 * memory, or pieces of what moves among a tree. The display list has the rest. Returns the rows. */
static uint16_t share_rest(walk_plan *of, fxl_setup_plan *plan)
{
    const fxl_scene *scene = plan->scene;
    uint32_t half = (of->size - of->needed) / 2u & ~7u;
    const uint32_t depth_bits = of->config.target->depth_bits, height = of->config.height;
    uint32_t rows = of->rows;

    if (depth_bits != 0 && rows == 0) {
        const uint32_t width = of->config.width;

        rows = (FXL_DEPTH_BYTES(width, 1, depth_bits) - 8u + half) / (width * (depth_bits / 8u));
        rows = rows < height ? rows : height;
    }
    if (of->taken.target > 0) {
        of->taken.target += half;
        half = half / 2u & ~7u; /* of what is left then */
    }
    if (plan->order->memory_size != NULL && scene->bsp_nodes != NULL && has_movers(scene)) {
        plan->pieces_size = half;
    }
    return (uint16_t)rows;
}

/* Opens the parts that lie in the block: palette, surfaces and billboards, one after the other. */
static fxl_status open_parts(walk_plan *of, fxl_setup_plan *plan)
{
    const fxl_scene_image *image = of->image;
    const walk_target *draws = &of->methods->draws;
    uint8_t *memory = of->block;
    fxl_status status = FXL_OK;

    if (of->taken.palette > 0) {
        of->config.palette = make_palette(image, memory);
        memory += of->taken.palette;
    }
    if (image->light.base != NULL) {
        fxl_light_settings_of(&image->light, &of->light);
        plan->light = &of->light;
        plan->attach_light = fxl_attach_light;
    }
#if defined HAS_SURFACES
    if (of->taken.surfaces > 0) {
        fxl_surface_set *const set = (fxl_surface_set *)(void *)memory;

        status = fxl_surfaces_open(image, (fxl_texture *)(void *)(set + 1), image->surfaces.texture_count,
                                   set, NULL);
        memory += of->taken.surfaces;
        plan->surfaces = set;
        plan->painter = draws->surfaces;
        plan->attach_surfaces = fxl_attach_surfaces;
        plan->attach_lit = image->light.base != NULL ? fxl_attach_lit : NULL;
    }
#endif
#if !defined WALK_WITHOUT_BILLBOARDS
    if (of->taken.billboards > 0 && status == FXL_OK) {
        fxl_billboard_set *const set = (fxl_billboard_set *)(void *)memory;
        fxl_billboard *const boards = (fxl_billboard *)(void *)(set + 1);
        const uint32_t count = image->billboards.count;

        status = fxl_billboards_open(image, (fxl_sprite *)(void *)(boards + count), boards, count, set, NULL);
        memory += of->taken.billboards;
        plan->billboards = set;
        plan->sprite_painter = draws->sprites;
        plan->attach_billboards = fxl_attach_billboards;
    }
#endif
#if !defined WALK_WITHOUT_LINES
    if (image->lines.line_map != NULL) {
        plan->lines = &image->lines;
        plan->attach_lines = fxl_attach_lines;
    }
#endif
#if !defined WALK_WITHOUT_HORIZON
    if (image->horizon.sines != NULL) {
        static fxl_horizon horizon; /* a renderer keeps a pointer to it */

        horizon = image->horizon;
        plan->horizon = &horizon;
        plan->attach_horizon = fxl_attach_horizon;
    }
#endif
    (void)draws;
    of->clipper_memory = memory;
    return status;
}

fxl_status walk_plan_open(walk_plan *of, fxl_setup_plan *plan, fxl_setup *setup)
{
    uint32_t before;
    fxl_status status;

    under_way = of;
    of->taken = shares_of(of);
    before = sum_of(&of->taken);
    plan_parts(of, plan);
    setup->memory_missing = 0;
    status = fxl_setup_init(setup, plan, of->rows > 0 ? of->rows : 1, of->block, 0);
    of->needed = before + (uint32_t)setup->memory_missing;
    if (status == FXL_E_CAPACITY && of->needed <= of->size) {
        status = open_parts(of, plan);
    }
    if (status == FXL_OK) {
        const uint16_t rows = share_rest(of, plan);

        before = sum_of(&of->taken);
        plan->init_renderer = init_renderer;
        status = fxl_setup_init(setup, plan, rows, of->block + before, of->size - before);
    }
    plan->scene = NULL; /* what is copied, and lies in the image or in *of */
    plan->config = NULL;
    plan->motions = NULL;
    plan->light = NULL;
    plan->lines = NULL;
    plan->horizon = NULL;
    under_way = NULL;
    return status;
}

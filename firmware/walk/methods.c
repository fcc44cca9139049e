/* SPDX-License-Identifier: MIT */
#include "methods.h"

#include "fixel/all.h"
#include "study/study.h"

#ifndef WALK_CLIPPER
#define WALK_CLIPPER fxl_clipper_view
#endif

/* place pixel-format: whether the program links a target for the scene */
/* What fxl_renderer_init_with has chosen already: a small program chooses nothing. */
#if defined WALK_WITHOUT_BSP && defined WALK_WITHOUT_DEPTH && defined WALK_WITHOUT_RGB565 && \
    !defined WALK_TARGET && !defined WALK_BY_TREE && (!defined WALK_DEPTH_BITS || WALK_DEPTH_BITS == 0)
#define ONLY_THE_RENDERERS_OWN
#endif

/* --- what is chosen --------------------------------------------------------------------------- */

uint8_t walk_methods_depth_bits(const fxl_scene_image *image)
{
#if defined WALK_DEPTH_BITS
    (void)image;
    return WALK_DEPTH_BITS;
#else
    return image->depth_bits;
#endif
}

/* Null: the board has none of the kind. */
static const walk_target *target_of(uint8_t pixel_bits, uint8_t depth_bits)
{
    uint32_t i;

    for (i = 0; i < walk_target_count; i++) {
        const fxl_target *target = walk_targets[i].target;

        if (target->pixel_bits == pixel_bits && target->depth_bits == depth_bits) {
            return &walk_targets[i];
        }
    }
    return NULL;
}

bool walk_methods_draw(uint8_t pixel_bits, uint8_t depth_bits)
{
    return target_of(pixel_bits, depth_bits) != NULL;
}

/* Null: the board has no room for a tree. */
static const fxl_order *order_of(const fxl_scene_image *image)
{
#if defined WALK_BY_TREE
    (void)image;
    return &fxl_by_tree;
#elif defined WALK_BY_DISTANCE
    (void)image;
    return &fxl_by_distance;
#elif defined WALK_WITHOUT_BSP
    return image->scene.bsp_nodes == NULL || image->by_distance ? &fxl_by_distance : NULL;
#else
    return image->scene.bsp_nodes == NULL || image->by_distance ? &fxl_by_distance : &fxl_by_tree;
#endif
}

/* --- memory --------------------------------------------------------------------------------------- */

static uint32_t aligned(uint32_t bytes)
{
    return (bytes + 7u) & ~7u;
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

/* A share of what is left: the display list has the rest. */
static uint32_t share_of(uint32_t room, uint32_t used)
{
    return room > used ? (room - used) / 2u & ~7u : 0;
}

bool walk_methods_choose(walk_methods *methods, const fxl_scene_image *image, uint32_t room)
{
    const fxl_scene *scene = &image->scene;
    const walk_target *draws = 
        target_of(image->pixel_bits, walk_methods_depth_bits(image));

#if defined WALK_WITHOUT_BILLBOARDS
    if (image->billboards.model_map != NULL) {
        return false;
    }
#endif
    methods->clipper = &WALK_CLIPPER;
    methods->order = order_of(image);
    if (draws == NULL || methods->order == NULL) {
        return false;
    }
    methods->draws = *draws;
#if !defined WALK_FLAT
    if (image->surfaces.face_map != NULL && draws->surfaces == NULL) {
        return false;
    }
#endif
    methods->clipper_bytes = aligned(methods->clipper->workspace_size);
    methods->palette_bytes = draws->target->pixel_bits == 16 ? 256u * sizeof(uint16_t) : 0;
    methods->depth_bytes = 0;
    methods->tree_bytes = 0;
    if (draws->target->memory_size != NULL) {
        methods->depth_bytes = aligned(draws->target->memory_size(&image->lens));
        methods->depth_bytes += share_of(room, walk_methods_bytes(methods));
    }
    if (methods->order->memory_size != NULL) {
        methods->tree_bytes = aligned(methods->order->memory_size(scene));
        if (scene->bsp_nodes != NULL && has_movers(scene)) {
            methods->tree_bytes += share_of(room, walk_methods_bytes(methods));
        }
    }
    return true;
}

uint32_t walk_methods_bytes(const walk_methods *methods)
{
    return methods->clipper_bytes + methods->palette_bytes + methods->depth_bytes +
           methods->tree_bytes;
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

fxl_status walk_methods_set(const walk_methods *methods, const fxl_scene_image *image,
                            fxl_renderer *renderer, uint8_t *memory)
{
    uint8_t *const palette = memory + methods->clipper_bytes;
    uint8_t *const depth = palette + methods->palette_bytes;
    const fxl_config config = {
        .order = methods->order,
        .target = methods->draws.target,
        .palette = methods->palette_bytes > 0 ? make_palette(image, palette) : NULL,
        .depth = depth,
        .depth_size = methods->depth_bytes,
        .tree = depth + methods->depth_bytes,
        .tree_size = methods->tree_bytes};
    const fxl_status status =
        fxl_renderer_set_clipper(renderer, methods->clipper, memory, methods->clipper_bytes);

#if defined ONLY_THE_RENDERERS_OWN
    (void)config;
    return status;
#else
    return status == FXL_OK ? fxl_renderer_choose(renderer, &config) : status;
#endif
}

uint32_t walk_methods_unsplit(const walk_methods *methods, const fxl_renderer *renderer)
{
#if defined WALK_BY_DISTANCE || (defined WALK_WITHOUT_BSP && !defined WALK_BY_TREE)
    (void)methods;
    (void)renderer;
    return 0;
#else
    return methods->order == &fxl_by_tree && renderer->scene->bsp_nodes != NULL
               ? ((const fxl_bsp_workspace *)renderer->order_memory)->unsplit
               : 0;
#endif
}

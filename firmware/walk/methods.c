/* SPDX-License-Identifier: MIT */
#include "methods.h"

#include "fixel/all.h"
#include "study/study.h"

#ifndef WALK_CLIPPER
#define WALK_CLIPPER fxl_clipper_view
#endif

/* place pixel-format: whether the program links a target for the scene */
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

bool walk_methods_choose(walk_methods *methods, const fxl_scene_image *image)
{
    const walk_target *draws = 
        target_of(image->pixel_bits, walk_methods_depth_bits(image));

    methods->clipper = &WALK_CLIPPER;
    methods->order = order_of(image);
    if (draws == NULL || methods->order == NULL) {
        return false;
    }
    if (image->billboards.model_map != NULL && draws->sprites == NULL) {
        return false;
    }
#if defined WALK_WITHOUT_LINES
    if (image->lines.line_map != NULL) {
        return false;
    }
#endif
#if defined WALK_WITHOUT_HORIZON
    if (image->horizon.sines != NULL) {
        return false;
    }
#endif
    methods->draws = *draws;
#if !defined WALK_FLAT
    if (image->surfaces.face_map != NULL && draws->surfaces == NULL) {
        return false;
    }
#endif
    return true;
}

uint32_t walk_methods_unsplit(const fxl_renderer *renderer)
{
#if defined WALK_BY_DISTANCE || (defined WALK_WITHOUT_BSP && !defined WALK_BY_TREE)
    (void)renderer;
    return 0;
#else
    return renderer->order == &fxl_by_tree && renderer->scene->bsp_nodes != NULL
               ? ((const fxl_bsp_workspace *)renderer->order_memory)->unsplit
               : 0;
#endif
}

/* SPDX-License-Identifier: MIT */
#include "methods.h"

#include "fixel/all.h"
#include "study/study.h"

#ifndef WALK_CLIPPER
#define WALK_CLIPPER fxl_clipper_view
#endif

static uint32_t aligned(uint32_t bytes)
{
    return (bytes + 7u) & ~7u;
}

static const fxl_visibility *visibility_of(const fxl_scene_image *image)
{
#if defined WALK_VISIBILITY
    (void)image;
    return &WALK_VISIBILITY;
#else
    if (image->depth_bits != 0) {
#if defined WALK_WITHOUT_DEPTH
        return NULL;
#else
        return &fxl_visibility_depth;
#endif
    }
    if (image->scene.bsp_nodes == NULL && image->surfaces.face_map == NULL) {
        return &fxl_visibility_sorted;
    }
    if (image->scene.bsp_nodes == NULL) {
#if defined WALK_WITHOUT_SURFACES
        return NULL;
#else
        return &fxl_visibility_surfaces;
#endif
    }
#if defined WALK_WITHOUT_BSP
    return NULL;
#else
    return &fxl_visibility_bsp;
#endif
#endif
}

static bool draws_by_bsp(const walk_methods *methods, const fxl_scene *scene)
{
#if defined WALK_WITHOUT_BSP && !defined WALK_TREE
    (void)methods;
    (void)scene;
    return false;
#else
    return scene->bsp_nodes != NULL &&
           methods->visibility->order->memory_size == fxl_visibility_bsp.order->memory_size;
#endif
}

#if defined WALK_DEPTH || (!defined WALK_VISIBILITY && !defined WALK_WITHOUT_DEPTH)
#define HAS_DEPTH

static fxl_depth depth;

static bool is_depth(const fxl_visibility *visibility)
{
#if defined WALK_DEPTH
    (void)visibility;
    return true;
#else
    return visibility == &fxl_visibility_depth;
#endif
}

static fxl_status set_depth(const walk_methods *methods, fxl_renderer *renderer, uint8_t *memory)
{
    return fxl_renderer_set_depth(renderer, &depth, methods->visibility, memory,
                                  methods->visibility_bytes);
}

#else

static bool is_depth(const fxl_visibility *visibility)
{
    (void)visibility;
    return false;
}

static fxl_status set_depth(const walk_methods *methods, fxl_renderer *renderer, uint8_t *memory)
{
    (void)methods;
    (void)renderer;
    (void)memory;
    return FXL_E_ARGUMENT;
}

#endif

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

#if defined WALK_WITHOUT_BILLBOARDS
    if (image->billboards.model_map != NULL) {
        return false;
    }
#endif
    methods->clipper = &WALK_CLIPPER;
    methods->visibility = visibility_of(image);
    if (methods->visibility == NULL) {
        return false;
    }
    methods->clipper_bytes = aligned(methods->clipper->workspace_size);
    methods->visibility_bytes = 0;
    methods->piece_bytes = 0;
    if (methods->visibility->order->memory_size != NULL) {
        methods->visibility_bytes = aligned(methods->visibility->order->memory_size(scene));
    }
    if (methods->visibility->target->memory_size != NULL) {
        methods->visibility_bytes +=
            aligned(methods->visibility->target->memory_size(&image->lens));
        methods->visibility_bytes += share_of(room, walk_methods_bytes(methods));
    }
    if (draws_by_bsp(methods, scene) && has_movers(scene)) {
        methods->piece_bytes = share_of(room, walk_methods_bytes(methods));
    }
    return true;
}

uint32_t walk_methods_bytes(const walk_methods *methods)
{
    return methods->clipper_bytes + methods->visibility_bytes + methods->piece_bytes;
}

fxl_status walk_methods_set(const walk_methods *methods, fxl_renderer *renderer, uint8_t *memory)
{
    uint8_t *const visibility = memory + methods->clipper_bytes;
    fxl_status status =
        fxl_renderer_set_clipper(renderer, methods->clipper, memory, methods->clipper_bytes);

    if (status == FXL_OK) {
        status = is_depth(methods->visibility)
                     ? set_depth(methods, renderer, visibility)
                     : fxl_renderer_set_visibility(renderer, methods->visibility, visibility,
                                                   methods->visibility_bytes);
    }
    if (status == FXL_OK && draws_by_bsp(methods, renderer->scene)) {
        fxl_bsp_workspace *const bsp = renderer->order_memory;
        bsp->pieces = visibility + methods->visibility_bytes;
        bsp->pieces_size = methods->piece_bytes;
    }
    return status;
}

#if !defined WALK_WITHOUT_BILLBOARDS

fxl_status walk_methods_add_billboards(fxl_renderer *renderer, fxl_billboards *billboards,
                                       const fxl_billboard_set *set)
{
#if defined HAS_DEPTH
    if (renderer->target->depth_bits != 0) {
        return fxl_renderer_set_billboards_by_depth(renderer, billboards, set);
    }
#endif
#if defined WALK_DEPTH
    return FXL_E_ORDER;
#else
    return fxl_renderer_set_billboards(renderer, billboards, set);
#endif
}

#endif

uint32_t walk_methods_unsplit(const walk_methods *methods, const fxl_renderer *renderer)
{
    return draws_by_bsp(methods, renderer->scene)
               ? ((const fxl_bsp_workspace *)renderer->order_memory)->unsplit
               : 0;
}

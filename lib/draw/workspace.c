/* SPDX-License-Identifier: MIT */
/* Workspaces beside the renderer's own: for another core that draws bands of the same frame. */
#include "../math/memory.h"
#include "../view/model_view.h"
#include "renderer.h"
#include "scratch.h"

/* A workspace's block of memory: how many bytes each part takes, in the order of the parts. */
typedef struct {
    size_t scratch, face_list, clipper, raster;
} parts;

static parts parts_of(const fxl_renderer *renderer)
{
    const fxl_scene *scene = renderer->scene;
    const fxl_target *target = renderer->target;
    const uint32_t entries = scene->draw_list_needed - fxl_list_instances_most(scene);
    parts of;
    of.scratch = fxl_beam_scratch_size(renderer) + fxl_tree_scratch_size(renderer);
    of.face_list = fxl_aligned(entries * sizeof(fxl_draw_entry));
    of.clipper = fxl_aligned(renderer->clipper->workspace_size);
    of.raster = target->memory_size != NULL
                    ? fxl_aligned(target->memory_size(&renderer->frame.view.lens))
                    : 0;
    return of;
}

static bool is_set_up(const fxl_renderer *renderer)
{
    return renderer->scene != NULL && renderer->clipper != NULL && renderer->target != NULL &&
           renderer->order != NULL;
}

/* The largest power of two of entries, for the vertices of the largest model, in so many bytes. */
uint32_t fxl_cache_entries(const fxl_scene *scene, size_t bytes)
{
    uint32_t largest = 0, entries = 1;
    for (uint32_t i = 0; i < scene->model_count; i++) {
        uint32_t count = scene->models[i].vertex_count;
        largest = count > largest ? count : largest;
    }
    while (entries < largest) {
        entries *= 2;
    }
    while (entries > bytes / sizeof(fxl_cached_vertex)) {
        entries /= 2;
    }
    return entries;
}

size_t fxl_workspace_size(const fxl_renderer *renderer)
{
    if (renderer == NULL || !is_set_up(renderer)) {
        return 0;
    }
    const parts of = parts_of(renderer);
    return of.scratch + of.face_list + of.clipper + of.raster;
}

/* surfaces 6.3 */
FXL_COLD fxl_status fxl_workspace_init(fxl_workspace *workspace, const fxl_renderer *renderer,
                                       void *memory, size_t memory_size)
{
    if (workspace == NULL || renderer == NULL || workspace == &renderer->workspace ||
        (memory == NULL && memory_size > 0)) {
        return FXL_E_ARGUMENT;
    }
    if (((uintptr_t)memory & 7u) != 0) {
        return FXL_E_ALIGNMENT;
    }
    if (!is_set_up(renderer)) {
        return FXL_E_ORDER;
    }
    const parts of = parts_of(renderer);
    const size_t least = of.scratch + of.face_list + of.clipper + of.raster;
    if (memory_size < least) {
        return FXL_E_CAPACITY;
    }
    /* What is over: first vertices that faces share, the remainder for the target. */
    const size_t over = of.raster != 0 ? (memory_size - least) / 4 : memory_size - least;
    const uint32_t entries = fxl_cache_entries(renderer->scene, over);
    uint8_t *at = (uint8_t *)memory + of.scratch;
    memset(workspace, 0, sizeof *workspace);
    workspace->settings_version = renderer->workspace.settings_version;
    workspace->face_list = (fxl_draw_entry *)(void *)at;
    at += of.face_list;
    if (of.clipper != 0) {
        workspace->cache.clipper_workspace = memset(at, 0, of.clipper);
    }
    at += of.clipper;
    fxl_vertex_cache_init(&workspace->cache, (fxl_cached_vertex *)(void *)at, entries);
    at += entries * sizeof(fxl_cached_vertex);
    if (of.raster != 0) {
        const size_t remaining = memory_size - (size_t)(at - (uint8_t *)memory);
        workspace->target_memory = at;
        workspace->target_memory_size = remaining < UINT32_MAX ? (uint32_t)remaining : UINT32_MAX;
    }
    return FXL_OK;
}

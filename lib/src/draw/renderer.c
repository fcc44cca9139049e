/* SPDX-License-Identifier: MIT */
/* A renderer and its settings. */
#include <string.h>

#include "renderer.h"

#ifdef __arm__
FXL_STATIC_ASSERT(sizeof(fxl_renderer) == 472 + 64 * FXL_POLYGON_CAPACITY, "render.h says so");
#endif

fxl_status fxl_renderer_refuse(fxl_renderer *renderer, fxl_status status)
{
    renderer->workspace.counters.refused_calls += 1;
    return status;
}

fxl_status fxl_renderer_init_bare(fxl_renderer *renderer, const fxl_scene *scene,
                                  const fxl_lens *lens, const fxl_memory *memory)
{
    if (renderer == NULL || scene == NULL || lens == NULL || memory == NULL ||
        memory->order == NULL ||
        (memory->display_list == NULL && memory->display_list_capacity > 0) ||
        (memory->cache == NULL && memory->cache_capacity > 0)) {
        return FXL_E_ARGUMENT;
    }
    if (scene->order_needed == 0) {
        return FXL_E_ORDER;
    }
    if (memory->order_capacity < scene->order_needed ||
        scene->order_needed < scene->instance_count) {
        return FXL_E_CAPACITY;
    }
    fxl_frame *frame = &renderer->frame;
    fxl_workspace *workspace = &renderer->workspace;
    memset(renderer, 0, sizeof *renderer);
    renderer->scene = scene;
    /* The entries beyond the instances' are for the faces of one model. */
    renderer->instance_capacity =
        memory->order_capacity - (scene->order_needed - scene->instance_count);
    fxl_view_set_lens(&frame->view, lens);
    frame->order = memory->order;
    frame->display_list.words = memory->display_list;
    frame->display_list.capacity = memory->display_list_capacity;
    workspace->face_order = memory->order + renderer->instance_capacity;
    if (memory->cache_capacity > 0) {
        fxl_vertex_cache_init(&workspace->cache, memory->cache, memory->cache_capacity);
    } else {
        fxl_vertex_cache_init(&workspace->cache, &workspace->own_entry, 1);
    }
    return FXL_OK;
}

/* Whether memory of the caller's may be a workspace of so many bytes. */
static bool is_workspace(const void *workspace, uint32_t wanted)
{
    return wanted == 0 || (workspace != NULL && ((uintptr_t)workspace & 7u) == 0);
}

fxl_status fxl_renderer_set_clipper(fxl_renderer *renderer, const fxl_clipper *clipper,
                                    void *workspace, uint32_t workspace_size)
{
    if (renderer == NULL) {
        return FXL_E_ARGUMENT;
    }
    if (clipper == NULL || !is_workspace(workspace, clipper->workspace_size)) {
        return fxl_renderer_refuse(renderer, FXL_E_ARGUMENT);
    }
    if (workspace_size < clipper->workspace_size) {
        return fxl_renderer_refuse(renderer, FXL_E_CAPACITY);
    }
    if (clipper->workspace_size > 0) {
        memset(workspace, 0, clipper->workspace_size);
    }
    renderer->clipper = clipper;
    renderer->frame.view.clipper_workspace = workspace;
    renderer->frame.ready = false;
    return FXL_OK;
}

fxl_status fxl_renderer_set_visibility(fxl_renderer *renderer, const fxl_visibility *visibility,
                                       void *workspace, uint32_t workspace_size)
{
    if (renderer == NULL) {
        return FXL_E_ARGUMENT;
    }
    if (visibility == NULL) {
        return fxl_renderer_refuse(renderer, FXL_E_ARGUMENT);
    }
    const fxl_raster_backend *backend = visibility->backend;
    uint32_t submit = visibility->submit_workspace_size != NULL
                          ? visibility->submit_workspace_size(renderer->scene)
                          : 0;
    uint32_t raster =
        backend->workspace_size != NULL ? backend->workspace_size(&renderer->frame.view.lens) : 0;
    submit = (submit + 7u) & ~7u;
    if (!is_workspace(workspace, submit + raster)) {
        return fxl_renderer_refuse(renderer, FXL_E_ARGUMENT);
    }
    if (workspace_size < submit || workspace_size - submit < raster) {
        return fxl_renderer_refuse(renderer, FXL_E_CAPACITY);
    }
    if (submit > 0) {
        memset(workspace, 0, submit);
    }
    renderer->visibility = visibility;
    renderer->submit_workspace = workspace;
    renderer->workspace.raster_workspace = raster > 0 ? (uint8_t *)workspace + submit : NULL;
    renderer->workspace.raster_workspace_size = raster > 0 ? workspace_size - submit : 0;
    renderer->frame.ready = false;
    return FXL_OK;
}

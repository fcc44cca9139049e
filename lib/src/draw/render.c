/* SPDX-License-Identifier: MIT */
#include "fixel/render.h"

#include <string.h>

#include "submit.h"

#ifdef __arm__
_Static_assert(sizeof(fxl_renderer) == 472 + 64 * FXL_POLYGON_CAPACITY, "render.h says so");
#endif

static fxl_status refuse(fxl_renderer *renderer, fxl_status status)
{
    renderer->counters.refused_calls += 1;
    return status;
}

fxl_status fxl_renderer_init_with(fxl_renderer *renderer, const fxl_scene *scene,
                                  const fxl_lens *lens, const fxl_memory *memory)
{
    fxl_status status = fxl_renderer_init_bare(renderer, scene, lens, memory);
    if (status == FXL_OK) {
        renderer->clipper = &fxl_clipper_view;
        renderer->visibility = &fxl_visibility_sorted;
    }
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
    renderer->scene = scene;
    fxl_view_set_lens(&renderer->view, lens);
    renderer->clipper = NULL;
    renderer->visibility = NULL;
    renderer->beam_light = NULL;
    renderer->submit_workspace = NULL;
    renderer->raster_workspace = NULL;
    renderer->raster_workspace_size = 0;
    renderer->order = memory->order;
    /* What is needed beyond the objects is for the faces of one model. */
    renderer->instance_capacity =
        memory->order_capacity - (scene->order_needed - scene->instance_count);
    renderer->display_list.words = memory->display_list;
    renderer->display_list.capacity = memory->display_list_capacity;
    renderer->display_list.used = 0;
    if (memory->cache_capacity > 0) {
        fxl_vertex_cache_init(&renderer->cache, memory->cache, memory->cache_capacity);
    } else {
        fxl_vertex_cache_init(&renderer->cache, &renderer->own_entry, 1);
    }
    renderer->ready = false;
    memset(&renderer->counters, 0, sizeof renderer->counters);
    return FXL_OK;
}

/* Room of the caller's, as it is to be. */
static bool is_room(const void *workspace, uint32_t wanted)
{
    return wanted == 0 || (workspace != NULL && ((uintptr_t)workspace & 7u) == 0);
}

fxl_status fxl_renderer_set_clipper(fxl_renderer *renderer, const fxl_clipper *clipper,
                                    void *workspace, uint32_t workspace_size)
{
    if (renderer == NULL) {
        return FXL_E_ARGUMENT;
    }
    if (clipper == NULL || !is_room(workspace, clipper->workspace_size)) {
        return refuse(renderer, FXL_E_ARGUMENT);
    }
    if (workspace_size < clipper->workspace_size) {
        return refuse(renderer, FXL_E_CAPACITY);
    }
    if (clipper->workspace_size > 0) {
        memset(workspace, 0, clipper->workspace_size);
    }
    renderer->clipper = clipper;
    renderer->view.clipper_workspace = workspace;
    renderer->ready = false;
    return FXL_OK;
}

fxl_status fxl_renderer_set_visibility(fxl_renderer *renderer, const fxl_visibility *visibility,
                                       void *workspace, uint32_t workspace_size)
{
    if (renderer == NULL) {
        return FXL_E_ARGUMENT;
    }
    if (visibility == NULL) {
        return refuse(renderer, FXL_E_ARGUMENT);
    }
    const fxl_raster_backend *backend = visibility->backend;
    uint32_t traversal = visibility->submit_workspace_size != NULL
                             ? visibility->submit_workspace_size(renderer->scene)
                             : 0;
    uint32_t paint =
        backend->workspace_size != NULL ? backend->workspace_size(&renderer->view.lens) : 0;
    traversal = (traversal + 7u) & ~7u;
    if (!is_room(workspace, traversal + paint)) {
        return refuse(renderer, FXL_E_ARGUMENT);
    }
    if (workspace_size < traversal || workspace_size - traversal < paint) {
        return refuse(renderer, FXL_E_CAPACITY);
    }
    if (traversal > 0) {
        memset(workspace, 0, traversal);
    }
    renderer->visibility = visibility;
    renderer->submit_workspace = workspace;
    renderer->raster_workspace = paint > 0 ? (uint8_t *)workspace + traversal : NULL;
    renderer->raster_workspace_size = paint > 0 ? workspace_size - traversal : 0;
    renderer->ready = false;
    return FXL_OK;
}

fxl_status fxl_frame_begin(fxl_renderer *renderer, const fxl_pose *pose)
{
    if (renderer == NULL) {
        return FXL_E_ARGUMENT;
    }
    if (renderer->clipper == NULL || renderer->visibility == NULL) {
        return refuse(renderer, FXL_E_ORDER);
    }
    if (renderer->scene->instance_count > renderer->instance_capacity) {
        return refuse(renderer, FXL_E_CAPACITY);
    }
    fxl_status status = fxl_view_set_pose(&renderer->view, pose);
    if (status != FXL_OK) {
        return refuse(renderer, status);
    }
    uint32_t left_out;
    renderer->visible_count =
        (uint16_t)fxl_order_instances(renderer->scene, &renderer->view.camera,
                                      &renderer->view.view_frustum, renderer->order, &left_out);
    uint32_t refused_calls = renderer->counters.refused_calls;
    memset(&renderer->counters, 0, sizeof renderer->counters);
    renderer->counters.refused_calls = refused_calls;
    renderer->counters.in = left_out; /* bug: left-out-count */
    renderer->counters.outside = left_out;
    renderer->display_list.used = 0;
    /* bug: sorted-stale */
    renderer->sorted_instance = UINT16_MAX; /* no object's place: those are below in_sight */
    renderer->resume.instances = 0;
    renderer->resume.faces = 0;
    const fxl_traversal on = {renderer, NULL, &renderer->resume, &renderer->counters,
                              fxl_face_sink_for(renderer, NULL)};
    (void)renderer->visibility->submit(&on);
    renderer->ready = true;
    renderer->counted = false;
    return FXL_OK;
}

bool fxl_draw_band(fxl_renderer *renderer, const fxl_band *part)
{
    const fxl_visibility *visibility = renderer->visibility;
    fxl_resume_point place = renderer->resume; /* bug: rest-face-late */
    fxl_counters uncounted = {0};
    const fxl_traversal on = {renderer, part, &place,
                              renderer->counted ? &uncounted : &renderer->counters,
                              fxl_face_sink_for(renderer, part)};
    if (visibility->backend->begin_band != NULL) {
        visibility->backend->begin_band(renderer, part);
    }
    if (!fxl_draw_display_list(&on) || !visibility->submit(&on)) {
        return false;
    }
    renderer->counted = true; /* bug: counted-again */
    return true;
}

fxl_status fxl_frame_draw(fxl_renderer *renderer, const fxl_band *band)
{
    if (renderer == NULL) {
        return FXL_E_ARGUMENT;
    }
    if (band == NULL || band->pixels == NULL) {
        return refuse(renderer, FXL_E_ARGUMENT);
    }
    if (!renderer->ready) {
        return refuse(renderer, FXL_E_ORDER);
    }
    if (band->width != renderer->view.lens.width || band->stride < band->width || band->rows < 1 ||
        band->first_row + band->rows > renderer->view.lens.height) {
        return refuse(renderer, FXL_E_RANGE);
    }
    const fxl_raster_backend *backend = renderer->visibility->backend;
    if (backend->draw_band != NULL) {
        backend->draw_band(renderer, band);
    } else {
        (void)fxl_draw_band(renderer, band);
    }
    return FXL_OK;
}

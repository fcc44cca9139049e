/* SPDX-License-Identifier: MIT */
/* A renderer and its settings. */
#include "../math/memory.h"
#include "../scene/lens.h"
#include "../view/model_view.h"
#include "../view/view.h"
#include "renderer.h"
#include "submit.h"

#ifdef __arm__
FXL_STATIC_ASSERT(sizeof(fxl_renderer) == 528 + 64 * FXL_POLYGON_CAPACITY, "render.h says so");
#endif

/* SPEC 3.2 */
fxl_status fxl_refuse(fxl_workspace *workspace, fxl_status status)
{
    workspace->counters.refused_calls += 1;
    return status;
}

/* Whether a table may lie there: words at least. */
static bool is_table(const void *table, uint32_t capacity)
{
    return capacity == 0 || table != NULL;
}

/* Whether all tables begin where their records may. */
static bool is_aligned(const fxl_memory *memory)
{
    const uintptr_t words = (uintptr_t)memory->draw_list | (uintptr_t)memory->display_list;
    return (words & (sizeof(uint32_t) - 1)) == 0 && ((uintptr_t)memory->cache & 7u) == 0;
}

FXL_COLD fxl_status fxl_renderer_init_bare(fxl_renderer *renderer, const fxl_scene *scene,
                                           const fxl_lens *lens, const fxl_memory *memory)
{
    if (renderer == NULL || scene == NULL || lens == NULL || memory == NULL ||
        memory->draw_list == NULL ||
        !is_table(memory->display_list, memory->display_list_capacity) ||
        !is_table(memory->cache, memory->cache_capacity)) {
        return FXL_E_ARGUMENT;
    }
    if (!is_aligned(memory)) {
        return FXL_E_ALIGNMENT;
    }
    if (!fxl_lens_is_valid(lens)) {
        return FXL_E_RANGE;
    }
    if (scene->draw_list_needed == 0) {
        return FXL_E_ORDER;
    }
    const uint32_t instances = fxl_list_instances_most(scene);
    if (memory->draw_list_capacity < scene->draw_list_needed ||
        scene->draw_list_needed < instances) {
        return FXL_E_CAPACITY;
    }
    fxl_frame *frame = &renderer->frame;
    fxl_workspace *workspace = &renderer->workspace;
    memset(renderer, 0, sizeof *renderer);
    renderer->scene = scene;
    /* The entries beyond the instances' are for the faces of one model. */
    const uint32_t capacity = memory->draw_list_capacity - (scene->draw_list_needed - instances);
    /* A world attaches the renderer first. */
    renderer->instance_capacity = scene->instance_capacity > 0 ? 0 : capacity;
    workspace->settings_number = 1; /* another workspace has 0 until it is set up */
    fxl_view_set_lens(&frame->view, lens);
    frame->draw_list = memory->draw_list;
    frame->display_list.words = memory->display_list;
    frame->display_list.capacity = memory->display_list_capacity;
    workspace->face_list = memory->draw_list + capacity;
    fxl_vertex_cache_init(&workspace->cache, memory->cache, memory->cache_capacity);
    return FXL_OK;
}

/* Whether a renderer was initialised, and the caller's memory, of so many bytes, may be a workspace
 * of which so many are wanted. */
static fxl_status check_workspace(const fxl_renderer *renderer, const void *workspace,
                                  uint32_t size, uint32_t wanted)
{
    if (renderer->scene == NULL) {
        return FXL_E_ORDER;
    }
    if (size > 0 && workspace == NULL) {
        return FXL_E_ARGUMENT;
    }
    if (size > 0 && ((uintptr_t)workspace & 7u) != 0) {
        return FXL_E_ALIGNMENT;
    }
    return size < wanted ? FXL_E_CAPACITY : FXL_OK;
}

/* What drawing keeps of the settings is of no use any more. */
static void settings_changed(fxl_renderer *renderer)
{
    renderer->frame.state = FXL_FRAME_NONE;
    FXL_COUNT_CHANGE(&renderer->workspace);
}

FXL_COLD fxl_status fxl_renderer_set_clipper(fxl_renderer *renderer, const fxl_clipper *clipper,
                                             void *workspace, uint32_t workspace_size)
{
    if (renderer == NULL) {
        return FXL_E_ARGUMENT;
    }
    if (clipper == NULL || clipper->clip == NULL) {
        return fxl_refuse(&renderer->workspace, FXL_E_ARGUMENT);
    }
    uint32_t wanted = clipper->workspace_size;
    if (wanted == 0 && workspace_size > 0) {
        wanted = sizeof(fxl_clip_stats); /* a clipper that needs nothing counts in what it gets */
    }
    fxl_status status = check_workspace(renderer, workspace, workspace_size, wanted);
    if (status != FXL_OK) {
        return fxl_refuse(&renderer->workspace, status);
    }
    if (clipper->workspace_size > 0) {
        memset(workspace, 0, clipper->workspace_size);
    }
    renderer->clipper = clipper;
    fxl_take_lens(renderer);
    renderer->workspace.cache.clipper_workspace = workspace_size > 0 ? workspace : NULL;
    settings_changed(renderer);
    return FXL_OK;
}

/* Bytes of memory that an order needs. */
static uint32_t order_size(const fxl_order *order, const fxl_scene *scene)
{
    return order->memory_size == NULL ? 0 : order->memory_size(scene);
}

/* The target's shader in place of that of another target. Constant records are in no other place of
 * the list, and nothing is written to them. */
static void set_last_shader(fxl_renderer *renderer)
{
    const fxl_shader **place = &renderer->shader;
    while (*place != NULL && (*place)->rank != FXL_SHADER_TARGET) {
        place = &((fxl_shader *)(uintptr_t)*place)->next;
    }
    *place = renderer->target->extras != NULL ? renderer->target->extras->last : NULL;
}

/* Memory of which so many bytes are needed. */
static fxl_status check_memory(const void *memory, uint32_t size, uint32_t needed)
{
    if (needed == 0) {
        return FXL_OK;
    }
    if (((uintptr_t)memory & 7u) != 0) {
        return FXL_E_ALIGNMENT;
    }
    if (size < needed) {
        return FXL_E_CAPACITY;
    }
    return memory != NULL ? FXL_OK : FXL_E_ARGUMENT;
}

/* SPEC 6.3, 10.4 */
FXL_COLD void fxl_set_direction(fxl_renderer *renderer, bool near_first)
{
    const fxl_scene *scene = renderer->scene;
    const bool had_list = renderer->by_number != FXL_FACES_AT_ONCE;
    const uint32_t faces = scene->draw_list_needed - fxl_list_instances_most(scene);
    if (!FXL_IS_SMALL) {
        fxl_extents_take_back(renderer, &renderer->workspace); /* by where the order ends now */
    }
    renderer->near_first = near_first;
    if (!near_first || renderer->target->depth_bits == 0) {
        renderer->by_number = FXL_FACES_SORTED;
    } else if (FXL_IS_COMPACT || scene->cluster_code != NULL) {
        renderer->by_number = FXL_FACES_LISTED;
    } else {
        renderer->by_number = FXL_FACES_AT_ONCE;
    }
    const bool has_list = renderer->by_number != FXL_FACES_AT_ONCE;
    const uint32_t more = (had_list ? faces : 0u) - (has_list ? faces : 0u);
    renderer->workspace.face_list += (int32_t)more;
    if (renderer->instance_capacity != 0) { /* of a world it is 0 until it attaches the renderer */
        renderer->instance_capacity += more;
    }
}

FXL_COLD fxl_status fxl_choose_with_memory(fxl_renderer *renderer, const fxl_config *config)
{
    const fxl_target *target = config->target;
    const fxl_order *order = fxl_order_of(config);
    const uint32_t tree = order_size(order, renderer->scene);
    const uint32_t depth =
        target->memory_size != NULL ? target->memory_size(&renderer->frame.view.lens) : 0;
    fxl_status status = fxl_check_palette(config);
    if (status == FXL_OK) {
        status = check_memory(config->tree, config->tree_size, tree);
    }
    if (status == FXL_OK) {
        status = check_memory(config->depth, config->depth_size, depth);
    }
    if (status != FXL_OK) {
        return status;
    }
    if (tree > 0) {
        memset(config->tree, 0, tree);
    }
    renderer->order = order;
    renderer->target = target;
    renderer->fill = target->fill;
    fxl_set_direction(renderer, target->near_first);
    renderer->check = NULL;
    fxl_take_lens(renderer);
    renderer->palette = target->has_palette ? config->palette : NULL;
    if (target->extras != NULL) {
        renderer->draw_display_list =
            target->extras->draw_display_list; /* it draws flat records, too */
    }
    set_last_shader(renderer);
    renderer->order_memory = config->tree;
    renderer->workspace.target_memory = depth > 0 ? config->depth : NULL;
    renderer->workspace.target_memory_size = depth > 0 ? config->depth_size : 0;
    settings_changed(renderer);
    return FXL_OK;
}

fxl_status fxl_frame_release_scene(fxl_renderer *renderer)
{
    if (renderer == NULL) {
        return FXL_E_ARGUMENT;
    }
    fxl_frame *frame = &renderer->frame;
    if (frame->state == FXL_FRAME_NONE) {
        return fxl_refuse(&renderer->workspace, FXL_E_ORDER);
    }
    if (frame->resume.instances < frame->visible_count) {
        return fxl_refuse(&renderer->workspace, FXL_E_CAPACITY);
    }
    if (renderer->target->depth_bits != 0 &&
        fxl_overdraw_from(renderer->shader) != NULL) { /* which the list has not */
        return fxl_refuse(&renderer->workspace, FXL_E_CAPACITY);
    }
    frame->state = FXL_FRAME_RELEASED;
    return FXL_OK;
}

fxl_status fxl_frame_end(fxl_renderer *renderer)
{
    if (renderer == NULL) {
        return FXL_E_ARGUMENT;
    }
    renderer->frame.state = FXL_FRAME_NONE;
    return FXL_OK;
}

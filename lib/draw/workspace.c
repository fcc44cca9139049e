/* SPDX-License-Identifier: MIT */
/* Workspaces beside the renderer's own: for another core that draws bands of the same frame. */
#include "../math/memory.h"
#include "../view/model_view.h"
#include "renderer.h"
#include "scratch.h"
#include "submit.h"
#include "surface_polygon.h"

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

/* --- what a workspace was set up for ------------------------------------------------------ */

FXL_STATIC_ASSERT(FXL_SHADERS_MAX == FXL_SHADER_TARGET + 1, "one of each rank");

/* Writes all that is known without the scene's tables, which may be changing while a frame that was
 * released is drawn. */
static void note_settings(fxl_workspace_setup *setup, const fxl_renderer *renderer)
{
    setup->scene = renderer->scene;
    setup->clipper = renderer->clipper;
    setup->order = renderer->order;
    setup->target = fxl_painted_target(renderer); /* outlines lay a copy of any over it */
    setup->billboards = renderer->billboards;
    for (uint32_t rank = 0; rank < FXL_SHADERS_MAX; rank++) {
        setup->shaders[rank] = fxl_renderer_shader(renderer, rank);
    }
    setup->lens = renderer->frame.view.lens;
    setup->beam_size = fxl_beam_scratch_size(renderer);
    setup->clipper_size = renderer->clipper->workspace_size;
    setup->frame = renderer->frame.view.frame;
    setup->camera = renderer->frame.view.camera;
}

/* Of a lens, without off_centre and the padding before it. */
#define LENS_BYTES (offsetof(fxl_lens, centre_y) + sizeof(fxl_q16_16))

static bool are_equal(const void *a, const void *b, size_t size)
{
    const uint8_t *left = (const uint8_t *)a, *right = (const uint8_t *)b;
    size_t i = 0;
    while (i < size && left[i] == right[i]) {
        i++;
    }
    return i == size;
}

/* Whether a scene, which may be another one at the same address, needs no more than it did. */
static bool has_room(const fxl_workspace_room *room, const fxl_renderer *renderer)
{
    const fxl_scene *scene = renderer->scene;
    if (room->models != scene->models || room->tree_size != fxl_tree_scratch_size(renderer)) {
        return false;
    }
    for (uint32_t i = 0; i < scene->model_count; i++) {
        const fxl_model *model = &scene->models[i];
        if (model->kind == FXL_MODEL_SORTED && model->face_count > room->face_room) {
            return false;
        }
    }
    return true;
}

/* Whether a workspace that is not the renderer's own was set up for its settings. Two frames of
 * one number are one frame, unless the renderer was initialised between them. */
static bool is_current(const fxl_workspace *workspace, const fxl_renderer *renderer)
{
    const fxl_workspace_setup *setup = &workspace->work.setup;
    const fxl_view *view = &renderer->frame.view;
    const uint32_t number = renderer->workspace.settings_number;
    if (!is_set_up(renderer) || workspace->settings_number != number || number == UINT32_MAX) {
        return false;
    }
    for (uint32_t rank = 0; rank < FXL_SHADERS_MAX; rank++) {
        if (setup->shaders[rank] != fxl_renderer_shader(renderer, rank)) {
            return false;
        }
    }
    return setup->scene == renderer->scene && setup->clipper == renderer->clipper &&
           setup->order == renderer->order && setup->target == fxl_painted_target(renderer) &&
           setup->billboards == renderer->billboards &&
           setup->clipper_size == renderer->clipper->workspace_size &&
           setup->beam_size == fxl_beam_scratch_size(renderer) &&
           setup->lens.off_centre == view->lens.off_centre &&
           are_equal(&setup->lens, &view->lens, LENS_BYTES) &&
           (setup->frame != view->frame ||
            are_equal(&setup->camera, &view->camera, sizeof view->camera)) &&
           (renderer->frame.state == FXL_FRAME_RELEASED || has_room(&setup->room, renderer));
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
    workspace->settings_number = renderer->workspace.settings_number;
    note_settings(&workspace->work.setup, renderer);
    const fxl_workspace_room room = {renderer->scene->models, fxl_tree_scratch_size(renderer),
                                     (uint32_t)(of.face_list / sizeof(fxl_draw_entry))};
    workspace->work.setup.room = room;
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

/* rgb565 3.6 */
fxl_status fxl_frame_draw_with(const fxl_renderer *renderer, fxl_workspace *workspace,
                               const fxl_band *band)
{
    if (workspace == NULL) {
        return FXL_E_ARGUMENT;
    }
    if (renderer == NULL) {
        return fxl_refuse(workspace, FXL_E_ARGUMENT);
    }
    if (workspace == &renderer->workspace) {
        return fxl_draw_in_workspace(renderer, workspace, band);
    }
    if (!is_current(workspace, renderer)) {
        return fxl_refuse(workspace, band == NULL || band->pixels == NULL ? FXL_E_ARGUMENT
                                                                          : FXL_E_ORDER);
    }
    const fxl_workspace_room room = workspace->work.setup.room;
    fxl_workspace_begin(workspace, true);
    const fxl_status status = fxl_draw_in_workspace(renderer, workspace, band);
    note_settings(&workspace->work.setup, renderer);
    workspace->work.setup.room = room;
    return status;
}

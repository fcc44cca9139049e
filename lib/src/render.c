/* SPDX-License-Identifier: MIT */
#include "fixel/render.h"

#include <string.h>

#include "walk.h"

#ifdef __arm__
_Static_assert(sizeof(fxl_renderer) == 472 + 64 * FXL_POLYGON_CAPACITY, "render.h says so");
#endif

static fxl_status refuse(fxl_renderer *renderer, fxl_status status)
{
    renderer->counters.refused_calls += 1;
    return status;
}

fxl_status fxl_renderer_init(fxl_renderer *renderer, const fxl_scene *scene, const fxl_lens *lens,
                             const fxl_memory *memory)
{
    fxl_status status = fxl_renderer_init_bare(renderer, scene, lens, memory);
    if (status == FXL_OK) {
        renderer->clipper = &fxl_clipper_view;
        renderer->hidden = &fxl_hidden_sorted;
    }
    return status;
}

fxl_status fxl_renderer_init_bare(fxl_renderer *renderer, const fxl_scene *scene,
                                  const fxl_lens *lens, const fxl_memory *memory)
{
    if (renderer == NULL || scene == NULL || lens == NULL || memory == NULL ||
        memory->order == NULL || (memory->list == NULL && memory->list_capacity > 0) ||
        (memory->cache == NULL && memory->cache_capacity > 0)) {
        return FXL_E_ARGUMENT;
    }
    if (scene->order_needed == 0) {
        return FXL_E_ORDER;
    }
    if (memory->order_capacity < scene->order_needed || scene->order_needed < scene->object_count) {
        return FXL_E_CAPACITY;
    }
    renderer->scene = scene;
    fxl_view_set_lens(&renderer->view, lens);
    renderer->clipper = NULL;
    renderer->hidden = NULL;
    renderer->light = NULL;
    renderer->walk_room = NULL;
    renderer->paint_room = NULL;
    renderer->paint_room_size = 0;
    renderer->order = memory->order;
    /* What is needed beyond the objects is for the faces of one model. */
    renderer->object_capacity =
        memory->order_capacity - (scene->order_needed - scene->object_count);
    renderer->list.words = memory->list;
    renderer->list.capacity = memory->list_capacity;
    renderer->list.used = 0;
    if (memory->cache_capacity > 0) {
        fxl_vertex_cache_init(&renderer->cache, memory->cache, memory->cache_capacity);
    } else {
        fxl_vertex_cache_init(&renderer->cache, &renderer->spare, 1);
    }
    renderer->ready = false;
    memset(&renderer->counters, 0, sizeof renderer->counters);
    return FXL_OK;
}

/* Room of the caller's, as it is to be. */
static bool is_room(const void *room, uint32_t wanted)
{
    return wanted == 0 || (room != NULL && ((uintptr_t)room & 7u) == 0);
}

fxl_status fxl_renderer_set_clipper(fxl_renderer *renderer, const fxl_clipper *clipper, void *room,
                                    uint32_t room_size)
{
    if (renderer == NULL) {
        return FXL_E_ARGUMENT;
    }
    if (clipper == NULL || !is_room(room, clipper->room)) {
        return refuse(renderer, FXL_E_ARGUMENT);
    }
    if (room_size < clipper->room) {
        return refuse(renderer, FXL_E_CAPACITY);
    }
    if (clipper->room > 0) {
        memset(room, 0, clipper->room);
    }
    renderer->clipper = clipper;
    renderer->view.room = room;
    renderer->ready = false;
    return FXL_OK;
}

fxl_status fxl_renderer_set_hidden(fxl_renderer *renderer, const fxl_hidden *hidden, void *room,
                                   uint32_t room_size)
{
    if (renderer == NULL) {
        return FXL_E_ARGUMENT;
    }
    if (hidden == NULL) {
        return refuse(renderer, FXL_E_ARGUMENT);
    }
    const fxl_painter *painter = hidden->painter;
    uint32_t walk = hidden->walk_room != NULL ? hidden->walk_room(renderer->scene) : 0;
    uint32_t paint = painter->room != NULL ? painter->room(&renderer->view.lens) : 0;
    walk = (walk + 7u) & ~7u;
    if (!is_room(room, walk + paint)) {
        return refuse(renderer, FXL_E_ARGUMENT);
    }
    if (room_size < walk || room_size - walk < paint) {
        return refuse(renderer, FXL_E_CAPACITY);
    }
    if (walk > 0) {
        memset(room, 0, walk);
    }
    renderer->hidden = hidden;
    renderer->walk_room = room;
    renderer->paint_room = paint > 0 ? (uint8_t *)room + walk : NULL;
    renderer->paint_room_size = paint > 0 ? room_size - walk : 0;
    renderer->ready = false;
    return FXL_OK;
}

fxl_status fxl_frame_begin(fxl_renderer *renderer, const fxl_pose *pose)
{
    if (renderer == NULL) {
        return FXL_E_ARGUMENT;
    }
    if (renderer->clipper == NULL || renderer->hidden == NULL) {
        return refuse(renderer, FXL_E_ORDER);
    }
    if (renderer->scene->object_count > renderer->object_capacity) {
        return refuse(renderer, FXL_E_CAPACITY);
    }
    fxl_status status = fxl_view_set_pose(&renderer->view, pose);
    if (status != FXL_OK) {
        return refuse(renderer, status);
    }
    uint32_t left_out;
    renderer->in_sight =
        (uint16_t)fxl_order_objects(renderer->scene, &renderer->view.camera,
                                    &renderer->view.view_frustum, renderer->order, &left_out);
    uint32_t refused_calls = renderer->counters.refused_calls;
    memset(&renderer->counters, 0, sizeof renderer->counters);
    renderer->counters.refused_calls = refused_calls;
    renderer->counters.in = left_out; /* bug: left-out-count */
    renderer->counters.outside = left_out;
    renderer->list.used = 0;
    /* bug: sorted-stale */
    renderer->sorted = UINT16_MAX; /* no object's place: those are below in_sight */
    renderer->rest.objects = 0;
    renderer->rest.faces = 0;
    const fxl_walk on = {renderer, NULL, &renderer->rest, &renderer->counters,
                         fxl_walk_taker(renderer, NULL)};
    (void)renderer->hidden->walk(&on);
    renderer->ready = true;
    renderer->counted = false;
    return FXL_OK;
}

bool fxl_draw_part(fxl_renderer *renderer, const fxl_band *part)
{
    const fxl_hidden *hidden = renderer->hidden;
    fxl_place place = renderer->rest; /* bug: rest-face-late */
    fxl_counters uncounted = {0};
    const fxl_walk on = {renderer, part, &place,
                         renderer->counted ? &uncounted : &renderer->counters,
                         fxl_walk_taker(renderer, part)};
    if (hidden->painter->begin != NULL) {
        hidden->painter->begin(renderer, part);
    }
    if (!fxl_walk_list(&on) || !hidden->walk(&on)) {
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
    const fxl_painter *painter = renderer->hidden->painter;
    if (painter->draw != NULL) {
        painter->draw(renderer, band);
    } else {
        (void)fxl_draw_part(renderer, band);
    }
    return FXL_OK;
}

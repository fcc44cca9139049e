/* SPDX-License-Identifier: MIT */
#include "fixel/render.h"

#include <string.h>

#include "face.h"
#include "fixel/fill.h"

#ifdef __arm__
_Static_assert(sizeof(fxl_renderer) == 440 + 80 * FXL_POLYGON_CAPACITY, "render.h says so");
#endif

/* A walk over the scene: with a band it paints, without one it fills the list. */
typedef struct {
    fxl_renderer *renderer;
    const fxl_band *band; /* null: the list */
    fxl_place *place;     /* kept where the list is full */
    fxl_counters *counters;
} walk;

static fxl_rows rows_of(const fxl_band *band)
{
    fxl_rows rows = {band->first_row, (uint16_t)(band->first_row + band->rows)};
    return rows;
}

/* scan -> fill, for a scan that was begun. */
static void paint(fxl_scan *scan, uint8_t colour, const fxl_band *band)
{
    const fxl_trapezoid *trapezoid;
    while ((trapezoid = fxl_scan_next_trapezoid(scan)) != NULL) {
        fxl_fill_trapezoid(band, trapezoid, colour);
    }
}

/* Where the polygon on the screen goes; false where the list has no room. One
 * that reaches no row goes nowhere. */
static bool deliver(const walk *on)
{
    const fxl_screen_polygon *screen = &on->renderer->screen;
    uint16_t height = on->renderer->view.lens.height;
    if (on->band == NULL) {
        fxl_rows rows = fxl_scan_rows(screen, height);
        return rows.first == rows.end || fxl_list_append(&on->renderer->list, screen, rows);
    }
    fxl_scan *scan = &on->renderer->work.scan;
    fxl_scan_outline(screen->points, screen->count, on->band, scan);
    if (fxl_scan_is_on_screen(scan, height)) {
        on->counters->spilled += 1;
        paint(scan, screen->colour, on->band);
    }
    return true;
}

/* transform, clip and project -> list or band, for a face that faces the eye. False where the list
 * has no room: the face is then not counted. */
static bool take_face(const walk *on, const fxl_placed *placed, const fxl_face *face)
{
    fxl_renderer *renderer = on->renderer;
    fxl_counters *counters = on->counters;
    fxl_clip_result cut = renderer->clipper(placed, face, &renderer->work.clip, &renderer->screen);
    switch (cut) {
    case FXL_CLIP_OUTSIDE:
        counters->outside += 1;
        return true;
    case FXL_CLIP_DEGENERATE:
        counters->degenerate += 1;
        return true;
    case FXL_CLIP_CAPACITY:
    case FXL_CLIP_RANGE:
        counters->refused += 1;
        return true;
    case FXL_CLIP_INSIDE:
    case FXL_CLIP_CUT:
        break;
    }
    if (!deliver(on)) {
        return false;
    }
    counters->drawn += 1;
    counters->clipped += cut == FXL_CLIP_CUT;
    return true;
}

/* A convex object: its faces hide none of each other, so any order will do. */
static bool walk_convex(const walk *on, const fxl_placed *placed, const fxl_model *model)
{
    const fxl_face *faces = &on->renderer->scene->faces[model->first_face];
    const uint32_t first = on->place->faces;
    uint32_t number, backfacing = 0;
    for (number = first; number < model->face_count; number++) {
        if (!fxl_placed_face_is_front(placed, &faces[number])) {
            backfacing++;
        } else if (!take_face(on, placed, &faces[number])) {
            break;
        }
    }
    on->place->faces = (uint16_t)number;
    on->counters->in += number - first;
    on->counters->backfacing += backfacing;
    return number == model->face_count;
}

/* The faces that face the eye, in their order; then the others are counted. */
static bool walk_sorted(const walk *on, const fxl_placed *placed, const fxl_object *object,
                        const fxl_model *model)
{
    const fxl_scene *scene = on->renderer->scene;
    fxl_renderer *renderer = on->renderer;
    fxl_order_entry *order = renderer->order + scene->object_count;
    if (renderer->sorted != on->place->objects) {
        renderer->sorted = on->place->objects;
        renderer->front =
            (uint16_t)fxl_order_faces(scene, object, &renderer->view.camera.position, order);
    }
    const fxl_face *faces = &scene->faces[model->first_face];
    const uint32_t first = on->place->faces, front = renderer->front;
    uint32_t number = first;
    while (number < front && take_face(on, placed, &faces[order[number].face])) {
        number++;
    }
    on->place->faces = (uint16_t)number;
    on->counters->in += number - first;
    if (number < front) {
        return false;
    }
    on->counters->in += model->face_count - front;
    on->counters->backfacing += model->face_count - front;
    return true;
}

/* From the walk's place to the end of the scene, or to where the list is full. */
static void walk_scene(const walk *on)
{
    const fxl_scene *scene = on->renderer->scene;
    for (; on->place->objects < on->renderer->in_sight; on->place->objects++) {
        const fxl_order_entry *entry = &on->renderer->order[on->place->objects];
        const fxl_object *object = &scene->objects[entry->index];
        const fxl_model *model = &scene->models[object->model];
        fxl_placed placed;
        fxl_place_object(&placed, scene, object, entry->planes, &on->renderer->view,
                         &on->renderer->cache);
        bool done = model->kind == FXL_MODEL_SORTED ? walk_sorted(on, &placed, object, model)
                                                    : walk_convex(on, &placed, model);
        if (!done) {
            return;
        }
        on->place->faces = 0;
    }
}

/* What the list holds of the band. */
static void play_list(fxl_renderer *renderer, const fxl_band *band)
{
    fxl_rows wanted = rows_of(band);
    fxl_list_record record;
    uint32_t place = 0;
    while (fxl_list_next(&renderer->list, wanted, &place, &record)) {
        fxl_scan_outline(record.points, record.count, band, &renderer->work.scan);
        paint(&renderer->work.scan, record.colour, band);
    }
}

static fxl_status refuse(fxl_renderer *renderer, fxl_status status)
{
    renderer->counters.refused_calls += 1;
    return status;
}

fxl_status fxl_renderer_init(fxl_renderer *renderer, const fxl_scene *scene, const fxl_lens *lens,
                             const fxl_memory *memory)
{
    if (renderer == NULL || scene == NULL || lens == NULL || memory == NULL ||
        memory->order == NULL || (memory->list == NULL && memory->list_capacity > 0) ||
        (memory->cache == NULL && memory->cache_capacity > 0)) {
        return FXL_E_ARGUMENT;
    }
    if (memory->order_capacity < scene->order_needed) {
        return FXL_E_CAPACITY;
    }
    renderer->scene = scene;
    fxl_view_set_lens(&renderer->view, lens);
    renderer->clipper = fxl_clip_by_view;
    renderer->order = memory->order;
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

fxl_status fxl_frame_begin(fxl_renderer *renderer, const fxl_pose *pose)
{
    if (renderer == NULL) {
        return FXL_E_ARGUMENT;
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
    renderer->counters.in = left_out;
    renderer->counters.outside = left_out;
    renderer->list.used = 0;
    renderer->sorted = UINT16_MAX; /* no object's place: those are below in_sight */
    renderer->rest.objects = 0;
    renderer->rest.faces = 0;
    const walk on = {renderer, NULL, &renderer->rest, &renderer->counters};
    walk_scene(&on);
    renderer->ready = true;
    renderer->counted = false;
    return FXL_OK;
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
    play_list(renderer, band);
    fxl_place place = renderer->rest;
    fxl_counters uncounted = {0};
    const walk on = {renderer, band, &place, renderer->counted ? &uncounted : &renderer->counters};
    walk_scene(&on);
    renderer->counted = true;
    return FXL_OK;
}

/* SPDX-License-Identifier: MIT */
#include "fixel/placed.h"

#include "outside.h"
#include "rotate.h"

/* What a tag counts objects by: below it is the vertex's number. */
#define TAG_OBJECT ((uint32_t)1 << 16)

_Static_assert(FXL_MODEL_VERTICES_MAX < TAG_OBJECT, "a number fits a tag");

static void forget_all(fxl_vertex_cache *cache)
{
    for (uint32_t i = 0; i <= cache->mask; i++) {
        cache->entries[i].tag = 0;
    }
    cache->count = 0;
}

void fxl_vertex_cache_init(fxl_vertex_cache *cache, fxl_seen_vertex *entries, uint32_t entry_count)
{
    FXL_ASSERT(entries != NULL && entry_count >= 1);
    /* A model has no more vertices than that. */
    uint32_t size = TAG_OBJECT;
    while (size > entry_count) {
        size >>= 1;
    }
    cache->entries = entries;
    cache->mask = size - 1;
    forget_all(cache);
}

void fxl_place_object(fxl_placed *placed, const fxl_scene *scene, const fxl_object *object,
                      fxl_planes planes, fxl_view *view, fxl_vertex_cache *cache)
{
    const fxl_point *eye = &view->camera.position;
    cache->count += TAG_OBJECT;
    if (cache->count == 0) {
        forget_all(cache);
        cache->count = TAG_OBJECT;
    }
    placed->view = view;
    placed->entries = cache->entries;
    placed->mask = cache->mask;
    placed->vertices = scene->vertices + scene->models[object->model].first_vertex;
    placed->corners = scene->corners;
    /* Both within FXL_COORDINATE_MAX. */
    placed->offset.x = object->centre.x - eye->x;
    placed->offset.y = object->centre.y - eye->y;
    placed->offset.z = object->centre.z - eye->z;
    placed->tag = cache->count;
    placed->planes = planes;
}

void fxl_look_at(const fxl_placed *placed, uint32_t number, fxl_seen_vertex *entry)
{
    const fxl_view *view = placed->view;
    fxl_point from_eye = fxl_placed_vertex(placed, number);
    fxl_view_point seen;
    fxl_rotate(&view->camera, &from_eye, &seen);
    entry->position = seen;
    entry->tag = placed->tag + number;
    unsigned outside = 0;
    if (placed->planes != 0) {
        outside = fxl_outside(&view->view_frustum, placed->planes, &entry->position);
    }
    entry->state = (uint8_t)(outside | FXL_SEEN_UNPROJECTED);
}

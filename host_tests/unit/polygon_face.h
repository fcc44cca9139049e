/* SPDX-License-Identifier: MIT */
/* A polygon of the world as a face of an object placed before the eye, so that
 * clippers can be asked about any polygon. */
#ifndef POLYGON_FACE_H
#define POLYGON_FACE_H

#include "view/model_view.h"

typedef struct {
    fxl_model_view model_view;
    fxl_face face;
    fxl_vertex_cache cache;
    fxl_cached_vertex seen[FXL_POLYGON_CAPACITY];
    fxl_point vertices[FXL_POLYGON_CAPACITY];
    uint16_t corners[FXL_POLYGON_CAPACITY];
} polygon_face;

/* All points to within *as, which must stay where it is. entries: of the cache. */
static inline void polygon_face_set(polygon_face *as, const fxl_polygon *polygon, fxl_view *view,
                                    uint32_t entries)
{
    const fxl_model model = {.vertex_count = polygon->count, .face_count = 1};
    const fxl_instance instance = {{0, 0, 0}, 0, 0, 0};
    const fxl_scene scene = {.vertices = as->vertices, .indices = as->corners, .models = &model};
    as->face = (fxl_face){.count = polygon->count, .material = polygon->colour};
    for (uint16_t i = 0; i < polygon->count; i++) {
        as->vertices[i] = polygon->vertices[i].position;
        as->corners[i] = i;
    }
    fxl_face_take_indices(&as->face, as->corners, 0);
    fxl_vertex_cache_init(&as->cache, as->seen, entries);
    fxl_model_view_of_instance(&as->model_view, &scene, &instance, view, &as->cache);
}

#endif

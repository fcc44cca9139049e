/* SPDX-License-Identifier: MIT */
#include "fixel/stage/model_view.h"

#include "../math/arith.h"

/* The unit of the cache's count in a tag. The lower bits of a tag are the vertex's number. */
#define TAG_INSTANCE ((uint32_t)1 << 16)

_Static_assert(FXL_MODEL_VERTICES_MAX < TAG_INSTANCE, "a vertex number fits a tag");

/* The kernels in assembly have the offsets of these members. */
#ifdef __arm__
_Static_assert(offsetof(fxl_model_view, tag) == 12 && offsetof(fxl_model_view, vertices) == 16 &&
                   offsetof(fxl_model_view, offset) == 24 && offsetof(fxl_model_view, planes) == 36,
               "lib/kernels: model view");
_Static_assert(offsetof(fxl_view, camera.right) == 12 && offsetof(fxl_view, view_frustum) == 96 &&
                   offsetof(fxl_view_frustum, y_side) == 8 &&
                   offsetof(fxl_view_frustum, near_z) == 16 &&
                   offsetof(fxl_view_frustum, far_z) == 24 &&
                   offsetof(fxl_view_frustum, inset) == 32,
               "lib/kernels: view");
_Static_assert(offsetof(fxl_cached_vertex, clip_flags) == 4 &&
                   offsetof(fxl_cached_vertex, position) == 16 && FXL_VERTEX_UNPROJECTED == 0x80u,
               "lib/kernels: cached vertex");
#endif

static void forget_all(fxl_vertex_cache *cache)
{
    for (uint32_t i = 0; i <= cache->mask; i++) {
        cache->entries[i].tag = 0;
    }
    cache->count = 0;
}

void fxl_vertex_cache_init(fxl_vertex_cache *cache, fxl_cached_vertex *entries,
                           uint32_t entry_count)
{
    FXL_ASSERT(entries != NULL && entry_count >= 1);
    /* A model has fewer vertices. */
    uint32_t size = TAG_INSTANCE;
    while (size > entry_count) {
        size >>= 1;
    }
    cache->entries = entries;
    cache->mask = size - 1;
    forget_all(cache);
}

/* Makes all entries stale. Returns the tag of vertex 0 of the next instance. */
static uint32_t next_tag(fxl_vertex_cache *cache)
{
    cache->count += TAG_INSTANCE;
    if (cache->count == 0) {
        forget_all(cache); /* bug: cache-wrap */
        cache->count = TAG_INSTANCE;
    }
    return cache->count;
}

void fxl_model_view_of_instance(fxl_model_view *model_view, const fxl_scene *scene,
                                const fxl_instance *instance, fxl_planes planes,
                                const fxl_view *view, fxl_vertex_cache *cache)
{
    const fxl_point *eye = &view->camera.position;
    model_view->tag = next_tag(cache);
    model_view->view = view;
    model_view->entries = cache->entries;
    model_view->mask = cache->mask;
    model_view->vertices = scene->vertices + scene->models[instance->model].first_vertex;
    model_view->indices = scene->indices;
    /* Both within FXL_COORDINATE_MAX. */
    model_view->offset.x = instance->centre.x - eye->x;
    model_view->offset.y = instance->centre.y - eye->y;
    model_view->offset.z = instance->centre.z - eye->z;
    model_view->planes = planes;
    model_view->beam_light = NULL;
}

void fxl_model_view_of_polygon(fxl_model_view *model_view, const fxl_point *points,
                               fxl_planes planes, const fxl_view *view, fxl_vertex_cache *cache)
{
    static const uint16_t indices[] = {0,  1,  2,  3,  4,  5,  6,  7,  8,  9,  10,
                                       11, 12, 13, 14, 15, 16, 17, 18, 19, 20, 21,
                                       22, 23, 24, 25, 26, 27, 28, 29, 30, 31};
    _Static_assert(sizeof indices / sizeof indices[0] >= FXL_POLYGON_CAPACITY, "all indices");
    const fxl_point *eye = &view->camera.position;
    model_view->tag = next_tag(cache);
    model_view->view = view;
    model_view->entries = cache->entries;
    model_view->mask = cache->mask;
    model_view->vertices = points;
    model_view->indices = indices;
    model_view->offset.x = -eye->x;
    model_view->offset.y = -eye->y;
    model_view->offset.z = -eye->z;
    model_view->planes = planes;
    model_view->beam_light = NULL;
}

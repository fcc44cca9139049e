/* SPDX-License-Identifier: MIT */


/* What each new model view adds to the tags. The lower bits of a tag are the vertex's number. */
#include "model_view.h"
#include "outcode.h"

#define TAG_INSTANCE ((uint32_t)1 << 16)

FXL_STATIC_ASSERT(FXL_MODEL_VERTICES_MAX < TAG_INSTANCE, "a vertex number fits a tag");

static fxl_cached_vertex *entries_of(fxl_vertex_cache *cache)
{
    return cache->entries != NULL ? cache->entries : &cache->own;
}

static void forget_all(fxl_vertex_cache *cache)
{
    fxl_cached_vertex *entries = entries_of(cache);
    for (uint32_t i = 0; i <= cache->mask; i++) {
        entries[i].tag = 0;
    }
    cache->count = 0;
}

void fxl_vertex_cache_init(fxl_vertex_cache *cache, fxl_cached_vertex *entries,
                           uint32_t entry_count)
{
    FXL_ASSERT(entries != NULL || entry_count == 0);
    /* A model has fewer vertices. */
    uint32_t size = TAG_INSTANCE;
    while (size > entry_count) {
        size >>= 1;
    }
    if (size == 0) {
        entries = NULL;
        size = 1;
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
        forget_all(cache);
        cache->count = TAG_INSTANCE;
    }
    return cache->count;
}

/* What instances and polygons share. The offset must be set before. */
static inline void set_up(fxl_model_view *model_view, const fxl_view *view, fxl_vertex_cache *cache)
{
    fxl_view_point *translation = &model_view->translation;
    model_view->view = view;
    model_view->entries = entries_of(cache);
    model_view->mask = cache->mask;
    model_view->tag = next_tag(cache);
    model_view->planes = FXL_PLANES_ALL;
    model_view->axes = &view->camera.axes;
    translation->x = translation->y = translation->z = 0;
    fxl_rotate(model_view->axes, &model_view->offset, translation, translation);
    model_view->shader = NULL;
    model_view->clipper_workspace = cache->clipper_workspace;
}

void fxl_model_view_of_instance(fxl_model_view *model_view, const fxl_scene *scene,
                                const fxl_instance *instance, const fxl_view *view,
                                fxl_vertex_cache *cache)
{
    model_view->vertices = scene->vertices + scene->models[instance->model].first_vertex;
    model_view->indices = scene->indices;
    fxl_subtract(&instance->centre, &view->camera.position, &model_view->offset);
    set_up(model_view, view, cache);
}

void fxl_model_view_of_polygon(fxl_model_view *model_view, const fxl_point *points,
                               const fxl_view *view, fxl_vertex_cache *cache)
{
    static const uint16_t indices[] = {0,  1,  2,  3,  4,  5,  6,  7,  8,  9,  10,
                                       11, 12, 13, 14, 15, 16, 17, 18, 19, 20, 21,
                                       22, 23, 24, 25, 26, 27, 28, 29, 30, 31};
    FXL_STATIC_ASSERT(sizeof indices / sizeof indices[0] >= FXL_POLYGON_CAPACITY, "all indices");
    const fxl_point *eye = &view->camera.position;
    model_view->vertices = points;
    model_view->indices = indices;
    model_view->offset.x = -eye->x;
    model_view->offset.y = -eye->y;
    model_view->offset.z = -eye->z;
    set_up(model_view, view, cache);
}

bool fxl_face_is_outside(const fxl_model_view *model_view, const fxl_face *face)
{
    const uint16_t *index = fxl_face_indices(model_view->indices, face);
    uint32_t of_all = FXL_PLANES_ALL;
    for (const uint16_t *end = index + face->count; index < end && of_all != 0; index++) {
        of_all &= fxl_fetch_vertex(model_view, *index)->clip_flags;
    }
    return of_all != 0;
}

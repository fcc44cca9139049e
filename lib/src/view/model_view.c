/* SPDX-License-Identifier: MIT */
#include "fixel/stage/model_view.h"

#include "rotate.h"

/* The unit of the cache's count in a tag. The lower bits of a tag are the vertex's number. */
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
    while (size > entry_count && size > 1) {
        size >>= 1;
    }
    cache->entries = entry_count > 0 ? entries : NULL;
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

/* What instances and polygons have in common: offset is where the vertices' origin lies from the
 * eye, each coordinate below 2^30. */
static void set_up(fxl_model_view *model_view, const fxl_point *offset, fxl_planes planes,
                   const fxl_view *view, fxl_vertex_cache *cache)
{
    const fxl_camera *camera = &view->camera;
    model_view->view = view;
    model_view->entries = entries_of(cache);
    model_view->mask = cache->mask;
    model_view->tag = next_tag(cache);
    model_view->planes = planes;
    model_view->rows[0] = camera->right;
    model_view->rows[1] = camera->up;
    model_view->rows[2] = camera->forward;
    fxl_rotate(camera, offset, &model_view->translation);
    model_view->offset = *offset;
    model_view->beam_light = NULL;
    model_view->clipper_workspace = NULL;
}

void fxl_model_view_of_instance(fxl_model_view *model_view, const fxl_scene *scene,
                                const fxl_instance *instance, fxl_planes planes,
                                const fxl_view *view, fxl_vertex_cache *cache)
{
    const fxl_point *eye = &view->camera.position;
    /* Both within FXL_COORDINATE_MAX. */
    const fxl_point offset = {instance->centre.x - eye->x, instance->centre.y - eye->y,
                              instance->centre.z - eye->z};
    set_up(model_view, &offset, planes, view, cache);
    model_view->vertices = scene->vertices + scene->models[instance->model].first_vertex;
    model_view->indices = scene->indices;
}

void fxl_model_view_of_polygon(fxl_model_view *model_view, const fxl_point *points,
                               fxl_planes planes, const fxl_view *view, fxl_vertex_cache *cache)
{
    static const uint16_t indices[] = {0,  1,  2,  3,  4,  5,  6,  7,  8,  9,  10,
                                       11, 12, 13, 14, 15, 16, 17, 18, 19, 20, 21,
                                       22, 23, 24, 25, 26, 27, 28, 29, 30, 31};
    FXL_STATIC_ASSERT(sizeof indices / sizeof indices[0] >= FXL_POLYGON_CAPACITY, "all indices");
    const fxl_point *eye = &view->camera.position;
    const fxl_point offset = {-eye->x, -eye->y, -eye->z};
    set_up(model_view, &offset, planes, view, cache);
    model_view->vertices = points;
    model_view->indices = indices;
}

/* SPDX-License-Identifier: MIT */
/* The model view of an instance in one frame: what its faces share, and its vertices
 * in the view. A vertex is transformed when a face first fetches it. */
#ifndef FXL_MODEL_VIEW_H
#define FXL_MODEL_VIEW_H

#include "fixel/stage/outcode.h"
#include "fixel/scene.h"
#include "fixel/stage/view.h"

#ifdef __cplusplus
extern "C" {
#endif

/* A clip flag: the vertex was not projected yet, so `screen` has no meaning. */
#define FXL_VERTEX_UNPROJECTED 0x80u

/* The clip flags that are planes, and the one above. These bits are 0 for a vertex that is inside
 * all planes and projected. */
#define FXL_VERTEX_OUTSIDE 0xFFu

/* A vertex in the view. */
typedef struct {
    uint32_t tag;        /* the instance, in the cache's count, and the vertex; 0: no vertex */
    uint32_t clip_flags; /* its outcode and FXL_VERTEX_UNPROJECTED; if both are 0, its first pixel
                            centre (lib/clip/vertex_flags.h) */
    fxl_screen_point screen;
    fxl_view_point position;
} fxl_cached_vertex;

/* A direct-mapped cache of vertices: vertex n is in entry n & mask. Two vertices of one entry
 * displace each other, which costs only time. */
typedef struct {
    fxl_cached_vertex *entries; /* of the caller's memory; null: only the entry below */
    uint32_t mask;              /* number of entries - 1; the number is a power of two */
    uint32_t count;             /* model views made, from 1, in units of 2^16 */
    void *clipper_workspace;    /* what the clipper keeps beside the vertices; or null */
    fxl_cached_vertex own;      /* all of the cache where the caller gave no memory */
} fxl_vertex_cache;

struct fxl_shader;

/* A bit beside the planes of a model view: fxl_transform_vertex calls scale_vertex. */
#define FXL_MODEL_VIEW_SCALED 0x80u

/* A model view. The caller owns it. */
typedef struct fxl_model_view {
    const fxl_view *view;
    fxl_cached_vertex *entries; /* of the cache */
    uint32_t mask;              /* of the cache */
    uint32_t tag;               /* of vertex 0 */
    const fxl_point *vertices;  /* of the model */
    const uint16_t *indices;    /* of the scene */
    const fxl_axes *axes;       /* rows of the rotation from the model to the view */
    fxl_planes planes;          /* those that a vertex may lie outside of; FXL_MODEL_VIEW_SCALED */
    uint8_t shift;              /* with FXL_MODEL_VIEW_SCALED: of the axes, 1..8 */
    fxl_view_point translation; /* where the model's origin is in the view */
    fxl_point offset;           /* the instance's centre - the eye; each coordinate below 2^30 */
    const struct fxl_shader *shader; /* the first that takes the instance's faces; null: none */
    void *clipper_workspace;         /* the clipper's, of the caller's memory; or null */
    /* With FXL_MODEL_VIEW_SCALED: makes a vertex that was transformed without the shift one with
     * the shift, with its clip flags, which it returns. */
    uint32_t (*scale_vertex)(const struct fxl_model_view *model_view, fxl_cached_vertex *entry);
    const fxl_instance *instance; /* of the model view, where there is a shader */
} fxl_model_view;

/* Sets up a cache in memory of the caller. Its number of entries is the largest power of two that
 * is at most entry_count and at most 65536; where entry_count is 0, one within the cache, and
 * entries is not looked at. The record holds no pointer to itself. clipper_workspace stays. */
void fxl_vertex_cache_init(fxl_vertex_cache *cache, fxl_cached_vertex *entries,
                           uint32_t entry_count);

/* Sets up the model view of an instance. All entries of the cache become stale.
 * Its planes are all; to save time the caller takes out those that no vertex lies outside of.
 * Requires a checked scene and a view with a pose. Exact. */
void fxl_model_view_of_instance(fxl_model_view *model_view, const fxl_scene *scene,
                                const fxl_instance *instance, const fxl_view *view,
                                fxl_vertex_cache *cache);

/* Sets up the model view of a polygon of the world: its vertices are points, and its face is any
 * whose first_index is 0. All entries of the cache become stale.
 * Planes as for an instance.
 * Requires at most FXL_POLYGON_CAPACITY points, each within FXL_COORDINATE_MAX, that outlive
 * *model_view. Exact. */
void fxl_model_view_of_polygon(fxl_model_view *model_view, const fxl_point *points,
                               const fxl_view *view, fxl_vertex_cache *cache);

/* A vertex of the model relative to the eye, along the world's axes, in world units. Exact: the
 * vertex in the world and the eye are within FXL_COORDINATE_MAX, so each
 * coordinate is below 2^30. */
static inline fxl_point fxl_model_view_vertex(const fxl_model_view *model_view, uint32_t number)
{
    const fxl_point *vertex = &model_view->vertices[number];
    const fxl_point *offset = &model_view->offset;
    fxl_point moved = {vertex->x + offset->x, vertex->y + offset->y, vertex->z + offset->z};
    return moved;
}

/* Transforms a vertex of the model into an entry of the cache: tag, position and clip flags. The
 * vertex becomes unprojected. It is a kernel: each family of cores has its own, and
 * all give the same bits. Exact, given the camera's matrix. */
void fxl_transform_vertex(const fxl_model_view *model_view, uint32_t number,
                          fxl_cached_vertex *entry);

/* Returns a vertex of the model in the view, from the cache or transformed. The pointer is valid
 * until the next fetch. The caller may change clip_flags and screen, and nothing else. */
static inline fxl_cached_vertex *fxl_fetch_vertex(const fxl_model_view *model_view, uint32_t number)
{
    fxl_cached_vertex *entry = &model_view->entries[number & model_view->mask];
    if (entry->tag != model_view->tag + number) {
        fxl_transform_vertex(model_view, number, entry);
    }
    return entry;
}

#ifdef __cplusplus
}
#endif

#endif

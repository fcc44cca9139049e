/* SPDX-License-Identifier: MIT */
/* An object as the eye sees it in one frame: what its faces share, and its
 * vertices in the view, each worked out when a face first asks for it. */
#ifndef FXL_MODEL_VIEW_H
#define FXL_MODEL_VIEW_H

#include "fixel/stage/outcode.h"
#include "fixel/scene.h"
#include "fixel/stage/view.h"

/* Its place on the screen was not worked out yet. */
#define FXL_VERTEX_UNPROJECTED 0x80u

/* What of a state is planes and the above: 0 for a vertex inside of all, on the screen. */
#define FXL_VERTEX_OUTSIDE 0xFFu

/* A vertex in the view. */
typedef struct {
    uint32_t tag;        /* which vertex of which object in the cache's count; 0: none */
    uint32_t clip_flags; /* the planes that it lies outside of; FXL_VERTEX_UNPROJECTED; where those
                       are 0, the first centre from its place on (seen.h) */
    fxl_screen_point screen;
    fxl_view_point position;
} fxl_cached_vertex;

/* Where vertices are kept: vertex n in entry n & mask. Two of one entry displace
 * each other, which costs time and nothing else. */
typedef struct {
    fxl_cached_vertex *entries;
    uint32_t mask;  /* entries - 1, a power of two less 1 */
    uint32_t count; /* objects placed, from 1, in units of 2^16 */
} fxl_vertex_cache;

struct fxl_beam_light;

/* The caller owns it. */
typedef struct {
    const fxl_view *view;
    fxl_cached_vertex *entries; /* of the cache */
    uint32_t mask;              /* of the cache */
    uint32_t tag;               /* of its vertex 0 */
    const fxl_point *vertices;  /* of its model */
    const uint16_t *indices;    /* of the scene */
    fxl_point offset;           /* its centre less the eye; each below 2^30 */
    fxl_planes planes;          /* none of its vertices lies outside of another plane */
    const struct fxl_beam_light *beam_light; /* beams that may light it; null: none */
} fxl_model_view;

/* A cache in memory of the caller, of the largest power of two of entries that
 * fits, 1 <= entry_count. */
void fxl_vertex_cache_init(fxl_vertex_cache *cache, fxl_cached_vertex *entries,
                           uint32_t entry_count);

/* Places an object of a checked scene; what the cache holds of others is stale. */
void fxl_model_view_of_instance(fxl_model_view *model_view, const fxl_scene *scene,
                                const fxl_instance *instance, fxl_planes planes,
                                const fxl_view *view, fxl_vertex_cache *cache);

/* Places a polygon of the world, of FXL_POLYGON_CAPACITY points at most, each within
 * FXL_COORDINATE_MAX, which must outlive *placed: its faces are those whose first corner is
 * 0. What the cache holds of others is stale. */
void fxl_model_view_of_polygon(fxl_model_view *model_view, const fxl_point *points,
                               fxl_planes planes, const fxl_view *view, fxl_vertex_cache *cache);

/* A vertex of the model relative to the eye, along the world's axes. Exact: the
 * vertex in the world and the eye are within FXL_COORDINATE_MAX, so each
 * coordinate is below 2^30. */
static inline fxl_point fxl_model_view_vertex(const fxl_model_view *model_view, uint32_t number)
{
    const fxl_point *vertex = &model_view->vertices[number];
    const fxl_point *offset = &model_view->offset;
    fxl_point moved = {vertex->x + offset->x, vertex->y + offset->y, vertex->z + offset->z};
    return moved;
}

/* Works a vertex out into its entry. Exact, given the camera's matrix. */
void fxl_transform_vertex(const fxl_model_view *model_view, uint32_t number,
                          fxl_cached_vertex *entry);

/* The vertex in the view; good until the next is asked for. The state alone may
 * be changed, together with screen. */
static inline fxl_cached_vertex *fxl_fetch_vertex(const fxl_model_view *model_view, uint32_t number)
{
    fxl_cached_vertex *entry = &model_view->entries[number & model_view->mask];
    if (entry->tag != model_view->tag + number) { /* bug: cache-tag */
        fxl_transform_vertex(model_view, number, entry);
    }
    return entry;
}

#endif

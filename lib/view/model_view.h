/* SPDX-License-Identifier: MIT */
/* The model view of an instance in one frame: what its faces share, and its vertices
 * in the view. A vertex is transformed when a face first fetches it. Internal. */
#ifndef FXL_MODEL_VIEW_H
#define FXL_MODEL_VIEW_H

#include "../math/arith.h"
#include "fixel/records.h"

#ifdef __cplusplus
extern "C" {
#endif

/* A clip flag: the vertex was not projected yet, so `screen` has no meaning. */
#define FXL_VERTEX_UNPROJECTED 0x80u

/* The clip flags that are planes, and the one above. These bits are 0 for a vertex that is inside
 * all planes and projected. */
#define FXL_VERTEX_OUTSIDE 0xFFu

/* A bit beside the planes of a model view: fxl_transform_vertex calls scale_vertex. */
#define FXL_MODEL_VIEW_SCALED 0x80u

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
 * that fxl_set_face_of_points made. All entries of the cache become stale.
 * Planes as for an instance.
 * Requires at most FXL_POLYGON_CAPACITY points, each within FXL_COORDINATE_MAX, that outlive
 * *model_view. Exact. */
void fxl_model_view_of_polygon(fxl_model_view *model_view, const fxl_point *points,
                               const fxl_view *view, fxl_vertex_cache *cache);

/* The indices of a face whose vertices are count points: 0, 1, 2, ... */
static inline void fxl_set_face_of_points(fxl_face *face, uint32_t count)
{
    face->count = (uint8_t)count;
    face->indices[0] = 0;
    face->indices[1] = count == 3 ? 1 : 0;
    face->indices[2] = count == 3 ? 2 : 0;
}

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

/* Whether one function transforms and projects: a kernel, or C where products are long. Not on a host, where
 * make predict counts both. */
#define FXL_TRANSFORMS_AND_PROJECTS \
    (!FXL_IS_COMPACT && FXL_HAS_LONG_PRODUCT && !FXL_HAS_LONG_DIVIDER)

#if FXL_TRANSFORMS_AND_PROJECTS
/* The same, with its tag, and fxl_project_inside of a vertex that is inside all planes: FXL_OK or
 * FXL_E_RANGE, and of FXL_OK its clip flags are not those that it has. -1: it is outside of one. */
int32_t fxl_transform_and_project(const fxl_model_view *model_view, uint32_t number,
                                  fxl_cached_vertex *entry, uint32_t tag);
#endif

/* Returns a vertex of the model in the view, from the cache or transformed. The pointer is valid
 * until the next fetch. The caller may change clip_flags and screen, and nothing else. */
/* SPEC 4.10 */
FXL_IN_PLACE fxl_cached_vertex *fxl_fetch_vertex(const fxl_model_view *model_view, uint32_t number)
#if FXL_IS_SMALL && !defined(FXL_HERE)
    ;
#else
{
    fxl_cached_vertex *entry = &model_view->entries[number & model_view->mask];
    if (entry->tag != model_view->tag + number) {
        fxl_transform_vertex(model_view, number, entry);
    }
    return entry;
}
#endif

/* Whether all vertices of a face lie outside one plane of the model view: it fetches them. Exact. */
bool fxl_face_is_outside(const fxl_model_view *model_view, const fxl_face *face);

/* *sum = *origin + axes . point: three exact sums. sum may be origin. Requires each coordinate of
 * the point below 2^30. Then each product with an axis is below 2^61 (fxl_dot), and *origin must
 * leave room for it. */
FXL_IN_PLACE void fxl_rotate(const fxl_axes *axes, const fxl_point *point,
                             const fxl_view_point *origin, fxl_view_point *sum)
    FXL_REQUIRES(FXL_OBJECT(axes) && FXL_OBJECT(point) && FXL_OBJECT(origin) && FXL_OBJECT(sum))
    FXL_REQUIRES(FXL_DIRECTION(&axes->right) && FXL_DIRECTION(&axes->up))
    FXL_REQUIRES(FXL_DIRECTION(&axes->forward) && FXL_POINT_BELOW(point, 1 << 30))
    FXL_REQUIRES(FXL_POINT_BELOW(origin, (int64_t)1 << 62)) FXL_ASSIGNS(*sum)
#if FXL_IS_SMALL && !defined(FXL_HERE)
    ;
#else
{
    const int32_t x = point->x, y = point->y, z = point->z;
    sum->x = origin->x + fxl_dot(&axes->right, x, y, z);
    FXL_IN_ORDER();
    sum->y = origin->y + fxl_dot(&axes->up, x, y, z);
    FXL_IN_ORDER();
    sum->z = origin->z + fxl_dot(&axes->forward, x, y, z);
}
#endif

/* A vertex of the model in the view: translation + axes . vertex. The translation is the rotated
 * offset, so the sum is that of the vertex relative to the eye, to the bit, and below 2^61. A
 * vertex is within FXL_COORDINATE_MAX, so a partial sum is below 2^61 + 2^60. */
static inline void fxl_model_view_position(const fxl_model_view *model_view, uint32_t number,
                                           fxl_view_point *position)
{
    fxl_rotate(model_view->axes, &model_view->vertices[number], &model_view->translation, position);
}

/* Transforms a point: *view becomes the point relative to the eye along right, up and
 * forward. Requires |point| <= FXL_COORDINATE_MAX in each coordinate.
 * Exact, given the camera's matrix: three sums in 64 bits, below 2^61 units of 2^-46.
 * Source: A6 (Listing 65.3, TransformPoint). */
void fxl_transform_point(const fxl_camera *camera, const fxl_point *point, fxl_view_point *view)
    FXL_REQUIRES(FXL_OBJECT(camera) && FXL_OBJECT(point) && FXL_OBJECT(view))
    FXL_REQUIRES(fxl_point_in_range(point) && fxl_point_in_range(&camera->position))
    FXL_REQUIRES(FXL_DIRECTION(&camera->axes.right) && FXL_DIRECTION(&camera->axes.up))
    FXL_REQUIRES(FXL_DIRECTION(&camera->axes.forward)) FXL_ASSIGNS(*view)
    FXL_ENSURES(FXL_POINT_BELOW(view, (int64_t)7 << 59));

#ifdef __cplusplus
}
#endif

#endif

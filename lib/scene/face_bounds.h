/* SPDX-License-Identifier: MIT */
/* The whole face that a face is a part of; and the bounds of a face from its vertices: for the check
 * of a scene's face bounds, and for the order of a scene that has none. Internal. */
#ifndef FXL_FACE_BOUNDS_H
#define FXL_FACE_BOUNDS_H

#include "../math/arith.h"
#include "fixel/scene.h"

/* The number of the first index of a face that is no triangle. */
static inline uint32_t fxl_face_first_index(const fxl_face *face)
{
    return face->indices[1] | (uint32_t)face->indices[2] << 16;
}

/* The number of a whole face's first index, and of its vertices: FXL_WHOLE. */
static inline uint32_t fxl_whole_first(uint32_t whole)
{
    return whole >> 5;
}

static inline uint32_t fxl_whole_count(uint32_t whole)
{
    return whole & 31u;
}

/* Whether a face of a scene is a part of another. */
static inline bool fxl_is_part(const fxl_scene *scene, const fxl_face *face)
{
    return scene->wholes != NULL && scene->wholes[face - scene->faces] != 0;
}

/* The indices of a face. */
typedef struct {
    const uint16_t *indices;
    uint32_t count;
} fxl_face_outline;

/* Those of a face of a scene, of a part those of the whole face. */
static inline fxl_face_outline fxl_whole_face(const fxl_scene *scene, const fxl_face *face)
{
    fxl_face_outline outline = {fxl_face_indices(scene->indices, face), face->count};
    if (fxl_is_part(scene, face)) {
        const uint32_t whole = scene->wholes[face - scene->faces];
        outline.indices = scene->indices + fxl_whole_first(whole);
        outline.count = fxl_whole_count(whole);
    }
    return outline;
}

/* Widens [*low, *high] to hold the value. */
static inline void fxl_widen(int32_t value, int32_t *low, int32_t *high)
{
    if (value < *low) {
        *low = value;
    }
    if (value > *high) {
        *high = value;
    }
}

/* The bounding box of a face: minimum + maximum of each coordinate. A model's vertices are below
 * 2^30, so the sums are below 2^31. */
/* formats 1.6 */
FXL_IN_PLACE_LARGE fxl_point fxl_face_box(const fxl_point *vertices, const uint16_t *indices,
                                          uint32_t count)
#if FXL_IS_COMPACT && !defined(FXL_HERE)
    ;
#else
{
    const uint16_t *end = indices + count;
    fxl_point low = vertices[*indices];
    fxl_point high = low;
    while (++indices < end) {
        const fxl_point *vertex = &vertices[*indices];
        fxl_widen(vertex->x, &low.x, &high.x);
        fxl_widen(vertex->y, &low.y, &high.y);
        fxl_widen(vertex->z, &low.z, &high.z);
    }
    fxl_point box = {low.x + high.x, low.y + high.y, low.z + high.z};
    return box;
}
#endif

/* The same of face `number` of a model: from the model's bounds, where they are known. */
static inline fxl_point fxl_face_box_of(const fxl_face_bounds *known, uint32_t number,
                                        const fxl_point *vertices, const uint16_t *indices,
                                        uint32_t count)
{
    fxl_point box;
    if (known != NULL) {
        box.x = known[number].box_x;
        box.y = known[number].box_y;
        box.z = known[number].box_z;
    } else {
        box = fxl_face_box(vertices, indices, count);
    }
    return box;
}

/* The distance of the face's plane from the model's origin, along the normal, in units of 2^-46.
 * Each coordinate is below 2^30: see fxl_dot. */
/* formats 1.6 */
static inline fxl_q18_46 fxl_face_height(const fxl_point *vertices, const fxl_face *face)
{
    const fxl_point *first = &vertices[face->indices[0]];
    return fxl_dot(&face->normal, first->x, first->y, first->z);
}

static inline fxl_q18_46 fxl_face_bounds_height(const fxl_face_bounds *bounds)
{
    return fxl_signed_64((uint64_t)bounds->height_high << 32 | bounds->height_low);
}

#endif

/* SPDX-License-Identifier: MIT */
/* The faces that face the eye: the test of one, and of all of a model by the scene's face bounds;
 * and a face as a polygon of the world. Internal. */
#ifndef FXL_CULL_H
#define FXL_CULL_H

#include "../math/arith.h"
#include "estimate.h"
#include "fixel/records.h"
#include "model_view.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Whether a face of an instance is turned towards the eye:
 *   normal . (eye - first vertex) > 0.
 * Requires a checked scene, and an eye within FXL_COORDINATE_MAX.
 * Exact, given the stated normal: the sum is below 2^61.
 * Source: A6 (Listing 65.3, PolyFacesViewer). */
bool fxl_face_is_front(const fxl_scene *scene, const fxl_instance *instance, const fxl_face *face,
                       const fxl_point *eye);

/* Makes a face of an instance a polygon of the world, without texture.
 * Requires face->count <= FXL_FACE_VERTICES_MAX. Exact. */
void fxl_face_to_polygon(const fxl_model_view *model_view, const fxl_face *face,
                         fxl_polygon *polygon);

/* The same as fxl_face_is_front, with the first vertex relative to the eye: normal . (eye - vertex)
 * > 0. Exact. */
static inline bool fxl_model_view_face_is_front(const fxl_model_view *model_view,
                                                const fxl_face *face)
{
    fxl_point first = fxl_model_view_vertex(model_view, model_view->indices[face->first_index]);
    return fxl_dot_is_negative(&face->normal, first.x, first.y, first.z);
}

/* Below 2^62 for |value| < 2^31. */
static inline uint64_t fxl_square(int32_t value)
{
    return (uint64_t)fxl_multiply_s32(value, value);
}

/* The squared distance of fxl_face_distance_squared: the squared length of box - 2 eye. Requires
 * box and eye relative to the same point. The difference of two points of the world is below 2^30,
 * so each coordinate is below 2^31, and intermediate wraps cancel. */
static inline uint64_t fxl_box_distance(int32_t x, int32_t y, int32_t z, const fxl_point *eye)
{
    return fxl_square((int32_t)((uint32_t)x - 2 * (uint32_t)eye->x)) +
           fxl_square((int32_t)((uint32_t)y - 2 * (uint32_t)eye->y)) +
           fxl_square((int32_t)((uint32_t)z - 2 * (uint32_t)eye->z));
}

/* Whether a face faces the eye: normal . eye > height. Exact. For kernels whose estimate does not
 * decide. Requires what fxl_front_faces requires. */
bool fxl_bounded_face_is_front(const fxl_face *face, const fxl_face_bounds *bounds,
                               const fxl_point *eye);

/* Appends an entry, with squared distance and number, for each of count faces that faces the eye.
 * Their numbers are end - count to end - 1. A face does if normal . eye > height. Both sides are
 * below 2^61; fxl_face_is_front tests the sign of their difference. Returns the address behind the
 * last entry. The entries' `next` has no meaning. Requires count >= 1, and the eye relative to the
 * model's origin, each coordinate below 2^30. */
fxl_draw_entry *fxl_front_faces(const fxl_face *faces, const fxl_face_bounds *bounds,
                                const fxl_point *eye, fxl_draw_entry *entry, uint32_t count,
                                uint32_t end);

#ifdef __cplusplus
}
#endif

#endif

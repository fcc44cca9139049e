/* SPDX-License-Identifier: MIT */
/* The facing test, and a face as a polygon of the world. */
#ifndef FXL_CULL_H
#define FXL_CULL_H

#include "fixel/stage/model_view.h"

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

#endif

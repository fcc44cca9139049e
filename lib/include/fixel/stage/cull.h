/* SPDX-License-Identifier: MIT */
/* Back faces (Listing 65.3, PolyFacesViewer), and a face as a polygon of the
 * world. */
#ifndef FXL_CULL_H
#define FXL_CULL_H

#include "fixel/stage/model_view.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Whether a face of an object is turned towards the eye:
 *   normal . (eye - first vertex) > 0.
 * Exact, given the stated normal: the sum is below 2^61. */
bool fxl_face_is_front(const fxl_scene *scene, const fxl_instance *instance, const fxl_face *face,
                       const fxl_point *eye);

/* A face of a placed object in the world, without texture. Exact. */
void fxl_face_to_polygon(const fxl_model_view *model_view, const fxl_face *face,
                         fxl_polygon *polygon);

#ifdef __cplusplus
}
#endif

#endif

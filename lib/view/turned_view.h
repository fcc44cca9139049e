/* SPDX-License-Identifier: MIT */
/* The model view of a turned instance in one frame. Internal. */
#ifndef FXL_TURNED_VIEW_H
#define FXL_TURNED_VIEW_H

#include "../math/arith.h"
#include "model_view.h"

/* A turned view. The caller owns it. */
typedef struct {
    /* Its axes are matrix. Its offset is less the eye in the space of the model, in units of
     * 2^eye_shift / 65536. It is the first member: scale_vertex and lights are given its address.
     */
    fxl_model_view model_view;
    fxl_axes matrix;
    const fxl_turn *turn;
    fxl_point from_eye; /* the instance's centre - the eye, along the world's axes */
    unsigned eye_shift;
} fxl_turned_view;

/* Sets up the turned view of an instance that is turned, as fxl_model_view_of_instance does, and
 * answers the instance's model. Its planes are those given; the caller gives those that
 * fxl_sphere_planes finds for fxl_turn_radius. Requires a checked scene and a checked turn. */
const fxl_model *fxl_turned_view_of_instance(fxl_turned_view *turned, const fxl_scene *scene,
                                             uint32_t number, const fxl_view *view,
                                             fxl_vertex_cache *cache, uint32_t planes);

/* Fills entries with those of count faces of the instance's model, from first on, that face the
 * eye, as fxl_order_front_faces does. */
uint32_t fxl_order_turned_faces(const fxl_turned_view *turned, const fxl_scene *scene,
                                const fxl_model *model, uint32_t first, uint32_t count,
                                fxl_order_entry *entries);

/* The planes that a cluster of the instance may cross, of the model view's, and
 * FXL_MODEL_VIEW_SCALED as the model view has it; or 0; or FXL_SPHERE_OUTSIDE. */
uint32_t fxl_turned_cluster_planes(const fxl_turned_view *turned, const fxl_cluster *cluster);

/* fxl_turn_is_front, from all bits. */
bool fxl_turned_view_is_front(const fxl_turned_view *turned, const fxl_face *face);

/* Whether a face is turned away from the eye: -1 no, 1 yes, 0 the estimate does not decide.
 * distance is normal . (first vertex - eye) in the space of the model, in units of
 * 2^(eye_shift - 46), from the rounded eye. Each coordinate of that is off by at most 1/2, the
 * normal's components sum up to less than 1.74 2^30, and the floor of a height adds 1: so the exact
 * distance differs by less than 2^30. It decides from 2^32 on, which the upper word tells. */
static inline int fxl_estimated_side(fxl_q18_46 distance)
{
    const int32_t upper = (int32_t)(distance >> 32);
    if (upper < -1) {
        return -1;
    }
    return upper > 0;
}

/* Whether a face is turned towards the eye. Exact. is_near: eye_shift is 0. */
static inline bool fxl_turned_view_face_is_front(const fxl_turned_view *turned,
                                                 const fxl_face *face, bool is_near)
{
    const fxl_model_view *model_view = &turned->model_view;
    if (is_near) {
        /* Below 2^30: fxl_turn_eye says so. */
        const fxl_point first =
            fxl_model_view_vertex(model_view, model_view->indices[face->first_index]);
        const int side = fxl_estimated_side(fxl_dot(&face->normal, first.x, first.y, first.z));
        if (side != 0) {
            return side < 0;
        }
    }
    return fxl_turned_view_is_front(turned, face);
}

#endif

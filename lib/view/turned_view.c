/* SPDX-License-Identifier: MIT */
#include "../scene/face_bounds.h"
#include "../scene/placement_code.h"
#include "cull.h"
#include "model_view.h"
#include "order.h"
#include "outcode.h"
#include "placement.h"

/* Moves the vertex to translation + 2^shift (matrix . vertex). Exact: the difference is matrix .
 * vertex, and the instance lies within FXL_COORDINATE_MAX, so the product is below 2^60. */
static fxl_q18_46 scaled_from(fxl_q18_46 translation, fxl_q18_46 position, unsigned shift)
{
    return translation + (fxl_q18_46)((uint64_t)(position - translation) << shift);
}

static uint32_t scale_vertex(const fxl_model_view *model_view, fxl_cached_vertex *entry)
{
    const fxl_view_point *from = &model_view->translation;
    const fxl_planes planes = model_view->planes & FXL_PLANES_ALL;
    fxl_view_point *at = &entry->position;
    at->x = scaled_from(from->x, at->x, model_view->shift);
    at->y = scaled_from(from->y, at->y, model_view->shift);
    at->z = scaled_from(from->z, at->z, model_view->shift);
    entry->clip_flags =
        FXL_VERTEX_UNPROJECTED |
        (planes != 0 ? (uint32_t)fxl_outcode(&model_view->view->view_frustum, planes, at) : 0u);
    return entry->clip_flags;
}

const fxl_model *fxl_turned_view_of_instance(fxl_turned_view *turned, const fxl_scene *scene,
                                             uint32_t number, const fxl_view *view,
                                             fxl_vertex_cache *cache, uint32_t planes)
{
    fxl_model_view *model_view = &turned->model_view;
    const fxl_instance *instance = &scene->instances[number];
    const fxl_model *model = &scene->models[instance->model];
    const fxl_placement *placement = fxl_placement_of(scene, number);
    fxl_point eye;
    turned->placement = placement;
    fxl_model_view_of_instance(model_view, scene, instance, view, cache);
    turned->from_eye = model_view->offset;
    turned->eye_shift = fxl_placement_eye(placement, &turned->from_eye, model->radius, &eye);
    model_view->offset.x = -eye.x;
    model_view->offset.y = -eye.y;
    model_view->offset.z = -eye.z;
    model_view->axes = &turned->matrix;
    model_view->planes = (fxl_planes)planes;
    const unsigned shift = fxl_placement_matrix(placement, &view->camera.axes, &turned->matrix);
    if (shift != 0) {
        model_view->shift = (uint8_t)shift;
        model_view->planes |= FXL_MODEL_VIEW_SCALED;
        model_view->scale_vertex = scale_vertex;
    }
    return model;
}

bool fxl_turned_view_is_front(const fxl_turned_view *turned, const fxl_face *face)
{
    const fxl_model_view *model_view = &turned->model_view;
    const fxl_q18_46 height =
        fxl_face_height(model_view->vertices, model_view->indices + face->first_index, face);
    return fxl_placement_is_front(turned->placement, &turned->from_eye, &face->normal, height);
}

/* The squared distance of the box from the eye, both in units of 2^shift / 65536; the box is
 * rounded down. With the limit of fxl_placement_eye each difference is at most 2^31, and the square
 * of one that wraps to -2^31 is the same. */
static uint64_t box_distance(const fxl_point *box, const fxl_point *eye, unsigned shift)
{
    return fxl_box_distance(box->x >> shift, box->y >> shift, box->z >> shift, eye);
}

uint32_t fxl_list_turned_faces(const fxl_turned_view *turned, const fxl_scene *scene,
                               const fxl_model *model, uint32_t first, uint32_t count,
                               fxl_draw_entry *entries)
{
    const fxl_model_view *model_view = &turned->model_view;
    const fxl_point *offset = &model_view->offset;
    const fxl_point eye = {-offset->x, -offset->y, -offset->z};
    const fxl_face_bounds *known =
        scene->face_bounds != NULL ? &scene->face_bounds[model->first_face_bounds] : NULL;
    const fxl_draw_entry *const start = entries;
    for (uint32_t i = first; i < first + count; i++) {
        const fxl_face *face = &scene->faces[model->first_face + i];
        const uint16_t *indices = model_view->indices + face->first_index;
        const fxl_q18_46 height = known != NULL
                                      ? fxl_face_bounds_height(&known[i])
                                      : fxl_face_height(model_view->vertices, indices, face);
        const int side = fxl_estimated_side((height >> turned->eye_shift) -
                                            fxl_dot(&face->normal, eye.x, eye.y, eye.z));
        if (side < 0 || (side == 0 && fxl_turned_view_is_front(turned, face))) {
            fxl_point box;
            if (known != NULL) {
                box.x = known[i].box_x;
                box.y = known[i].box_y;
                box.z = known[i].box_z;
            } else {
                box = fxl_face_box(model_view->vertices, indices, face->count);
            }
            *entries++ =
                fxl_draw_entry_of(box_distance(&box, &eye, turned->eye_shift), (uint16_t)i, 0);
        }
    }
    return (uint32_t)(entries - start);
}

/* A vertex v of the cluster is |scale orientation . (v - c)| away from the cluster's centre c, both
 * placed. That is at most the scaled radius and 22 units of 1/65536, if the scaled radius is at
 * most FXL_COORDINATE_MAX: rows stretch by less than 11 2^-28. The centre's rounding adds 0.87
 * units, and the matrix's, or the point's where it is rounded in the world, 1.5.
 * FXL_PLACEMENT_SLACK is more. The box that holds c may reach out of the model's sphere, and so of
 * the world. */
uint32_t fxl_turned_cluster_planes(const fxl_turned_view *turned, const fxl_cluster *cluster)
{
    const fxl_model_view *model_view = &turned->model_view;
    const fxl_view *view = model_view->view;
    const fxl_point *eye = &view->camera.position;
    const fxl_placement *placement = turned->placement;
    const uint64_t reach = fxl_multiply_u32((uint32_t)placement->scale, (uint32_t)cluster->radius);
    fxl_point centre = {turned->from_eye.x + eye->x, turned->from_eye.y + eye->y,
                        turned->from_eye.z + eye->z};
    uint32_t planes = model_view->planes & FXL_PLANES_ALL;
    if (planes == 0) {
        return 0;
    }
    fxl_placement_point(placement, &centre, &cluster->centre, &centre);
    if (reach <= (uint64_t)FXL_COORDINATE_MAX << 16 && fxl_point_in_range(&centre)) {
        const uint32_t crossed =
            fxl_sphere_planes(&view->camera, &view->view_frustum, &centre,
                              fxl_scaled_radius(placement->scale, cluster->radius));
        if (crossed == FXL_SPHERE_OUTSIDE) {
            return crossed;
        }
        planes &= crossed;
    }
    return planes == 0 ? 0 : planes | (model_view->planes & FXL_MODEL_VIEW_SCALED);
}

/* SPDX-License-Identifier: MIT */
#include "clusters.h"

#include "../math/arith.h"
#include "fixel/stage/sphere.h"
#include "front_faces.h"

/* With u = apex - eye, the eye is in the cone if u . axis >= 0 and (u . axis)^2 >= cutoff |u|^2.
 * Apex and eye are below 2^30, so u is below 2^31, u . axis below 2^62 by Cauchy-Schwarz, and |u|^2
 * below 3 * 2^62. along is u . axis in units of 2^-14, rounded down, below 2^30. 16 along^2 is
 * below 2^64 and in the unit of |u|^2, 2^-32. limit is cutoff |u|^2 in that unit, rounded down. So
 * the comparison errs only towards an eye that is not in the cone. */
bool fxl_cluster_is_turned_away(const fxl_cluster *cluster, const fxl_point *eye)
{
    const int32_t x = cluster->apex.x - eye->x, y = cluster->apex.y - eye->y,
                  z = cluster->apex.z - eye->z;
    const int32_t along =
        (int32_t)((fxl_multiply_s32(cluster->axis.x, x) + fxl_multiply_s32(cluster->axis.y, y) +
                   fxl_multiply_s32(cluster->axis.z, z)) >>
                  32);
    if (along <= 0) { /* bug: cluster-behind */
        return false;
    }
    const uint64_t square = fxl_square(x) + fxl_square(y) + fxl_square(z);
    const uint64_t limit = fxl_multiply_u32((uint32_t)(square >> 32), cluster->cutoff) +
                           (fxl_multiply_u32((uint32_t)square, cluster->cutoff) >> 32);
    return fxl_square(along) << 4 > limit; /* bug: cluster-cutoff */
}

/* The planes that a cluster may cross, of those that its instance may cross. */
static uint32_t planes_of(const fxl_cluster *cluster, const fxl_model_view *model_view)
{
    const fxl_camera *camera = &model_view->view->camera;
    /* Within FXL_COORDINATE_MAX, because the cluster's vertices are, and its centre lies in their
     * bounding box. */
    const fxl_point centre = {cluster->centre.x + model_view->offset.x + camera->position.x,
                              cluster->centre.y + model_view->offset.y + camera->position.y,
                              cluster->centre.z + model_view->offset.z + camera->position.z};
    if (model_view->planes == 0) {
        return 0;
    }
    const uint32_t planes =
        fxl_sphere_planes(camera, &model_view->view->view_frustum, &centre, cluster->radius);
    return planes == FXL_SPHERE_OUTSIDE ? planes : planes & model_view->planes;
}

/* fxl_order_front_faces for count faces of a model from first on. */
static uint32_t order_run(const fxl_scene *scene, const fxl_model *model, uint32_t first,
                          uint32_t count, const fxl_point *eye, fxl_order_entry *entries)
{
    if (!FXL_IS_SMALL && scene->face_bounds != NULL) {
        return (uint32_t)(fxl_front_faces(&scene->faces[model->first_face + first],
                                          &scene->face_bounds[model->first_face_bounds + first],
                                          eye, entries, count, first + count) -
                          entries);
    }
    fxl_model run = *model;
    run.first_face += first;
    run.first_face_bounds += first;
    run.face_count = count;
    const uint32_t found = fxl_order_front_faces(scene, &run, eye, entries);
    for (uint32_t i = 0; i < found; i++) {
        entries[i].index = (uint16_t)(entries[i].index + first);
    }
    return found;
}

uint32_t fxl_order_clusters(const fxl_scene *scene, const fxl_model *model,
                            const fxl_model_view *model_view, bool drops, fxl_order_entry *entries,
                            uint32_t *front)
{
    const fxl_face *faces = &scene->faces[model->first_face];
    const fxl_cluster *cluster = &scene->clusters[model->first_cluster - 1];
    const fxl_point *offset = &model_view->offset;
    const fxl_point eye = {-offset->x, -offset->y, -offset->z};
    FXL_ALIGN_8 fxl_model_view narrowed = *model_view;
    uint32_t count = 0;
    *front = 0;
    for (uint32_t first = 0; first < model->face_count; first += (cluster++)->face_count) {
        const uint32_t planes = planes_of(cluster, model_view);
        if (planes == FXL_SPHERE_OUTSIDE) {
            *front += cluster->face_count; /* bug: cluster-outside */
        } else if (!fxl_cluster_is_turned_away(cluster, &eye)) {
            uint32_t found =
                order_run(scene, model, first, cluster->face_count, &eye, entries + count);
            *front += found;
            if (drops && planes != 0) {
                narrowed.planes = (fxl_planes)planes;
                found = fxl_order_drop_outside(&narrowed, faces, entries + count, found);
            }
            count += found;
        }
    }
    return count;
}

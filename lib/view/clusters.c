/* SPDX-License-Identifier: MIT */
#define PLANES_OF fxl_still_cluster_planes
#define IS_TURNED_AWAY(cluster, eye, model_view) fxl_cluster_is_turned_away(cluster, eye)
#define FIND_FRONT order_run

#include "clusters.h"
#include "cull.h"
#include "order.h"
#include "outcode.h"

#include "../math/arith.h"

static uint32_t order_run(const fxl_scene *scene, const fxl_model *model, uint32_t first,
                          uint32_t count, const fxl_model_view *model_view, const fxl_point *eye,
                          fxl_draw_entry *entries);

#include "cluster_loop.h"

bool fxl_cluster_is_turned_away(const fxl_cluster *cluster, const fxl_point *eye)
{
    return fxl_is_in_cone(cluster, eye, 0);
}

/* The planes that a cluster may cross, of those that its instance may cross. */
uint32_t fxl_still_cluster_planes(const fxl_cluster *cluster, const fxl_model_view *model_view)
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

/* fxl_list_front_faces for count faces of a model from first on. */
static uint32_t order_run(const fxl_scene *scene, const fxl_model *model, uint32_t first,
                          uint32_t count, const fxl_model_view *model_view, const fxl_point *eye,
                          fxl_draw_entry *entries)
{
    (void)model_view;
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
    const uint32_t found = fxl_list_front_faces(scene, &run, eye, entries);
    for (uint32_t i = 0; i < found; i++) {
        entries[i].index = (uint16_t)(entries[i].index + first);
    }
    return found;
}

uint32_t fxl_list_clusters(const fxl_scene *scene, const fxl_model *model,
                           const fxl_model_view *model_view, bool drops, fxl_draw_entry *entries,
                           uint32_t *front)
{
    return fxl_list_each_cluster(NULL, scene, model, model_view, drops, entries, front);
}

/* SPDX-License-Identifier: MIT */
/* The faces of a model with clusters that may be seen. Internal. */
#ifndef FXL_CLUSTERS_H
#define FXL_CLUSTERS_H

#include "fixel/records.h"

/* fxl_list_front_faces for a model with clusters, without the faces of clusters outside the
 * frustum. If drops is true, it also takes out faces as fxl_drop_outside does. Returns the
 * number of entries. *front becomes the number of faces that do not count as backfacing: those that
 * face the eye, and all faces of clusters outside.
 * Requires a checked scene, the model view of an instance of the model, and as many entries as the
 * model has faces. */
uint32_t fxl_list_clusters(const fxl_scene *scene, const fxl_model *model,
                           const fxl_model_view *model_view, bool drops, fxl_draw_entry *entries,
                           uint32_t *front);

/* The planes of the model view that a cluster may cross, or FXL_SPHERE_OUTSIDE. */
typedef uint32_t fxl_cluster_planes(const fxl_cluster *cluster, const fxl_model_view *model_view);

/* Whether no face of a cluster shows its front to an eye, which is less the model view's offset. */
typedef bool fxl_cluster_cone(const fxl_cluster *cluster, const fxl_point *eye,
                              const fxl_model_view *model_view);

/* fxl_list_front_faces for count faces of the model from first on. */
typedef uint32_t fxl_cluster_front(const fxl_scene *scene, const fxl_model *model, uint32_t first,
                                   uint32_t count, const fxl_model_view *model_view,
                                   const fxl_point *eye, fxl_draw_entry *entries);

/* What clusters are tested by. */
typedef struct {
    fxl_cluster_planes *planes;
    fxl_cluster_cone *is_turned_away;
    fxl_cluster_front *find_front;
} fxl_cluster_tests;

/* fxl_list_clusters by other tests. */
uint32_t fxl_list_clusters_by(const fxl_cluster_tests *tests, const fxl_scene *scene,
                              const fxl_model *model, const fxl_model_view *model_view, bool drops,
                              fxl_draw_entry *entries, uint32_t *front);

/* Whether an eye lies in the cone of a cluster, so that no face shows its front to the eye. The eye
 * is relative to the instance's centre; each coordinate is within 2 FXL_COORDINATE_MAX. The result
 * may be false for an eye that lies in the cone, near its border. */
bool fxl_cluster_is_turned_away(const fxl_cluster *cluster, const fxl_point *eye);

/* The same for an eye whose coordinates were rounded: true only if the exact eye is in the cone. */
fxl_cluster_cone fxl_cluster_is_surely_turned_away;

/* The planes that a cluster of an instance that is not turned may cross. */
fxl_cluster_planes fxl_still_cluster_planes;

#endif

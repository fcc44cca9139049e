/* SPDX-License-Identifier: MIT */
/* The cone of a cluster, and the loop over the clusters of a model. A source that includes
 * this says by three macros how clusters are tested. Internal. */
#ifndef FXL_CLUSTER_LOOP_H
#define FXL_CLUSTER_LOOP_H

#include "../math/arith.h"
#include "clusters.h"
#include "cull.h"
#include "order.h"
#include "outcode.h"

/* With u = apex - eye, the eye is in the cone if u . axis >= 0 and (u . axis)^2 >= cutoff |u|^2.
 * Apex and eye are below 2^30, so u is below 2^31, u . axis below 2^62 by Cauchy-Schwarz, and |u|^2
 * below 3 * 2^62. along is u . axis in units of 2^-14, rounded down, below 2^30. 16 along^2 is
 * below 2^64 and in the unit of |u|^2, 2^-32. limit is cutoff |u|^2 in that unit, rounded down. So
 * the comparison errs only towards an eye that is not in the cone. */
/* SPEC 4.4 */
static inline bool fxl_is_in_cone(const fxl_cluster *cluster, const fxl_point *eye, int32_t slack)
{
    const int32_t x = cluster->apex.x - eye->x, y = cluster->apex.y - eye->y,
                  z = cluster->apex.z - eye->z;
    const int32_t along =
        (int32_t)((fxl_multiply_s32(cluster->axis.x, x) + fxl_multiply_s32(cluster->axis.y, y) +
                   fxl_multiply_s32(cluster->axis.z, z)) >>
                  32) -
        slack;
    if (along <= 0) {
        return false;
    }
    const uint64_t square = fxl_square(x) + fxl_square(y) + fxl_square(z);
    const uint64_t limit = fxl_multiply_u32((uint32_t)(square >> 32), cluster->cutoff) +
                           (fxl_multiply_u32((uint32_t)square, cluster->cutoff) >> 32);
    return fxl_square(along) << 4 > limit;
}

/* fxl_list_clusters_by, by the source's macros PLANES_OF, IS_TURNED_AWAY and FIND_FRONT: the names
 * of functions, which are inlined, or members of tests. */
/* SPEC 4.4 */
static inline uint32_t fxl_list_each_cluster(const fxl_cluster_tests *tests, const fxl_scene *scene,
                                             const fxl_model *model,
                                             const fxl_model_view *model_view, bool drops,
                                             fxl_draw_entry *entries, uint32_t *front)
{
    const fxl_face *faces = &scene->faces[model->first_face];
    const fxl_cluster *cluster = &scene->clusters[model->first_cluster - 1];
    const fxl_point *offset = &model_view->offset;
    const fxl_point eye = {-offset->x, -offset->y, -offset->z};
    FXL_ALIGN_8 fxl_model_view narrowed = *model_view;
    uint32_t count = 0;
    *front = 0;
    (void)tests;
    for (uint32_t first = 0; first < model->face_count; first += (cluster++)->face_count) {
        const uint32_t planes = PLANES_OF(cluster, model_view);
        if (planes == FXL_SPHERE_OUTSIDE) {
            *front += cluster->face_count;
        } else if (!IS_TURNED_AWAY(cluster, &eye, model_view)) {
            uint32_t found = FIND_FRONT(scene, model, first, cluster->face_count, model_view, &eye,
                                        entries + count);
            *front += found;
            if (drops && planes != 0) {
                narrowed.planes = (fxl_planes)planes;
                found = fxl_drop_outside(&narrowed, faces, entries + count, found);
            }
            count += found;
        }
    }
    return count;
}

#endif

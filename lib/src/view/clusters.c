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
    const int32_t along = (int32_t)((fxl_multiply_s32(cluster->axis.x, x) +
                                     fxl_multiply_s32(cluster->axis.y, y) +
                                     fxl_multiply_s32(cluster->axis.z, z)) >>
                                    32);
    if (along <= 0) { /* bug: cluster-behind */
        return false;
    }
    const uint64_t square = fxl_square(x) + fxl_square(y) + fxl_square(z);
    const uint64_t limit =
        fxl_multiply_u32((uint32_t)(square >> 32), cluster->cutoff) +
        (fxl_multiply_u32((uint32_t)square, cluster->cutoff) >> 32);
    return fxl_square(along) << 4 > limit; /* bug: cluster-cutoff */
}

static fxl_order_entry *find_front(const fxl_scene *scene, const fxl_instance *instance,
                                   const fxl_view *view, fxl_planes planes, fxl_order_entry *entry,
                                   uint32_t *outside)
{
    (void)scene; (void)instance; (void)view; (void)planes; (void)outside;
    return entry;
}

const fxl_cluster_code fxl_clusters = {find_front};

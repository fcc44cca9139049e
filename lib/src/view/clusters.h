/* SPDX-License-Identifier: MIT */
/* The faces of a model with clusters that may be seen. Internal. */
#ifndef FXL_CLUSTERS_H
#define FXL_CLUSTERS_H

#include "fixel/stage/order.h"
#include "fixel/stage/outcode.h"
#include "fixel/stage/view.h"

struct fxl_cluster_code {
    /* Appends an entry, with squared distance and number, for each face of an instance that faces
     * the eye and lies in no cluster outside the frustum. Returns the address behind the last entry.
     * *outside becomes the number of faces in the clusters that are outside.
     * Requires a checked scene, an instance whose model has clusters, the planes that the instance
     * may cross, and as many entries as the model has faces. */
    fxl_order_entry *(*find_front)(const fxl_scene *scene, const fxl_instance *instance,
                                   const fxl_view *view, fxl_planes planes, fxl_order_entry *entry,
                                   uint32_t *outside);
};

/* Whether an eye lies in the cone of a cluster, so that it sees the front of no face. The eye is
 * relative to the instance's centre, and each coordinate is below 2^30. An eye near the cone's
 * border may count as outside: within 2^-13 world unit along the axis, or 2^-31 of the distance. */
bool fxl_cluster_is_turned_away(const fxl_cluster *cluster, const fxl_point *eye);

#endif

/* SPDX-License-Identifier: MIT */
/* The scene of tiny.h, whose sorted cube has three clusters. */
#ifndef CLUSTER_SCENE_H
#define CLUSTER_SCENE_H

#include "tiny.h"

enum {
    CLUSTERS = 3
};

typedef struct {
    tiny_scene *tiny;
    fxl_cluster clusters[CLUSTERS];
} cluster_scene;

/* The scene anew. Of the cube's faces (-x +x -y +y -z +z) cluster 0 has -x, with a cone; cluster 1
 * has +x and -y, with a cone of 45 degrees about (1, -1, 0); cluster 2 has the last three, which
 * have no cone, as +z and -z face away from each other. */
cluster_scene *cluster_make(void);

/* What the definition says of a cluster, and of a face, of the sorted cube. */
typedef struct {
    bool (*is_outside)(const cluster_scene *made, const fxl_view *view, const fxl_cluster *cluster);
    bool (*is_front)(const cluster_scene *made, const fxl_view *view, const fxl_face *face);
} cluster_definition;

/* Of the sorted cube's faces: how many lie in clusters that are outside, and how many of the others
 * do not face the eye. */
void cluster_count(const cluster_scene *scene, const cluster_definition *definition,
                   const fxl_view *view, uint32_t *outside, uint32_t *backfacing);

#endif

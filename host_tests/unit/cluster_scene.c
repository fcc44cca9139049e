/* SPDX-License-Identifier: MIT */
#include "cluster_scene.h"

static cluster_scene made;

cluster_scene *cluster_make(void)
{
    /* Half of sqrt(2), rounded up; cutoffs a little above the least that there are: 0 and 1/2. */
    const fxl_q2_30 diagonal = 759250125;
    made.tiny = tiny_make();
    /* sqrt(2) = 92681.9 / 65536 and sqrt(3) = 113511.7 / 65536. */
    made.clusters[0] = (fxl_cluster){.centre = {Q16(-1), 0, 0},
                                     .radius = 92682,
                                     .axis = {-FXL_Q2_30_ONE, 0, 0},
                                     .cutoff = 16,
                                     .apex = {Q16(-1), 0, 0},
                                     .face_count = 1};
    made.clusters[1] = (fxl_cluster){.radius = 113512,
                                     .axis = {diagonal, -diagonal, 0},
                                     .cutoff = 0x80000010u,
                                     .apex = {Q16(1), Q16(-1), 0},
                                     .face_count = 2};
    made.clusters[2] = (fxl_cluster){.radius = 113512, .face_count = 3};
    made.tiny->models[1].first_cluster = 1;
    made.tiny->scene.clusters = made.clusters;
    made.tiny->scene.cluster_count = CLUSTERS;
    return &made;
}

void cluster_count(const cluster_scene *scene, const cluster_definition *definition,
                   const fxl_view *view, uint32_t *outside, uint32_t *backfacing)
{
    uint32_t number = 6;
    *outside = *backfacing = 0;
    for (int c = 0; c < CLUSTERS; c++) {
        const fxl_cluster *cluster = &scene->clusters[c];
        const bool out = definition->is_outside(scene, view, cluster);
        for (uint32_t i = 0; i < cluster->face_count; i++, number++) {
            const fxl_face *face = &scene->tiny->faces[number];
            *outside += out;
            *backfacing += !out && !definition->is_front(scene, view, face);
        }
    }
}

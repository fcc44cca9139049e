/* SPDX-License-Identifier: MIT */
#include "bsp_scene.h"

/* Each face has a node of its own, and all else is behind it. */
bsp_scene *bsp_make(void)
{
    static bsp_scene made;
    made.tiny = tiny_make();
    fxl_scene *scene = &made.tiny->scene;
    for (uint32_t i = 0; i < BSP_NODES; i++) {
        fxl_bsp_node *node = &made.nodes[i];
        uint64_t distance = (uint64_t)FXL_Q2_30_ONE * 65536u;
        *node = (fxl_bsp_node){.normal = made.tiny->faces[6 + i].normal,
                               .distance_low = (uint32_t)distance,
                               .distance_high = (uint32_t)(distance >> 32),
                               .front = FXL_BSP_NONE,
                               .back = (uint16_t)(i + 1),
                               .parent = (uint16_t)(i - 1),
                               .first_face = (uint16_t)i,
                               .face_count = 1,
                               .radius = TINY_RADIUS};
    }
    made.nodes[0].parent = FXL_BSP_NONE;
    made.nodes[BSP_NODES - 1].back = FXL_BSP_NONE;
    for (uint32_t i = 0; i < TINY_INSTANCES; i++) {
        made.tiny->instances[i].layer = 0;
    }
    scene->bsp_nodes = made.nodes;
    scene->bsp_node_count = BSP_NODES;
    scene->bsp_instance = 1;
    return &made;
}

/* SPDX-License-Identifier: MIT */
/* The plane of a BSP node, and the side of it that a point is on. Internal. */
#ifndef FXL_BSP_NODE_H
#define FXL_BSP_NODE_H

#include "../math/arith.h"
#include "fixel/scene.h"

static inline fxl_q18_46 fxl_bsp_distance(const fxl_bsp_node *node)
{
    return fxl_signed_64((uint64_t)node->distance_high << 32 | node->distance_low);
}

/* Whether a point is in front of a node's plane. The point is relative to the centre of the BSP
 * instance; each coordinate is below 2^30. Exact: see fxl_dot. */
/* bsp 1.2 */
static inline bool fxl_bsp_is_front(const fxl_bsp_node *node, const fxl_point *point)
{
    return fxl_dot(&node->normal, point->x, point->y, point->z) > fxl_bsp_distance(node);
}

#endif

/* SPDX-License-Identifier: MIT */
/* What is asked of a tree's node. Internal. */
#ifndef FXL_TREE_NODE_H
#define FXL_TREE_NODE_H

#include "arith.h"
#include "fixel/scene.h"

static inline fxl_q18_46 fxl_tree_distance(const fxl_tree_node *node)
{
    return (int64_t)((uint64_t)node->distance_high << 32 | node->distance_low);
}

/* Whether a point, relative to the tree's object and below 2^30 in each coordinate,
 * is in front of a node's plane. Exact: see fxl_dot. */
static inline bool fxl_tree_is_front(const fxl_tree_node *node, const fxl_point *point)
{
    return fxl_dot(&node->normal, point->x, point->y, point->z) > fxl_tree_distance(node);
}

#endif

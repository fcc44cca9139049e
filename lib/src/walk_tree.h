/* SPDX-License-Identifier: MIT */
/* The walk by a tree, for the methods that have it. Internal. */
#ifndef FXL_WALK_TREE_H
#define FXL_WALK_TREE_H

#include "fixel/tree.h"

/* fxl_hidden.walk and .walk_room. */
bool fxl_walk_by_tree(const fxl_walk *on);
uint32_t fxl_tree_room_size(const fxl_scene *scene);

#endif

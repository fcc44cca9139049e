/* SPDX-License-Identifier: MIT */
#include "fixel/tree.h"

#include "walk_tree.h"

const fxl_hidden fxl_hidden_tree = {.front_to_back = false,
                                    .walk = fxl_walk_by_tree,
                                    .walk_room = fxl_tree_room_size,
                                    .painter = &fxl_painter_over};

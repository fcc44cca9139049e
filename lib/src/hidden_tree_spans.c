/* SPDX-License-Identifier: MIT */
#include "walk_tree.h"

const fxl_hidden fxl_hidden_tree_spans = {.front_to_back = true,
                                          .walk = fxl_walk_by_tree,
                                          .walk_room = fxl_tree_room_size,
                                          .painter = &fxl_painter_spans};

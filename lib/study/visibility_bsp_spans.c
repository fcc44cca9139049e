/* SPDX-License-Identifier: MIT */
#include "../order/bsp_pieces.h"
#include "fixel/order.h"
#include "methods.h"

const fxl_visibility fxl_visibility_bsp_spans = {.order = &fxl_by_tree,
                                                 .target = &fxl_palette_spans,
                                                 .front_to_back = true};

/* SPDX-License-Identifier: MIT */
#include "fixel/bsp.h"
#include "fixel/order.h"

#include "bsp_pieces.h"

const fxl_visibility fxl_visibility_bsp = {.order = &fxl_by_tree, .target = &fxl_palette};

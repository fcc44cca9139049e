/* SPDX-License-Identifier: MIT */
#include "fixel/bsp.h"
#include "fixel/order.h"

#include "submit_by_bsp.h"

const fxl_visibility fxl_visibility_bsp = {.order = &fxl_by_tree, .target = &fxl_palette};

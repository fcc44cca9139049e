/* SPDX-License-Identifier: MIT */
#include "fixel/order.h"

const fxl_visibility fxl_visibility_sorted = {.order = &fxl_by_distance, .target = &fxl_palette};

/* SPDX-License-Identifier: MIT */
#include "fixel/hidden.h"
#include "walk.h"

const fxl_hidden fxl_hidden_sorted = {
    .front_to_back = false, .walk = fxl_walk_by_distance, .painter = &fxl_painter_over};

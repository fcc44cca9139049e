/* SPDX-License-Identifier: MIT */
#include "fixel/stage/visibility.h"
#include "submit.h"

const fxl_visibility fxl_visibility_sorted = {
    .front_to_back = false, .submit = fxl_submit_by_distance, .backend = &fxl_raster_over};

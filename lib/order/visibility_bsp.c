/* SPDX-License-Identifier: MIT */
#include "fixel/bsp.h"

#include "submit_by_bsp.h"

const fxl_visibility fxl_visibility_bsp = {.front_to_back = false,
                                           .submit = fxl_submit_by_bsp,
                                           .submit_workspace_size = fxl_bsp_workspace_size,
                                           .backend = &fxl_raster_over};

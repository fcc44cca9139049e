/* SPDX-License-Identifier: MIT */
#include "../order/submit_by_bsp.h"
#include "methods.h"

const fxl_visibility fxl_visibility_bsp_spans = {.front_to_back = true,
                                                 .submit = fxl_submit_by_bsp,
                                                 .submit_workspace_size = fxl_bsp_workspace_size,
                                                 .backend = &fxl_raster_spans};

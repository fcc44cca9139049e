/* SPDX-License-Identifier: MIT */
/* Internal. lib/raster/edge_near_portable.h states what the function requires and returns. */
#ifndef FXL_EDGE_NEAR_H
#define FXL_EDGE_NEAR_H

#include "fixel/types.h"

bool fxl_edge_set_near(const fxl_screen_point *top, const fxl_screen_point *bottom, uint32_t last,
                       fxl_edge *edge);

#endif

/* SPDX-License-Identifier: MIT */
/* The traversal by a BSP. Internal. */
#ifndef FXL_SUBMIT_BY_BSP_H
#define FXL_SUBMIT_BY_BSP_H

#include "fixel/bsp.h"

/* fxl_order.submit and .memory_size of fxl_by_tree. */
bool fxl_submit_by_bsp(const fxl_traversal *on);
uint32_t fxl_bsp_workspace_size(const fxl_scene *scene);

#endif

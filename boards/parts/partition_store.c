/* SPDX-License-Identifier: MIT */
/* store.h for a partition of the flash, which the board's memory.ld places. */
#include "contract/store.h"

#include "parts/cortexm.h"

const void *store_scene(size_t *size)
{
    *size = (size_t)(uintptr_t)fxl_scene_size;
    return fxl_scene_base;
}

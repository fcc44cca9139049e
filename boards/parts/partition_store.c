/* SPDX-License-Identifier: MIT */
/* store.h as a partition of the flash, placed by the board's memory.ld. */
#include "contract/store.h"

#include "parts/cortexm.h"

const void *store_scene(size_t *size)
{
    *size = (size_t)(uintptr_t)fxl_scene_size;
    return fxl_scene_base;
}

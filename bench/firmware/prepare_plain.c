/* SPDX-License-Identifier: MIT */
/* For methods that need only their workspace. */
#include "combination.h"

void combination_prepare(fxl_renderer *renderer)
{
    (void)renderer;
}

uint32_t combination_memory(const fxl_renderer *renderer)
{
    (void)renderer;
    return 0;
}

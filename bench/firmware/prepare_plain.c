/* SPDX-License-Identifier: MIT */
/* What needs no more than its room. */
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

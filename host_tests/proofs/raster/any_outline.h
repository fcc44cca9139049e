/* SPDX-License-Identifier: MIT */
/* Any outline on the screen, for harnesses of lib/raster. */
#ifndef ANY_OUTLINE_H
#define ANY_OUTLINE_H

#include "fixel/types.h"
#include "proof.h"

static fxl_screen_point points[FXL_POLYGON_CAPACITY];

static uint32_t any_outline(void)
{
    const uint32_t count = nondet_u32();
    ASSUME(count >= 3 && count <= FXL_POLYGON_CAPACITY);
    ANY_CONTENT(points);
    for (uint32_t i = 0; i < FXL_POLYGON_CAPACITY; i++) {
        ASSUME(WITHIN(points[i].x, FXL_SCREEN_COORDINATE_MAX) && WITHIN(points[i].y, FXL_SCREEN_COORDINATE_MAX));
    }
    return count;
}

#endif

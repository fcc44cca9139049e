/* SPDX-License-Identifier: MIT */
/* Both sides under names of their own: core_ as this core's build has them,
 * portable_ as lib/kernels/portable has them. sides.c is compiled once for each;
 * what is not inline is renamed by equality.mk. */
#ifndef SIDES_H
#define SIDES_H

#include "fixel/project.h"

#define SIDES(side) \
    uint64_t side##multiply_u32(uint32_t a, uint32_t b); \
    int64_t side##multiply_s32(int32_t a, int32_t b); \
    int64_t side##multiply_s64(int64_t a, int64_t b); \
    unsigned side##leading_zeros(uint32_t value);

SIDES(core_)
SIDES(portable_)

fxl_status portable_project_seen(const fxl_projection *projection, const fxl_view_point *view,
                                 fxl_screen_point *screen);

#endif

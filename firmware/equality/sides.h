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
    int64_t side##multiply_s31(int32_t a, int32_t b); \
    int64_t side##multiply_su32(int32_t a, uint32_t b); \
    uint32_t side##divide_u32(uint32_t numerator, uint32_t denominator, uint32_t *rest); \
    uint32_t side##divide_half(uint32_t numerator, uint32_t denominator); \
    int64_t side##multiply_s64(int64_t a, int64_t b); \
    unsigned side##leading_zeros(uint32_t value);

SIDES(core_)
SIDES(portable_)

uint32_t portable_divide_u64(uint64_t numerator, uint32_t denominator, uint32_t *rest);
uint64_t portable_fraction(uint64_t part, uint64_t whole);
fxl_status portable_project_seen(const fxl_projection *projection, const fxl_view_point *view,
                                 fxl_screen_point *screen);

#endif

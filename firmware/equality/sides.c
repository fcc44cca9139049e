/* SPDX-License-Identifier: MIT */
/* The inline kernels as functions; SIDE is core_ or portable_. */
#include "sides.h"

#include "math/core.h"
#include "raster/edge_divide.h"
#include "view/cull.h"

#define JOIN(side, name)   side##name
#define EXPAND(side, name) JOIN(side, name)
#define NAME(name)         EXPAND(SIDE, name)

uint64_t NAME(multiply_u32)(uint32_t a, uint32_t b)
{
    return fxl_multiply_u32(a, b);
}

int64_t NAME(multiply_s32)(int32_t a, int32_t b)
{
    return fxl_multiply_s32(a, b);
}

int64_t NAME(multiply_s64)(int64_t a, int64_t b)
{
    return fxl_multiply_s64(a, b);
}

int64_t NAME(multiply_s64_u16)(int64_t a, uint32_t b)
{
    return fxl_multiply_s64_u16(a, b);
}

uint64_t NAME(multiply_high)(uint64_t a, uint64_t b)
{
    return fxl_multiply_high(a, b);
}

unsigned NAME(leading_zeros)(uint32_t value)
{
    return fxl_leading_zeros(value);
}

int64_t NAME(multiply_s31)(int32_t a, int32_t b)
{
    return fxl_multiply_s31(a, b);
}

int64_t NAME(multiply_su32)(int32_t a, uint32_t b)
{
    return fxl_multiply_su32(a, b);
}

uint32_t NAME(divide_u32)(uint32_t numerator, uint32_t denominator, uint32_t *rest)
{
    return fxl_divide_u32(numerator, denominator, rest);
}

uint32_t NAME(divide_half)(uint32_t numerator, uint32_t denominator)
{
    return fxl_divide_half(numerator, denominator);
}

uint32_t NAME(edge_height_max)(void)
{
    return FXL_EDGE_HEIGHT_MAX;
}

int32_t NAME(edge_dividend_max)(void)
{
    return FXL_EDGE_DIVIDEND_MAX;
}

/* Answers the divider's shift. */
unsigned NAME(edge_divide)(uint32_t height, int32_t dividend, int32_t *whole, uint32_t *fraction)
{
    fxl_edge_divider divider = fxl_edge_divider_of(height);
    fxl_edge_divide(&divider, dividend, whole, fraction);
    return fxl_edge_divider_shift(&divider);
}

bool NAME(dot_is_negative)(const fxl_direction *direction, const fxl_point *point)
{
    return fxl_dot_is_negative(direction, point->x, point->y, point->z);
}

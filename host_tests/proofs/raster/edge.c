/* SPDX-License-Identifier: MIT */
#include "raster/edge.h"
#include "proof.h"

void prove_edge_dividend(void)
{
    (void)fxl_edge_dividend(nondet_s32(), nondet_s32(), nondet_s32(), nondet_s32());
    PROOF_ENDS();
}

void prove_edge_first_pixel(void)
{
    fxl_screen_point *top, *bottom;
    uint32_t *error;
    (void)fxl_edge_first_pixel(top, bottom, nondet_s32(), error);
    PROOF_ENDS();
}

void prove_slope_set(void)
{
    fxl_screen_point *top, *bottom;
    fxl_slope *slope;
    fxl_slope_set(top, bottom, nondet_s32(), slope);
    PROOF_ENDS();
}

void prove_edge_advance(void)
{
    fxl_edge edge;
    const uint32_t rows = nondet_u32();
    ASSUME(rows <= FXL_SCREEN_MAX && WITHIN(edge.x, 1 << 20) && WITHIN(edge.step, 1 << 20));
    fxl_edge_advance(&edge, rows);
    PROOF_ENDS();
}

void prove_edge_divide(void)
{
    const uint32_t height = nondet_u32();
    const int32_t dividend = nondet_s32();
    ASSUME(height >= 1 && height <= FXL_EDGE_HEIGHT_MAX && WITHIN(dividend, FXL_EDGE_DIVIDEND_MAX));
    const fxl_edge_divider divider = fxl_edge_divider_of(height);
    int32_t whole;
    uint32_t fraction;
    fxl_edge_divide(&divider, dividend, &whole, &fraction);
    PROOF_ENDS();
}

void prove_edge_divider_shift(void)
{
    const uint32_t height = nondet_u32();
    ASSUME(height >= 1 && height <= FXL_EDGE_HEIGHT_MAX);
    const fxl_edge_divider divider = fxl_edge_divider_of(height);
    const unsigned shift = fxl_edge_divider_shift(&divider);
    ASSERT("the largest of them", shift <= 31 && (uint64_t)height << shift <= (uint64_t)1 << 32 &&
                                      (uint64_t)height << (shift + 1) >= (uint64_t)1 << 32);
    PROOF_ENDS();
}

void prove_edge_first_dividend(void)
{
    const int32_t start = nondet_s32(), dx = nondet_s32(), height = nondet_s32(), top_y = nondet_s32();
    ASSUME(WITHIN(dx, (FXL_SCREEN_MAX + 1) * 65536) && height > 0 && height <= FXL_EDGE_HEIGHT_MAX);
    ASSUME(WITHIN(top_y, FXL_SCREEN_COORDINATE_MAX));
    const int32_t dividend = fxl_edge_first_dividend(start, dx, height, top_y);
    ASSERT("in the range of a dividend", WITHIN(dividend, FXL_EDGE_DIVIDEND_MAX));
    PROOF_ENDS();
}

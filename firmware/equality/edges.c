/* SPDX-License-Identifier: MIT */

#include "raster/edge_divide.h"
#include "equality.h"
#include "sides.h"

static void compare(uint32_t height, int32_t dividend)
{
    int32_t core = 0, portable = 0;
    uint32_t core_fraction = 0, portable_fraction = 0;
    unsigned core_shift = core_edge_divide(height, dividend, &core, &core_fraction);
    unsigned portable_shift = portable_edge_divide(height, dividend, &portable, &portable_fraction);
    equality_case(core == portable && core_fraction == portable_fraction &&
                  core_shift == portable_shift);
}

/* Within the contract, whatever the numbers. */
static void compare_held(uint32_t height, uint32_t dividend)
{
    int32_t within = (int32_t)(dividend % (FXL_EDGE_DIVIDEND_MAX + 1u));
    height &= FXL_EDGE_HEIGHT_MAX;
    height += height == 0;
    compare(height, within);
    compare(height, -within);
}

static void boundaries(uint32_t height)
{
    uint32_t most = FXL_EDGE_DIVIDEND_MAX / height * height;
    compare_held(height, most);
    compare_held(height, most - 1);
    compare_held(height, FXL_EDGE_DIVIDEND_MAX);
    for (uint32_t i = 0; i < BOUNDARY_32_COUNT; i++) {
        compare_held(height, boundary_32(i));
    }
}

void test_edge_divide(uint32_t rounds)
{
    equality_case(core_edge_height_max() == portable_edge_height_max() &&
                  core_edge_dividend_max() == portable_edge_dividend_max());
    for (uint32_t i = 0; i < BOUNDARY_32_COUNT; i++) {
        uint32_t height = boundary_32(i);
        if (height >= 1 && height <= FXL_EDGE_HEIGHT_MAX) {
            boundaries(height);
        }
    }
    boundaries(FXL_EDGE_HEIGHT_MAX);
    /* Every reciprocal: the upper 16 bits of a height choose it, and the sides of each. */
    for (uint32_t upper = 0x8000; upper <= 0xFFFF; upper++) {
        compare_held(upper << 10, FXL_EDGE_DIVIDEND_MAX);
        compare_held((upper << 10) + 1023u, FXL_EDGE_DIVIDEND_MAX);
        compare_held(upper << 10, (upper << 10) - 1);
        compare_held((upper << 10) + 1023u, (upper << 10) + 1022u);
    }
    /* A third of them whole quotients, a third one less. */
    for (uint32_t i = 0; i < rounds; i++) {
        uint32_t height = (any_32() & FXL_EDGE_HEIGHT_MAX) >> (any_32() >> 7) % 26u;
        uint32_t dividend = any_32() >> 4 >> (any_32() >> 9) % 27u;
        height += height == 0;
        uint32_t whole = dividend % (FXL_EDGE_DIVIDEND_MAX + 1u) / height * height;
        compare_held(height, i % 3u == 0  ? dividend
                             : whole == 0 ? height - 1u
                                          : whole - i % 3u + 1u);
    }
}

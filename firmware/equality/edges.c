/* SPDX-License-Identifier: MIT */
#include "edges.h"

#include "equality.h"
#include "sides.h"

static void compare(uint32_t height, int32_t dividend)
{
    int32_t most = portable_edge_dividend_max();
    int32_t core_whole, portable_whole;
    uint32_t core_fraction, portable_fraction_bits;
    if (height == 0 || height > portable_edge_height_max()) {
        return;
    }
    dividend = dividend > most ? most : dividend < -most ? -most : dividend;
    unsigned core = core_edge_divide(height, dividend, &core_whole, &core_fraction);
    unsigned portable =
        portable_edge_divide(height, dividend, &portable_whole, &portable_fraction_bits);
    equality_case(core == portable && core_whole == portable_whole &&
                  core_fraction == portable_fraction_bits);
}

void test_edge_divide(uint32_t rounds)
{
    equality_case(core_edge_height_max() == portable_edge_height_max() &&
                  core_edge_dividend_max() == portable_edge_dividend_max());
    for (uint32_t i = 1; i < BOUNDARY_32_COUNT; i++) {
        for (uint32_t j = 0; j < BOUNDARY_32_COUNT; j++) {
            compare(boundary_32(i), (int32_t)boundary_32(j));
            compare(boundary_32(i), -(int32_t)(boundary_32(j) & 0x7FFFFFFFu));
        }
    }
    for (uint32_t i = 0; i < rounds; i++) {
        uint32_t height = any_32() >> (6u + (any_32() >> 7) % 26u);
        int32_t dividend = (int32_t)any_32() >> (4u + (any_32() >> 7) % 24u);
        /* One of four is a multiple, or beside one. */
        if ((any_32() & 0x300u) == 0 && height != 0) {
            dividend -= dividend % (int32_t)height - (int32_t)(any_32() % 3u) + 1;
        }
        compare(height, dividend);
    }
}

/* SPDX-License-Identifier: MIT */
/* Compares the matrix of an instance that is turned. */
#include "view/placement.h"

#include "equality.h"
#include "sides.h"

#include <string.h>

#define ENTRIES 9

/* An entry near a power of two, or 2^30 and a few bits, or any. */
static int32_t any_entry(void)
{
    const uint32_t choice = any_32();
    const int32_t any = (int32_t)(any_32() >> 1) - FXL_Q2_30_ONE;
    switch (choice & 3u) {
    case 0:
        return (choice & 4u ? 1 : -1) * (FXL_Q2_30_ONE + (int32_t)(choice >> 30));
    case 1:
        return any >> (choice >> 27);
    default:
        return any;
    }
}

/* Three entries of which no two are large: then a row and a column are at most 1 + 2^-28 long. */
static void any_row(int32_t row[3])
{
    const uint32_t large = any_32() % 3u;
    for (uint32_t i = 0; i < 3; i++) {
        row[i] = i == large ? any_entry() : any_entry() >> 16;
    }
}

/* A product is exactly a half, or nearly so, where its factors are powers of two. */
static void any_matrix(int32_t entries[ENTRIES])
{
    for (uint32_t i = 0; i < ENTRIES; i += 3) {
        any_row(&entries[i]);
    }
    if (any_32() & 1024u) {
        for (uint32_t i = 0; i < ENTRIES; i++) {
            entries[i] = entries[i] < 0 ? -(1 << any_32() % 15u) : 1 << any_32() % 15u;
        }
    }
}

void test_placement_rows(uint32_t rounds)
{
    for (uint32_t round = 0; round < rounds; round++) {
        int32_t entries[2][ENTRIES];
        fxl_axes view, core, portable;
        fxl_orientation of;
        any_matrix(entries[0]);
        any_matrix(entries[1]);
        memcpy(&view, entries[0], sizeof view);
        memcpy(&of, entries[1], sizeof of);
        fxl_placement_rows(&view, &of, &core);
        portable_placement_rows(&view, &of, &portable);
        equality_case(memcmp(&core, &portable, sizeof core) == 0);
    }
}

/* SPDX-License-Identifier: MIT */
/* The kernel that paints colours between those of corners. Any words are right: sums wrap. */

#include "equality.h"
#include "sides.h"

#define PIXELS 80u

static uint16_t by_core[PIXELS], by_portable[PIXELS];

void test_colour_runs(uint32_t rounds)
{
    for (uint32_t i = 0; i < rounds; i++) {
        const fxl_colour_words words = {any_32(), any_32(), any_32() >> (any_32() >> 27), any_32()};
        const uint32_t first = any_32() >> 29, count = 1u + (any_32() >> 8) % 70u;
        bool same = true;
        fxl_paint_colour_run(&words, by_core + first, count);
        portable_paint_colour_run(&words, by_portable + first, count);
        for (uint32_t k = 0; k < PIXELS; k++) {
            same &= by_core[k] == by_portable[k];
            by_core[k] = by_portable[k] = 0xA5A5;
        }
        equality_case(same);
    }
}

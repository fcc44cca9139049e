/* SPDX-License-Identifier: MIT */
/* The kernel that converts a row of pixels. Each side writes into memory of its own, all of which
 * must be equal. */

#include "equality.h"
#include "fixel/pixels.h"
#include "sides.h"

#define COUNT_MAX 96u
#define PAINTINGS 8u /* rounds for which the pixels stay */

static uint32_t pixel_words[COUNT_MAX / 4u + 2u];
static uint32_t by_core[COUNT_MAX / 2u + 4u], by_portable[COUNT_MAX / 2u + 4u];
static uint8_t *const pixels = (uint8_t *)pixel_words;
static uint16_t table[FXL_PALETTE_COLOURS];

static void compare(uint32_t count, uint32_t offset, uint32_t out_offset)
{
    fxl_row_to_16(pixels + offset, count, table, (uint16_t *)by_core + 2u + out_offset);
    portable_row_to_16(pixels + offset, count, table, (uint16_t *)by_portable + 2u + out_offset);
    bool same = true;
    for (uint32_t i = 0; i < COUNT_MAX / 2u + 4u; i++) {
        same &= by_core[i] == by_portable[i];
        by_core[i] = by_portable[i] = 0x5AA5A55Au;
    }
    equality_case(same);
}

/* Runs of `longest` pixels at most, of few colours, so that runs meet again. */
static void paint(uint32_t longest, uint32_t colours)
{
    for (uint32_t i = 0; i < sizeof pixel_words;) {
        const uint8_t colour = (uint8_t)((any_32() >> 9) % colours * 85u);
        for (uint32_t left = 1u + (any_32() >> 7) % longest; left > 0 && i < sizeof pixel_words;
             left--) {
            pixels[i++] = colour;
        }
    }
}

/* Every length at every alignment of both sides: one run, runs of words, and noise. */
static void boundaries(void)
{
    static const uint32_t longest[] = {COUNT_MAX, 40, 4, 1};
    for (uint32_t count = 0; count <= 70; count++) {
        for (uint32_t offset = 0; offset < 8; offset++) {
            for (uint32_t i = 0; i < sizeof longest / sizeof longest[0]; i++) {
                paint(longest[i], 3);
                compare(count, offset & 3u, offset >> 2);
            }
        }
    }
}

/* A block of 16 in which one pixel differs. */
static void one_pixel(void)
{
    for (uint32_t at = 0; at < 48; at++) {
        for (uint32_t i = 0; i < 48; i++) {
            pixels[i] = (uint8_t)(i == at ? 255 : 85);
        }
        compare(48, 0, 0);
    }
}

void test_row_to_16(uint32_t rounds)
{
    for (uint32_t i = 0; i < FXL_PALETTE_COLOURS; i++) {
        table[i] = (uint16_t)(any_32() >> 8);
    }
    boundaries();
    one_pixel();
    for (uint32_t i = 0; i < rounds; i++) {
        if (i % PAINTINGS == 0) {
            paint(1u + (any_32() >> 6) % 60u, 1u + (any_32() >> 8) % 255u);
        }
        compare((any_32() >> 5) % (COUNT_MAX + 1u), any_32() >> 11 & 3u, any_32() >> 13 & 1u);
    }
}

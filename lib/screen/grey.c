/* SPDX-License-Identifier: MIT */
#include "dither.h"
#include "fixel/pixels.h"

#define STEPS 128u /* parts of a level; the thresholds are the odd ones */

/* Rec. 709 in 256ths; they add up to 256, so white is 255. */
#define WEIGHT_RED   54u
#define WEIGHT_GREEN 183u
#define WEIGHT_BLUE  19u

/* 127 - 2 B of docs/formats.md. So a level is reached from its threshold 2 B + 1 on. */
#define T(b) (127u - 2u * (b))

static const uint8_t offsets[8][8] = {
    {T(0), T(32), T(8), T(40), T(2), T(34), T(10), T(42)},
    {T(48), T(16), T(56), T(24), T(50), T(18), T(58), T(26)},
    {T(12), T(44), T(4), T(36), T(14), T(46), T(6), T(38)},
    {T(60), T(28), T(52), T(20), T(62), T(30), T(54), T(22)},
    {T(3), T(35), T(11), T(43), T(1), T(33), T(9), T(41)},
    {T(51), T(19), T(59), T(27), T(49), T(17), T(57), T(25)},
    {T(15), T(47), T(7), T(39), T(13), T(45), T(5), T(37)},
    {T(63), T(31), T(55), T(23), T(61), T(29), T(53), T(21)},
};

/* formats 4.3 */
const uint8_t *fxl_dither_row(uint32_t y)
{
    return offsets[y & 7u];
}

/* formats 4.1 */
uint8_t fxl_luma(const uint8_t *colour)
{
    const uint32_t sum =
        WEIGHT_RED * colour[0] + WEIGHT_GREEN * colour[1] + WEIGHT_BLUE * colour[2];
    return (uint8_t)((sum + 128u) >> 8); /* <= 256 * 255 + 128 */
}

/* <= 255^2 * 128 before the division; at most 128 highest after it. Rounding down changes no level:
 * a threshold is an integer number of 128ths, and luma * highest * 128 / 255 is never an odd
 * integer. */
static uint32_t entry_of(const uint8_t *colour, uint32_t highest)
{
    return fxl_luma(colour) * highest * STEPS / 255u;
}

/* formats 4.2 */
void fxl_grey_table(uint16_t *table, const uint8_t *palette, uint32_t highest)
{
    for (uint32_t i = 0; i < FXL_PALETTE_COLOURS; i++) {
        table[i] = (uint16_t)entry_of(&palette[3u * i], highest);
    }
}

/* A channel as a byte, rounded to nearest: 255 c / 31 and 255 c / 63. A test computes all of them. */
/* pixels 1.2 */
uint16_t fxl_grey_of_rgb565(uint16_t colour, uint32_t highest)
{
    const uint32_t red = colour >> 11, green = colour >> 5 & 63u, blue = colour & 31u;
    const uint8_t bytes[3] = {(uint8_t)((red * 527u + 23u) >> 6),
                              (uint8_t)((green * 259u + 33u) >> 6),
                              (uint8_t)((blue * 527u + 23u) >> 6)};
    return (uint16_t)entry_of(bytes, highest);
}

/* formats 4.2 */
uint8_t fxl_grey_level(uint16_t entry, uint32_t x, uint32_t y)
{
    return (uint8_t)fxl_dithered(entry, fxl_dither_row(y), x);
}

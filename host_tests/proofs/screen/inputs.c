/* SPDX-License-Identifier: MIT */
/* Conversions of lib/screen, for every colour. */
#if OF_RGB332
#include "screen/rgb332.c"
#elif OF_RGB565
#include "screen/rgb565.c"
#else
#include "screen/grey.c"
#endif

#include "enumeration.h"

#define COLOURS (1u << 24) /* three bytes */

/* floor(numerator / denominator + 1/2). */
static inline uint32_t nearest(uint32_t numerator, uint32_t denominator)
{
    return (2 * numerator + denominator) / (2 * denominator);
}

#if OF_RGB332 || OF_RGB565

/* 256 colours from one on, which differ in their last byte. */
static inline void palette_from(uint32_t first, uint8_t *palette)
{
    for (uint32_t i = 0; i < FXL_PALETTE_COLOURS; i++) {
        palette[3 * i] = (uint8_t)(first >> 16);
        palette[3 * i + 1] = (uint8_t)(first >> 8);
        palette[3 * i + 2] = (uint8_t)i;
    }
}

#endif

#if OF_RGB332

/* [[row]]
 * id = "every colour as RGB332"
 * function = "prepare"
 * property = "it has the upper bits of each channel, for every colour of RGB565 and of 24 bits"
 * checks = 16842752
 * flags = ["-DOF_RGB332"]
 */
/* [[row]]
 * id = "every colour of RGB565 as RGB332"
 * function = "entry_of_rgb565"
 * property = "the same"
 * checks = 16842752
 * flags = ["-DOF_RGB332"]
 * every = true
 */
void enumerate_rgb332(void)
{
    for (uint32_t colour = 0; colour < 1u << 16; colour++) {
        const uint32_t red = colour >> 11, green = colour >> 5 & 63u, blue = colour & 31u;
        TRY(colour, entry_of_rgb565(colour) == (red / 4 << 5 | green / 8 << 2 | blue / 8));
    }
    for (uint32_t first = 0; first < COLOURS; first += FXL_PALETTE_COLOURS) {
        uint8_t palette[3 * FXL_PALETTE_COLOURS];
        uint16_t entries[FXL_PALETTE_COLOURS];
        palette_from(first, palette);
        prepare(entries, palette);
        for (uint32_t blue = 0; blue < FXL_PALETTE_COLOURS; blue++) {
            const uint32_t red = first >> 16, green = first >> 8 & 255u;
            TRY(first + blue, entries[blue] == (red / 32 << 5 | green / 32 << 2 | blue / 64));
        }
    }
}

#elif OF_RGB565

/* Links of the file that are not run. */
void fxl_row_to_16(const uint8_t *pixels, uint32_t count, const uint16_t *table, uint16_t *out)
{
    (void)pixels, (void)count, (void)table, (void)out;
    abort();
}

/* [[row]]
 * id = "every colour as RGB565"
 * function = "lib/screen/rgb565.c:prepare"
 * property = "it has the upper bits of each channel in the order of the bytes, for every colour of 24 bits"
 * checks = 16777216
 * flags = ["-DOF_RGB565"]
 */
void enumerate_rgb565(void)
{
    for (uint32_t first = 0; first < COLOURS; first += FXL_PALETTE_COLOURS) {
        uint8_t palette[3 * FXL_PALETTE_COLOURS];
        uint16_t high[FXL_PALETTE_COLOURS], low[FXL_PALETTE_COLOURS];
        palette_from(first, palette);
        prepare_high(high, palette);
        prepare_low(low, palette);
        for (uint32_t blue = 0; blue < FXL_PALETTE_COLOURS; blue++) {
            const uint32_t red = first >> 16, green = first >> 8 & 255u;
            const uint32_t wanted = red / 8 << 11 | green / 4 << 5 | blue / 8;
            const uint8_t *const a = (const uint8_t *)&high[blue], *const b =
                                                                       (const uint8_t *)&low[blue];
            TRY(first + blue,
                (uint32_t)(a[0] << 8 | a[1]) == wanted && (uint32_t)(b[1] << 8 | b[0]) == wanted);
        }
    }
}

#else

/* [[row]]
 * id = "every luma"
 * function = "lib/screen/grey.c:fxl_luma"
 * property = "it is the weighted mean, rounded to nearest, for every colour of 24 bits"
 * checks = 16777216
 * every = true
 */
void enumerate_luma(void)
{
    for (uint32_t colour = 0; colour < COLOURS; colour++) {
        const uint8_t bytes[3] = {(uint8_t)(colour >> 16), (uint8_t)(colour >> 8), (uint8_t)colour};
        TRY(colour,
            fxl_luma(bytes) == nearest(54u * bytes[0] + 183u * bytes[1] + 19u * bytes[2], 256));
    }
}

/* [[row]]
 * id = "every grey of RGB565"
 * function = "lib/screen/grey.c:fxl_grey_of_rgb565"
 * property = "channels are rounded to nearest bytes, and no level is lost by rounding down, for every colour and highest level"
 * checks = 16711680
 * every = true
 */
/* A level is reached where 128 entry is not below 255 thresholds, and thresholds are odd. */
void enumerate_grey_of_rgb565(void)
{
    for (uint32_t highest = 1; highest <= 255; highest++) {
        for (uint32_t colour = 0; colour < 1u << 16; colour++) {
            const uint32_t red = colour >> 11, green = colour >> 5 & 63u, blue = colour & 31u;
            const uint32_t sum = 54u * nearest(255 * red, 31) + 183u * nearest(255 * green, 63) +
                                 19u * nearest(255 * blue, 31);
            const uint32_t exact = nearest(sum, 256) * highest * 128u; /* in units of 1/255 */
            const uint32_t entry = fxl_grey_of_rgb565((uint16_t)colour, highest);
            TRY(colour, entry == exact / 255u && (exact % 255u != 0 || entry % 2 == 0));
        }
    }
}

#endif

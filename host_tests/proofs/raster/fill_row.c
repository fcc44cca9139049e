/* SPDX-License-Identifier: MIT */
#include "raster/fill_rgb565.c"
#include "raster/line_pixels.c"
#include "proof.h"

#define PIXELS 12
#define ROWS   3

/* [[row]]
 * function = "fxl_fill_row_rgb565"
 * property = "no other pixel is written, at any place of up to 12 pixels"
 * checks = 349
 */
void prove_fill_row_rgb565(void)
{
    static union {
        uint32_t aligned;
        uint16_t pixels[PIXELS];
    } memory;
    const uint32_t first = nondet_u32(), end = nondet_u32(), beside = nondet_u32();
    ANY_CONTENT(&memory);
    ASSUME(first <= end && end <= PIXELS);
    ASSUME(beside < PIXELS && (beside < first || beside >= end));
    uint16_t *row = memory.pixels;
    const uint16_t colour = nondet_u16(), kept = row[beside];
    fxl_fill_row_rgb565(row + first, row + end, colour);
    ASSERT("no other pixel", row[beside] == kept);
    ASSERT("the first and the last one", first == end || (row[first] == colour && row[end - 1] == colour));
    PROOF_ENDS();
}

/* [[row]]
 * function = "lib/raster/line_pixels.c:fxl_draw_line_pixels"
 * property = "a step in any state: the line stays within its pixel, and nothing is written out of bounds; bands of up to 3 rows of 12 pixels"
 * checks = 196
 */
void prove_draw_line_pixels(void)
{
    static uint8_t pixels[ROWS * PIXELS];
    fxl_band band;
    fxl_line_pixels line;
    const int32_t first = nondet_s32();
    ASSUME(line.pixel > 0 && line.pixel < (int64_t)1 << 61 && line.left >= 0 && line.left < line.pixel);
    ASSUME(WITHIN(line.step, line.pixel) && WITHIN(line.across, 1 << 20) && WITHIN(first, 1 << 20));
    ASSUME(band.width >= 1 && band.width <= PIXELS && band.stride >= band.width && band.stride <= PIXELS);
    ASSUME(band.rows >= 1 && band.rows <= ROWS && band.first_row + band.rows <= FXL_SCREEN_MAX);
    ASSUME(band.first_column == 0 && band.columns == 0);
    band.palette = NULL;
    band.pixels = pixels;
    const int32_t across = line.across;
    fxl_draw_line_pixels(&line, first, first + 1, nondet_u8(), &band);
    ASSERT("it stays within its pixel", line.left >= 0 && line.left < line.pixel);
    ASSERT("by a pixel at most", WITHIN(line.across - across, 1));
    PROOF_ENDS();
}

/* SPDX-License-Identifier: MIT */
/* Both sides fill the same trapezoid into memory of their own; every byte of it,
 * also those that belong to nobody, must then be the same. */
#include "fill.h"

#include "equality.h"
#include "fixel/fill.h"
#include "sides.h"

#define WIDTH_MAX 400u
#define ROWS_MAX  8u
#define WORDS     ((WIDTH_MAX + 8u) * (ROWS_MAX + 1u) / 4u)

static uint32_t by_core[WORDS], by_portable[WORDS];

/* The words of the rows, and one before and after. */
static void compare(const fxl_band *band, const fxl_trapezoid *trapezoid, uint32_t offset)
{
    fxl_band mine = *band, theirs = *band;
    uint32_t words = ((uint32_t)band->stride * band->rows + offset + 15u) / 4u;
    bool same = true;
    for (uint32_t i = 0; i < words; i++) {
        by_core[i] = by_portable[i] = 0xC3A5F096u;
    }
    mine.pixels = (uint8_t *)by_core + 4 + offset;
    theirs.pixels = (uint8_t *)by_portable + 4 + offset;
    uint8_t colour = (uint8_t)any_32();
    fxl_fill_trapezoid(&mine, trapezoid, colour);
    portable_fill_trapezoid(&theirs, trapezoid, colour);
    for (uint32_t i = 0; i < words; i++) {
        same &= by_core[i] == by_portable[i];
    }
    equality_case(same);
}

/* From one place of 0..width to another within 2^halvings rows. */
static void set_edge(uint32_t from, uint32_t from_fraction, uint32_t to, uint32_t halvings,
                     fxl_edge *edge)
{
    int64_t first = (int64_t)from << 32 | from_fraction, last = (int64_t)to << 32;
    int64_t step = (last - first) >> halvings;
    edge->x = (int32_t)from;
    edge->fraction = from_fraction;
    edge->step = (int32_t)(step >> 32);
    edge->step_fraction = (uint32_t)step;
}

static void any_trapezoid(uint32_t width, uint32_t rows, uint32_t offset)
{
    fxl_band band = {0};
    fxl_trapezoid trapezoid;
    band.width = (uint16_t)width;
    band.stride = (uint16_t)(width + (any_32() >> 8 & 7u));
    band.first_row = (uint16_t)(any_32() >> 12 & 63u);
    band.rows = (uint16_t)rows;
    trapezoid.first_row = (int16_t)(band.first_row + (any_32() >> 6) % rows);
    trapezoid.end_row = (int16_t)(band.first_row + rows);
    for (uint32_t i = 0; i < 2; i++) {
        uint32_t from = (any_32() >> 3) % (width + 1u), to = (any_32() >> 3) % (width + 1u);
        set_edge(from, from == width ? 0 : any_32(), to, 3, &trapezoid.edges[i]);
    }
    compare(&band, &trapezoid, offset);
}

/* Every span of a row of 80 pixels, however it begins beside a word. */
static void every_span(void)
{
    fxl_band band = {0};
    fxl_trapezoid trapezoid;
    band.width = 80;
    band.stride = 80;
    band.rows = 1;
    trapezoid.first_row = 0;
    trapezoid.end_row = 1;
    for (uint32_t x0 = 0; x0 <= 80; x0++) {
        for (uint32_t x1 = 0; x1 <= 80; x1++) {
            set_edge(x0, 0, x0, 0, &trapezoid.edges[0]);
            set_edge(x1, 0, x1, 0, &trapezoid.edges[1]);
            for (uint32_t offset = 0; offset < 4; offset++) {
                compare(&band, &trapezoid, offset);
            }
        }
    }
}

void test_fill(uint32_t rounds)
{
    every_span();
    for (uint32_t i = 0; i < rounds; i++) {
        uint32_t width = (i & 63u) == 0 ? WIDTH_MAX : 1u + (any_32() >> 5) % 72u;
        any_trapezoid(width, 1u + (any_32() >> 9) % ((i & 63u) == 0 ? ROWS_MAX : 3u),
                      any_32() & 3u);
    }
}

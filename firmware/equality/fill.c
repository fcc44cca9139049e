/* SPDX-License-Identifier: MIT */
/* The kernels of fill. Each side draws into memory of its own. All of that memory must be equal,
 * also what lies around the band. */
#include "raster/fill.h"

#include "equality.h"
#include "sides.h"

#define WIDTH_MAX FXL_SCREEN_MAX
#define ROWS_MAX  4
#define WORDS     (((WIDTH_MAX + 8) * ROWS_MAX * 2 + 16) / 4)

static uint32_t by_core[WORDS], by_portable[WORDS];

static bool is_wide; /* pixels are of 16 bits */

/* A band of width pixels, which begins `offset` pixels off a word; rows begin on
 * all offsets where the stride is odd. */
typedef struct {
    uint32_t width, stride, offset, rows;
} shape;

/* The band of a shape in the memory of a side. */
static fxl_band band_in(uint32_t *memory, const shape *of, uint32_t first_row)
{
    const fxl_band band = {.pixels = (uint8_t *)(memory + 1) + (of->offset << is_wide),
                           .width = (uint16_t)of->width,
                           .stride = (uint16_t)of->stride,
                           .first_row = (uint16_t)first_row,
                           .rows = (uint16_t)of->rows};
    return band;
}

/* Words that a band and what lies around it may have. */
static uint32_t words_of(const shape *of)
{
    return (8 + ((of->offset + of->stride * of->rows) << is_wide)) / 4 + 1;
}

/* Draws on both sides. Earlier drawing stays: it was equal. */
static void compare(const shape *of, const fxl_trapezoid *trapezoid)
{
    static uint16_t colour;
    const fxl_band core = band_in(by_core, of, 7), portable = band_in(by_portable, of, 7);
    colour = (uint16_t)(colour + 257);
    if (is_wide) {
        fxl_fill_trapezoid_rgb565(&core, trapezoid, colour);
        portable_fill_trapezoid_rgb565(&portable, trapezoid, colour);
    } else {
        fxl_fill_trapezoid(&core, trapezoid, (uint8_t)colour);
        portable_fill_trapezoid(&portable, trapezoid, (uint8_t)colour);
    }
    bool same = true;
    for (uint32_t i = 0; i < words_of(of); i++) {
        same &= by_core[i] == by_portable[i];
    }
    equality_case(same);
}

/* Rows that all are pixels x .. x + length - 1. */
static void compare_upright(const shape *of, uint32_t x, uint32_t length)
{
    const int32_t ends[] = {(int32_t)x, (int32_t)(x + length)};
    fxl_trapezoid trapezoid = {7, (int16_t)(7 + (int32_t)of->rows), {{0, 0, 0, 0}, {0, 0, 0, 0}}};
    for (uint32_t side = 0; side < 2; side++) {
        trapezoid.edges[side].x = ends[side];
        trapezoid.edges[1 - side].x = ends[1 - side];
        compare(of, &trapezoid);
        for (uint32_t i = 0; i < 2; i++) {
            trapezoid.edges[i].step_fraction = 1;
            trapezoid.edges[i].fraction = any_32() >> 1;
        }
        compare(of, &trapezoid);
        const int32_t swapped = trapezoid.edges[0].x;
        trapezoid.edges[0].x = trapezoid.edges[1].x;
        trapezoid.edges[1].x = swapped;
    }
    /* A carry on a late row, which makes it no upright one. */
    if (length >= 1) {
        trapezoid.edges[0] = (fxl_edge){ends[0], 0u - (any_32() >> 7) % 6u, 0, 1};
        trapezoid.edges[1] = (fxl_edge){ends[1] - 1, 0u - (any_32() >> 7) % 6u, 0, 1};
        compare(of, &trapezoid);
    }
}

/* Every length at every offset, up to several times what a kernel treats by itself. */
static void boundaries(void)
{
    for (uint32_t length = 0; length <= 200; length++) {
        for (uint32_t offset = 0; offset < 4; offset++) {
            for (uint32_t stride = 204; stride <= 207; stride++) {
                const shape narrow = {204, stride, offset, 3};
                compare_upright(&narrow, 0, length);
                compare_upright(&narrow, 3, length);
            }
        }
    }
    for (uint32_t length = WIDTH_MAX - 40; length <= WIDTH_MAX; length++) {
        for (uint32_t offset = 0; offset < 4; offset++) {
            const shape wide = {WIDTH_MAX, WIDTH_MAX + offset, offset, 2};
            compare_upright(&wide, 0, length);
            compare_upright(&wide, WIDTH_MAX - length, length);
        }
    }
}

/* An edge that stays within 0..width. */
static fxl_edge any_edge(const shape *of)
{
    uint32_t width = of->width, rows = of->rows;
    uint32_t from = any_32() % (width + 1u), to = any_32() % (width + 1u);
    int32_t step = ((int32_t)to - (int32_t)from) / (int32_t)rows;
    fxl_edge edge = {(int32_t)from, any_32(), step, any_32()};
    if (from + (uint32_t)((int32_t)(rows - 1u) * (step + 1)) >= width) {
        edge.step_fraction = 0;
        edge.fraction >>= any_32() & 7u;
    }
    return edge;
}

static void compare_fills(uint32_t rounds)
{
    boundaries();
    for (uint32_t i = 0; i < rounds; i++) {
        uint32_t length = 1u + (any_32() >> 5) % ((any_32() & 15u) == 0 ? 300u : 75u);
        const shape any = {length, length + (any_32() >> 9 & 7u), any_32() >> 11 & 3u,
                           1u + (any_32() >> 13 & 3u)};
        fxl_trapezoid trapezoid = {
            7, (int16_t)(7 + (int32_t)any.rows), {any_edge(&any), any_edge(&any)}};
        compare(&any, &trapezoid);
    }
}

void test_fill(uint32_t rounds)
{
    is_wide = false;
    compare_fills(rounds);
}

void test_fill_rgb565(uint32_t rounds)
{
    is_wide = true;
    compare_fills(rounds);
}

/* Within 0..end, or up to two pixels beside; on a centre or beside one every other time. */
static fxl_q16_16 any_place(uint32_t end)
{
    const uint32_t choice = any_32() >> 9 & 15u;
    int32_t place = (int32_t)((any_32() >> 2) % ((end << 16) + 1u));
    if (choice < 8) {
        place = (int32_t)(((uint32_t)place & 0xFFFF0000u) + 0x8000u) + (int32_t)(choice % 3u) - 1;
    } else if (choice == 8) {
        place = (int32_t)((any_32() & 1u) * (end << 16));
    } else if (choice == 9) {
        place += (int32_t)(any_32() >> 14) - (1 << 17);
    }
    return place;
}

/* Points in any order, so many outlines cross themselves, and go either way around. */
static void compare_outline(const shape *of, uint32_t first_row, uint32_t tall)
{
    static fxl_scan scan;
    fxl_screen_polygon outline = {.count = 0};
    outline.count = (uint8_t)((any_32() & 1u) != 0 ? 3u : 3u + (any_32() >> 11 & 3u));
    const int32_t top = (int32_t)(first_row << 16) - (int32_t)((any_32() >> 8) % (tall << 15));
    for (uint32_t i = 0; i < outline.count; i++) {
        outline.points[i].x = any_place(of->width);
        outline.points[i].y = top + any_place(tall);
    }
    const fxl_band core = band_in(by_core, of, first_row);
    const fxl_band portable = band_in(by_portable, of, first_row);
    const uint32_t colour = any_32() >> 7 & (is_wide ? 0xFFFFu : 0xFFu);
    const bool core_reaches = is_wide ? fxl_draw_outline_rgb565(&scan, &outline, &core, colour)
                                      : fxl_draw_outline(&scan, &outline, &core, colour);
    const bool portable_reaches =
        is_wide ? portable_draw_outline_rgb565(&scan, &outline, &portable, colour)
                : portable_draw_outline(&scan, &outline, &portable, colour);
    bool same = core_reaches == (FXL_IS_SMALL || portable_reaches);
    for (uint32_t i = 0; i < words_of(of); i++) {
        same &= by_core[i] == by_portable[i];
        by_core[i] = by_portable[i] = 0;
    }
    equality_case(same);
}

static void compare_outlines(uint32_t rounds)
{
    for (uint32_t i = 0; i < rounds; i++) {
        const uint32_t kind = any_32() >> 6 & 7u;
        const uint32_t rows = 1u + (any_32() >> 5) % (kind < 2 ? 4u : kind < 7 ? 25u : 800u);
        const uint32_t widest = kind < 4 ? 30u : rows < 4 ? 1000u : 4000u / rows - 3;
        const uint32_t width = 1u + (any_32() >> 8) % widest;
        const shape any = {width, width + (any_32() >> 9 & 3u), any_32() >> 11 & 3u, rows};
        const uint32_t first_row = (any_32() >> 8) % (FXL_SCREEN_MAX - rows + 1u);
        const uint32_t tall = (any_32() & 15u) == 0 ? 1020u : 1u + (any_32() >> 9) % (2 * rows);
        compare_outline(&any, (any_32() & 1u) != 0 ? 0 : first_row, tall > 1020 ? 1020 : tall);
    }
}

void test_draw_outline(uint32_t rounds)
{
    is_wide = false;
    compare_outlines(rounds);
}

void test_draw_outline_rgb565(uint32_t rounds)
{
    is_wide = true;
    compare_outlines(rounds);
}

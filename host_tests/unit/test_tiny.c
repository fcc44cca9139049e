/* SPDX-License-Identifier: MIT */
/* Tiny triangles against the scan: the same pixels, of either direction, on centres and beside
 * them, across the sides of a band. */
#include "raster/scan.h"
#include "raster/tiny.h"

#include "unit.h"

enum {
    WIDTH = 9,
    FIRST_ROW = 3,
    ROWS = 5,
    SIDE = 16
};

/* Within so many pixels of a corner; on the grid of half pixels, or beside it, every other time. */
static fxl_q16_16 any_place(int32_t corner, int32_t pixels)
{
    const int32_t place = corner + unit_between(0, pixels * 65536);
    return unit_random() & 1u ? place : (place & ~32767) + unit_between(-1, 1);
}

static uint32_t scanned(const fxl_screen_point *points, const fxl_band *band, bool seen[SIDE][SIDE])
{
    fxl_scan scan;
    fxl_span span;
    uint32_t count = 0;
    fxl_scan_outline(points, 3, band, &scan);
    while (fxl_scan_next(&scan, &span)) {
        for (int32_t x = span.x0; x < span.x1; x++) {
            seen[span.y][x] = true;
            count++;
        }
    }
    return count;
}

/* SPEC 5.2 */
void test_a_tiny_triangle_covers_what_the_scan_finds(void)
{
    uint32_t covered = 0, tiny_ones = 0, others = 0;
    for (int i = 0; i < 4 * UNIT_REPEAT; i++) {
        const fxl_band band = {
            .width = WIDTH, .stride = WIDTH, .first_row = FIRST_ROW, .rows = ROWS};
        const int32_t x = unit_between(-2 * 65536, (WIDTH + 1) * 65536),
                      y = unit_between(0, (FIRST_ROW + ROWS + 1) * 65536);
        const int32_t pixels = unit_between(1, 5);
        fxl_screen_point points[3];
        bool seen[SIDE][SIDE] = {{false}};
        fxl_tiny tiny;
        for (uint32_t k = 0; k < 3; k++) {
            points[k].x = any_place(x, pixels);
            points[k].y = any_place(y, pixels);
        }
        const uint32_t count = scanned(points, &band, seen);
        if (!fxl_tiny_find(points, &band, &tiny)) {
            others++;
            continue;
        }
        uint32_t found = 0;
        for (uint32_t bit = 0; bit < FXL_TINY_SIDE * FXL_TINY_SIDE; bit++) {
            if (tiny.pixels >> bit & 1u) {
                found++;
                TEST_ASSERT_TRUE(
                    seen[tiny.row + (int32_t)(bit / 4)][tiny.column + (int32_t)(bit % 4)]);
            }
        }
        TEST_ASSERT_EQUAL_UINT32(count, found);
        covered += count;
        tiny_ones++;
    }
    TEST_ASSERT_GREATER_THAN(UNIT_REPEAT, covered);
    TEST_ASSERT_GREATER_THAN(UNIT_REPEAT, tiny_ones);
    TEST_ASSERT_GREATER_THAN(0, others);
}

/* place fill-rule: pictures; columns of edges; corners on centres */
/* Two triangles that share an edge through centres cover each pixel of a square once. */
void test_tiny_triangles_that_share_an_edge_cover_each_pixel_once(void)
{
    const fxl_band band = {.width = WIDTH, .stride = WIDTH, .first_row = FIRST_ROW, .rows = ROWS};
    const int32_t left = 2 * 65536 + 32768, right = left + 4 * 65536, top = 4 * 65536 - 32768,
                  bottom = top + 4 * 65536;
    const fxl_screen_point upper[] = {{left, top}, {right, top}, {left, bottom}},
                           lower[] = {{right, top}, {right, bottom}, {left, bottom}};
    fxl_tiny first, second;
    TEST_ASSERT_TRUE(fxl_tiny_find(upper, &band, &first));
    TEST_ASSERT_TRUE(fxl_tiny_find(lower, &band, &second));
    TEST_ASSERT_EQUAL_INT(2, first.column);
    TEST_ASSERT_EQUAL_INT(3, first.row);
    TEST_ASSERT_EQUAL_HEX32(0x137F, first.pixels);
    TEST_ASSERT_EQUAL_HEX32(0xEC80, second.pixels);
}

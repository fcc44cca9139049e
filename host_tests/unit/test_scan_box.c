/* SPDX-License-Identifier: MIT */
/* The scan by the box against the edge walk. */
#include "picture.h"
#include "study/scan_box.h"
#include "raster/scan.h"
#include "unit.h"

/* The brute-force scan against the edge walk and against the definition. */

enum {
    SIZE = 40
};

static uint8_t canvas[2][SIZE][SIZE];

/* Marks what either way gives; spans are neither empty nor outside, and come in order. */
static void draw(const fxl_screen_polygon *polygon, const fxl_band *band, bool box)
{
    static fxl_scan scan;
    fxl_scan_box box_scan;
    fxl_span span;
    int last_row = -1, last_end = 0;
    if (box) {
        fxl_scan_box_begin(polygon->points, polygon->count, band, &box_scan);
    } else {
        TEST_ASSERT_EQUAL(FXL_OK, fxl_scan_begin(polygon, band, &scan));
    }
    while (box ? fxl_scan_box_next(&box_scan, &span) : fxl_scan_next(&scan, &span)) {
        TEST_ASSERT_TRUE(span.x0 < span.x1 && span.x0 >= 0 && span.x1 <= band->width);
        TEST_ASSERT_TRUE(span.y >= band->first_row && span.y < band->first_row + band->rows);
        TEST_ASSERT_TRUE(span.y > last_row || (span.y == last_row && span.x0 >= last_end));
        last_row = span.y;
        last_end = span.x1;
        memset(&canvas[box][span.y][span.x0], 1, (size_t)(span.x1 - span.x0));
    }
}

/* place fill-rule: pictures; columns of edges; corners on centres */
static fxl_q16_16 coordinate(uint32_t kind)
{
    switch (kind) {
    case 0: /* anywhere in range */
        return unit_between(-FXL_SCREEN_COORDINATE_MAX, FXL_SCREEN_COORDINATE_MAX);
    case 1: /* whole and half pixels: ties */
        return unit_between(-4, 2 * SIZE + 4) * 32768;
    case 2: /* next to a centre */
        return unit_between(-1, SIZE) * 65536 + 32768 + unit_between(-1, 1);
    default:
        return unit_between(-Q16(8), Q16(SIZE + 8));
    }
}

/* Any outline, convex or not, whole frame or band. */
void test_it_covers_the_same_pixels(void)
{
    int covered = 0;
    for (int i = 0; i < UNIT_REPEAT / 20; i++) {
        fxl_screen_polygon polygon = {.count = (uint8_t)unit_between(3, i % 4 ? 5 : 12)};
        fxl_band band = UNIT_BAND(&canvas[0][0][0], SIZE, 0, SIZE);
        band.width = (uint16_t)unit_between(1, SIZE);
        band.first_row = (uint16_t)unit_between(0, SIZE - 1);
        band.rows = (uint16_t)unit_between(1, SIZE - band.first_row);
        uint32_t kind = unit_random() % 4;
        for (int k = 0; k < polygon.count; k++) {
            polygon.points[k] = (fxl_screen_point){coordinate(kind), coordinate(kind)};
        }
        memset(canvas, 0, sizeof canvas);
        draw(&polygon, &band, false);
        draw(&polygon, &band, true);
        TEST_ASSERT_EQUAL_MEMORY(canvas[0], canvas[1], sizeof canvas[0]);
        covered += memchr(canvas[1], 1, sizeof canvas[1]) != NULL;
        int row = unit_between(band.first_row, band.first_row + band.rows - 1);
        int column = unit_between(0, band.width - 1);
        TEST_ASSERT_EQUAL(picture_winding(&polygon, column, row) != 0, canvas[1][row][column]);
    }
    TEST_ASSERT_TRUE(covered > UNIT_REPEAT / 100);
}

void test_far_outside_is_nothing(void)
{
    const int32_t end = FXL_SCREEN_COORDINATE_MAX;
    fxl_screen_polygon polygon = {.count = 3, .points = {{-end, -end}, {-end, end}, {-Q16(1), 0}}};
    fxl_band band = UNIT_BAND(&canvas[0][0][0], SIZE, 0, SIZE);
    fxl_scan_box scan;
    fxl_span span;
    fxl_scan_box_begin(polygon.points, polygon.count, &band, &scan);
    TEST_ASSERT_FALSE(fxl_scan_box_next(&scan, &span));
    TEST_ASSERT_FALSE(fxl_scan_box_next(&scan, &span));
}

/* The whole range around the screen: every pixel. */
void test_the_range_s_ends(void)
{
    const int32_t end = FXL_SCREEN_COORDINATE_MAX;
    fxl_screen_polygon polygon = {.count = 4,
                                  .points = {{-end, -end}, {end, -end}, {end, end}, {-end, end}}};
    fxl_band band = UNIT_BAND(&canvas[0][0][0], SIZE, 0, SIZE);
    memset(canvas, 0, sizeof canvas);
    draw(&polygon, &band, true);
    TEST_ASSERT_EACH_EQUAL_HEX8(1, canvas[1], sizeof canvas[1]);
}

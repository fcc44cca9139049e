/* SPDX-License-Identifier: MIT */
/* The other scans against the edge walk: by the box, and of tiny triangles. */
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

/* Tiny triangles against the scan: the same pixels, of either direction, on centres and beside
 * them, across the sides of a band. */

enum {
    WIDTH = 9,
    FIRST_ROW = 3,
    ROWS = 5,
    SEEN = 16
};

/* Within so many pixels of a corner; on the grid of half pixels, or beside it, every other time. */
static fxl_q16_16 any_place(int32_t corner, int32_t pixels)
{
    const int32_t place = corner + unit_between(0, pixels * 65536);
    return unit_random() & 1u ? place : (place & ~32767) + unit_between(-1, 1);
}

static uint32_t scanned(const fxl_screen_point *points, const fxl_band *band, bool seen[SEEN][SEEN])
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

/* How many pixels were found, all of which the scan has seen. */
static uint32_t count_of(const fxl_tiny *tiny, bool seen[SEEN][SEEN])
{
    uint32_t found = 0;
    for (uint32_t pixels = tiny->pixels, bit = 0; pixels != 0; pixels <<= 1, bit++) {
        if (pixels >> 31 != 0) {
            const uint32_t columns = (uint32_t)tiny->columns;
            TEST_ASSERT_LESS_THAN((uint32_t)tiny->rows, bit / columns);
            TEST_ASSERT_TRUE(
                seen[(uint32_t)tiny->row + bit / columns][(uint32_t)tiny->column + bit % columns]);
            found++;
        }
    }
    return found;
}

/* Lets a triangle go clockwise, but for one in eight. */
static void turn(fxl_screen_point *points)
{
    const int64_t area = (points[1].x - (int64_t)points[0].x) * (points[2].y - points[0].y) -
                         (points[1].y - (int64_t)points[0].y) * (points[2].x - points[0].x);
    if (area < 0 && unit_between(0, 7) != 0) {
        const fxl_screen_point second = points[1];
        points[1] = points[2];
        points[2] = second;
    }
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
        const int32_t pixels = unit_between(1, 4);
        fxl_screen_point points[3];
        bool seen[SEEN][SEEN] = {{false}};
        fxl_tiny tiny;
        for (uint32_t k = 0; k < 3; k++) {
            points[k].x = any_place(x, pixels);
            points[k].y = any_place(y, pixels);
        }
        turn(points);
        const uint32_t count = scanned(points, &band, seen);
        if (!fxl_tiny_find(points, &band, &tiny)) {
            others++;
            continue;
        }
        const uint32_t found = count_of(&tiny, seen);
        TEST_ASSERT_EQUAL_UINT32(count, found);
        covered += count;
        tiny_ones++;
    }
    TEST_ASSERT_GREATER_THAN(UNIT_REPEAT / 4, covered);
    TEST_ASSERT_GREATER_THAN(UNIT_REPEAT, tiny_ones);
    TEST_ASSERT_GREATER_THAN(0, others);
}

/* place fill-rule: pictures; columns of edges; corners on centres */
/* Two triangles that share an edge through centres cover each pixel of a square once. */
void test_tiny_triangles_that_share_an_edge_cover_each_pixel_once(void)
{
    const fxl_band band = {.width = WIDTH, .stride = WIDTH, .first_row = FIRST_ROW, .rows = ROWS};
    const int32_t left = 2 * 65536 + 32768, right = left + 2 * 65536, top = 4 * 65536 - 32768,
                  bottom = top + 2 * 65536;
    const fxl_screen_point upper[] = {{left, top}, {right, top}, {left, bottom}},
                           lower[] = {{right, top}, {right, bottom}, {left, bottom}};
    fxl_tiny first, second;
    TEST_ASSERT_TRUE(fxl_tiny_find(upper, &band, &first));
    TEST_ASSERT_TRUE(fxl_tiny_find(lower, &band, &second));
    TEST_ASSERT_EQUAL_INT(2, first.column);
    TEST_ASSERT_EQUAL_INT(3, first.row);
    TEST_ASSERT_EQUAL_HEX32(0xE0000000u, first.pixels);
    TEST_ASSERT_EQUAL_HEX32(0x10000000u, second.pixels);
}

/* SPEC 5.2 */
/* Of every box that fits a word: up to 8 columns and rows. */
void test_the_cover_of_a_small_triangle_is_what_the_scan_finds(void)
{
    const fxl_band band = {.width = SEEN, .stride = SEEN, .rows = SEEN};
    uint32_t covered = 0, others = 0;
    for (int i = 0; i < 4 * UNIT_REPEAT; i++) {
        const int32_t x = unit_between(0, 7 * 65536), y = unit_between(0, 7 * 65536);
        const int32_t columns = unit_between(1, 8), rows = unit_between(1, 8);
        fxl_screen_point points[3];
        bool seen[SEEN][SEEN] = {{false}};
        fxl_tiny tiny = {SEEN, SEEN, 0, 0, 0};
        int32_t right = 0, below = 0;
        for (uint32_t k = 0; k < 3; k++) {
            points[k].x = any_place(x, columns);
            points[k].y = any_place(y, rows);
            const int32_t column = (points[k].x + 32767) >> 16, row = (points[k].y + 32767) >> 16;
            tiny.column = column < tiny.column ? column : tiny.column;
            tiny.row = row < tiny.row ? row : tiny.row;
            right = column > right ? column : right;
            below = row > below ? row : below;
        }
        turn(points);
        tiny.columns = right - tiny.column;
        tiny.rows = below - tiny.row;
        const uint32_t count = scanned(points, &band, seen);
        const int32_t centres = tiny.columns * tiny.rows;
        if (centres == 0 || centres > FXL_TINY_CENTRES || tiny.columns > FXL_TINY_LONGEST ||
            tiny.rows > FXL_TINY_LONGEST || !fxl_tiny_cover(points, &tiny)) {
            others++;
            continue;
        }
        TEST_ASSERT_EQUAL_UINT32(count, count_of(&tiny, seen));
        covered += count;
    }
    TEST_ASSERT_GREATER_THAN(4 * UNIT_REPEAT, covered);
    TEST_ASSERT_LESS_THAN(3 * UNIT_REPEAT, others);
}

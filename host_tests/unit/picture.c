/* SPDX-License-Identifier: MIT */
#include "picture.h"

void picture_clear(picture *canvas, uint16_t width, uint16_t height)
{
    TEST_ASSERT_TRUE(width <= PICTURE_MAX && height <= PICTURE_MAX);
    canvas->width = width;
    canvas->height = height;
    memset(canvas->pixels, '.', sizeof canvas->pixels);
}

static void mock_fill(picture *canvas, const fxl_span *span, char ink)
{
    for (int x = span->x0; x < span->x1; x++) {
        TEST_ASSERT_EQUAL_MESSAGE('.', canvas->pixels[span->y][x], "a pixel drawn twice");
        canvas->pixels[span->y][x] = ink;
    }
}

void picture_add_band(picture *canvas, const fxl_screen_polygon *polygon, uint16_t first_row,
                      uint16_t rows, char ink)
{
    static uint8_t unused[PICTURE_MAX];
    fxl_band band = UNIT_BAND(unused, canvas->width, first_row, rows);
    fxl_scan scan;
    fxl_span span;
    int row = -1, end = 0;
    TEST_ASSERT_EQUAL(FXL_OK, fxl_scan_begin(polygon, &band, &scan));
    while (fxl_scan_next(&scan, &span)) {
        TEST_ASSERT_TRUE_MESSAGE(span.x0 < span.x1, "an empty span");
        TEST_ASSERT_TRUE_MESSAGE(span.x0 >= 0 && span.x1 <= canvas->width, "off the canvas");
        TEST_ASSERT_TRUE_MESSAGE(span.y >= first_row && span.y < first_row + rows, "off the band");
        TEST_ASSERT_TRUE_MESSAGE(span.y > row || (span.y == row && span.x0 >= end),
                                 "a span out of order");
        row = span.y;
        end = span.x1;
        mock_fill(canvas, &span, ink);
    }
}

void picture_add(picture *canvas, const fxl_screen_polygon *polygon, char ink)
{
    picture_add_band(canvas, polygon, 0, canvas->height, ink);
}

fxl_screen_polygon picture_polygon(const double *coordinates, uint8_t count)
{
    fxl_screen_polygon polygon = {.colour = 1, .count = count};
    for (int i = 0; i < count; i++) {
        polygon.points[i].x = (fxl_q16_16)(coordinates[2 * i] * 65536.0);
        polygon.points[i].y = (fxl_q16_16)(coordinates[2 * i + 1] * 65536.0);
    }
    return polygon;
}

/* UnityPrint would write a line's end as two characters. */
static void print_text(const char *text, int length)
{
    for (int i = 0; i < length; i++) {
        UNITY_OUTPUT_CHAR(text[i]);
    }
}

static void print_both(const picture *canvas, const char *const *rows)
{
    print_text("\nexpected, actual:\n", 19);
    for (int y = 0; y < canvas->height; y++) {
        print_text(rows[y], canvas->width);
        print_text("   ", 3);
        print_text(canvas->pixels[y], canvas->width);
        print_text("\n", 1);
    }
}

void picture_expect(const picture *canvas, const char *const *rows)
{
    for (int y = 0; y < canvas->height; y++) {
        TEST_ASSERT_EQUAL_MESSAGE(canvas->width, strlen(rows[y]), "a row of the wrong length");
        if (memcmp(rows[y], canvas->pixels[y], canvas->width) != 0) {
            print_both(canvas, rows);
            TEST_FAIL_MESSAGE("another picture than expected");
        }
    }
}

void picture_check(const double *points, uint8_t count, const char *const *rows)
{
    picture canvas;
    uint16_t height = 0;
    while (rows[height]) {
        height++;
    }
    picture_clear(&canvas, (uint16_t)strlen(rows[0]), height);
    fxl_screen_polygon polygon = picture_polygon(points, count);
    picture_add(&canvas, &polygon, '#');
    picture_expect(&canvas, rows);
}

/* place fill-rule: definition: picture_winding */
int32_t picture_winding(const fxl_screen_polygon *polygon, int32_t column, int32_t row)
{
    int64_t cx = (int64_t)column * 65536 + 32768, cy = (int64_t)row * 65536 + 32768;
    int32_t winding = 0;
    for (int i = 0; i < polygon->count; i++) {
        fxl_screen_point a = polygon->points[i];
        fxl_screen_point b = polygon->points[(i + 1) % polygon->count];
        int64_t height = (int64_t)b.y - a.y;
        int64_t side = (cy - a.y) * ((int64_t)b.x - a.x) - (cx - a.x) * height;
        if (a.y <= cy && cy < b.y && side <= 0) {
            winding++;
        }
        if (b.y <= cy && cy < a.y && side >= 0) {
            winding--;
        }
    }
    return winding;
}

/* SPDX-License-Identifier: MIT */
/* Scanning between two chains: the same pixels as the walk of every crossing,
 * which test_scan.c holds against the definition. */
#include "raster/edge.h"
#include "raster/scan.h"
#include "unit.h"

/* A height: any, or next to a power of two. */
static int32_t any_height(void)
{
    const int32_t highest = FXL_EDGE_HEIGHT_MAX;
    int32_t height = 1 << unit_between(0, 25);
    switch (unit_random() % 4) {
    case 0:
        return unit_between(1, highest);
    case 1:
        return highest - unit_between(0, 2);
    case 2:
        return height > 2 ? height + unit_between(-2, 2) : height;
    default:
        return unit_between(1, height);
    }
}

/* Of 0..height - 1: any, or an end. */
static uint32_t any_error(int32_t height)
{
    switch (unit_random() % 4) {
    case 0:
        return (uint32_t)height - 1;
    case 1:
        return 0;
    default:
        return (uint32_t)unit_between(0, height - 1);
    }
}

/* Errors that make the quotient on row k whole, or miss that by the least. */
static void set_errors(fxl_slope *slope, int32_t good)
{
    int32_t height = (int32_t)slope->height;
    slope->error_step = any_error(height);
    slope->error = any_error(height);
    if (unit_random() % 2) {
        uint64_t k = (uint64_t)unit_between(1, good);
        uint64_t rest = k * slope->error_step % slope->height;
        uint64_t error = slope->height - rest + (unit_random() % 3) + slope->height - 1;
        slope->error = (uint32_t)(error % slope->height);
    }
}

/* place fill-rule: pictures; columns of edges; corners on centres */
/* The bits that every kernel must have, by their definition. */
static void expect_quotient(uint32_t height, int32_t dividend)
{
    fxl_edge_divider divider = fxl_edge_divider_of(height);
    int32_t whole;
    uint32_t fraction;
    fxl_edge_divide(&divider, dividend, &whole, &fraction);
    int64_t quotient = (int64_t)((uint64_t)(int64_t)whole << 32 | fraction);
    int64_t left = (int64_t)dividend * 4294967296 - (quotient - 1) * (int64_t)height;
    TEST_ASSERT_TRUE(left >= 0 && left < (int64_t)height);
    unsigned shift = fxl_edge_divider_shift(&divider);
    TEST_ASSERT_TRUE((uint64_t)height << shift < 4294967296u);
    TEST_ASSERT_TRUE((uint64_t)height << (shift + 1) >= 4294967296u);
}

void test_a_quotient_is_the_next_above(void)
{
    for (int i = 0; i < UNIT_REPEAT; i++) {
        uint32_t height = (uint32_t)any_height();
        int32_t most = FXL_EDGE_DIVIDEND_MAX / (int32_t)height;
        int32_t whole = unit_between(-most, most) * (int32_t)height;
        const int32_t dividends[] = {0,
                                     1,
                                     -1,
                                     whole,
                                     whole - (whole > 0),
                                     whole + (whole < 0),
                                     FXL_EDGE_DIVIDEND_MAX,
                                     -FXL_EDGE_DIVIDEND_MAX,
                                     unit_between(-FXL_EDGE_DIVIDEND_MAX, FXL_EDGE_DIVIDEND_MAX)};
        for (size_t j = 0; j < sizeof dividends / sizeof dividends[0]; j++) {
            expect_quotient(height, dividends[j]);
        }
    }
}

/* SPEC 5.3a */
void test_an_edge_is_exact_while_it_is_good(void)
{
    for (int i = 0; i < UNIT_REPEAT; i++) {
        fxl_slope slope = {.height = (uint32_t)any_height()};
        fxl_edge_divider divider = fxl_edge_divider_of(slope.height);
        int32_t good = (int32_t)(1u << fxl_edge_divider_shift(&divider) & 0x7FFFFFFF);
        good = good == 0 || good > 1024 ? 1024 : good;
        fxl_edge edge;
        set_errors(&slope, good);
        fxl_edge_divide(&divider, (int32_t)slope.error, &edge.x, &edge.fraction);
        fxl_edge_divide(&divider, (int32_t)slope.error_step, &edge.step, &edge.step_fraction);
        int32_t rows[] = {0, 1, good / 2, good - 1, unit_between(0, good - 1)};
        for (size_t j = 0; j < sizeof rows / sizeof rows[0]; j++) {
            uint64_t k = (uint64_t)(uint32_t)rows[j] % (uint64_t)(uint32_t)good;
            uint64_t fraction = edge.fraction + k * edge.step_fraction;
            uint64_t error = slope.error + k * slope.error_step;
            TEST_ASSERT_EQUAL_UINT32(error / slope.height, fraction >> 32);
        }
    }
}

static int64_t floor_of(int64_t numerator, int64_t denominator)
{
    return numerator / denominator - (numerator % denominator < 0);
}

/* On every row that an edge crosses, set there or stepped from its first row: the first pixel by
 * its definition, ceil(x - 1/2). Heights and widths are often whole pixels, so that a carry leaves
 * nothing over. */
/* SPEC 5.3a */
void test_an_edge_is_set_and_steps_to_where_it_is(void)
{
    for (int i = 0; i < UNIT_REPEAT; i++) {
        const int32_t unit = unit_random() % 2 ? 1 : 32768;
        const int32_t most = unit_random() % 4 ? Q16(8) : FXL_SCREEN_COORDINATE_MAX;
        fxl_screen_point top = {unit_between(-most / unit, most / unit) * unit,
                                unit_between(-most / unit, most / unit) * unit};
        fxl_screen_point bottom = {unit_between(-most / unit, most / unit) * unit,
                                   unit_between(top.y / unit, most / unit) * unit};
        const int64_t dx = bottom.x - top.x, height = bottom.y - top.y;
        int32_t end = fxl_first_centre_from(bottom.y), row = fxl_first_centre_from(top.y);
        fxl_slope slope, stepped = {0};
        for (int32_t first = row; row < end && row < first + 40; row++) {
            const int32_t y = fxl_centre_of(row);
            const int64_t sum = (top.x - 32768) * height + dx * (y - top.y);
            fxl_slope_set(&top, &bottom, y, &slope);
            TEST_ASSERT_EQUAL_INT64(floor_of(sum - 1, 65536 * height) + 1, slope.x);
            if (row == first) {
                stepped = slope;
            } else {
                stepped.error += stepped.error_step;
                stepped.x += stepped.step + (stepped.error >= stepped.height);
                stepped.error -= stepped.error >= stepped.height ? stepped.height : 0;
            }
            TEST_ASSERT_EQUAL_INT32(slope.x, stepped.x);
            TEST_ASSERT_EQUAL_UINT32(slope.error, stepped.error);
        }
    }
}

/* An edge is set at its first row where it holds down to the last, or is left alone. There, and
 * wherever it is set, its first pixel is ceil(x - 1/2). */
void test_an_edge_is_set_where_it_holds(void)
{
    uint32_t set = 0;
    for (int i = 0; i < UNIT_REPEAT; i++) {
        const uint32_t height = (uint32_t)unit_between(65536, FXL_EDGE_HEIGHT_MAX);
        const fxl_screen_point top = {unit_between(-Q16(9), Q16(9)), unit_between(0, Q16(2))};
        const fxl_screen_point bottom = {top.x + unit_between(-Q16(90), Q16(90)),
                                         top.y + (int32_t)height};
        const uint32_t surely = (uint32_t)((UINT64_C(1) << 31) / height);
        const uint32_t lasts[] = {1, 63, surely - 1, 2 * surely + 2, 1023};
        for (size_t k = 0; k < sizeof lasts / sizeof lasts[0]; k++) {
            const uint32_t last = lasts[k];
            const fxl_edge before = {1, 2, 3, 4};
            fxl_edge edge = before;
            if (!fxl_edge_set_near(&top, &bottom, last, &edge)) {
                TEST_ASSERT_GREATER_OR_EQUAL_UINT32(surely, last);
                TEST_ASSERT_EQUAL_MEMORY(&before, &edge, sizeof edge);
                continue;
            }
            set++;
            TEST_ASSERT_LESS_OR_EQUAL_UINT32(2 * surely + 1, last);
            const uint32_t row = last < height >> 16 ? last : (height >> 16) - 1;
            const int64_t y = fxl_centre_of(fxl_first_centre_from(top.y) + (int32_t)row);
            const int64_t sum =
                (int64_t)(top.x - 32768) * height + (bottom.x - top.x) * (y - top.y);
            fxl_edge_advance(&edge, row);
            TEST_ASSERT_EQUAL_INT64(floor_of(sum - 1, 65536 * (int64_t)height) + 1, edge.x);
        }
    }
    TEST_ASSERT_GREATER_THAN(UNIT_REPEAT, set);
}

/* Upright edges through centres: the fraction on each row misses the next pixel by
 * the least, and an edge walked for more rows than it is good for reaches it. */
void test_upright_edges_stay_where_they_are(void)
{
    fxl_screen_polygon polygon = {.count = 4,
                                  .points = {{Q16(10.5), -Q16(2)},
                                             {Q16(14.5), -Q16(2)},
                                             {Q16(14.5), Q16(1000.25)},
                                             {Q16(10.5), Q16(1000.25)}}};
    uint8_t pixel = 0; /* scan writes none */
    fxl_band band = {.pixels = &pixel, .width = 20, .stride = 20, .first_row = 0, .rows = 1000};
    fxl_scan scan;
    fxl_span span;
    int32_t rows = 0;
    TEST_ASSERT_EQUAL(FXL_OK, fxl_scan_begin(&polygon, &band, &scan));
    while (fxl_scan_next(&scan, &span)) {
        TEST_ASSERT_EQUAL_INT32(rows++, span.y);
        TEST_ASSERT_EQUAL_INT32(10, span.x0);
        TEST_ASSERT_EQUAL_INT32(14, span.x1);
    }
    TEST_ASSERT_EQUAL_INT32(1000, rows);
}

static int32_t compare(fxl_q16_16 a, fxl_q16_16 b)
{
    return (a > b) - (a < b);
}

static void sort_by_y(fxl_screen_point *points, int count, int32_t order)
{
    for (int i = 1; i < count; i++) {
        for (int j = i; j > 0 && compare(points[j - 1].y, points[j].y) == order; j--) {
            fxl_screen_point swap = points[j];
            points[j] = points[j - 1];
            points[j - 1] = swap;
        }
    }
}

/* Down one chain and up the other, either way round, beginning anywhere. */
static void two_chains(fxl_screen_polygon *polygon, int32_t width, int32_t top, int32_t bottom)
{
    fxl_screen_point points[FXL_POLYGON_CAPACITY];
    int count = unit_random() % 4 ? unit_between(3, 6) : unit_between(3, FXL_POLYGON_CAPACITY);
    int down = unit_between(1, count - 1);
    int first = unit_between(0, count - 1);
    bool on_centres = unit_random() % 4 == 0;
    for (int i = 0; i < count; i++) {
        points[i].x = unit_between(-32767, width * 65536 + 32768);
        points[i].y = unit_between(top, bottom);
        if (on_centres) {
            points[i].y = (points[i].y & ~65535) + 32768;
        }
    }
    sort_by_y(points, down, 1);
    sort_by_y(points + down, count - down, -1);
    polygon->colour = 1;
    polygon->count = (uint8_t)count;
    for (int i = 0; i < count; i++) {
        polygon->points[(i + first) % count] = points[i];
    }
}

/* The next trapezoid's rows as spans, by their definition. */
static bool next_of_trapezoids(fxl_scan *scan, const fxl_trapezoid **trapezoid, int32_t *row,
                               fxl_span *span)
{
    for (;;) {
        if (*trapezoid == NULL || *row == (*trapezoid)->end_row) {
            *trapezoid = fxl_scan_next_trapezoid(scan);
            if (*trapezoid == NULL) {
                return false;
            }
            *row = (*trapezoid)->first_row;
        }
        int32_t x[2];
        for (int side = 0; side < 2; side++) {
            const fxl_edge *edge = &(*trapezoid)->edges[side];
            uint32_t rows = (uint32_t)(*row - (*trapezoid)->first_row);
            uint64_t fraction = edge->fraction + (uint64_t)edge->step_fraction * rows;
            x[side] = edge->x + edge->step * (int32_t)rows + (int32_t)(fraction >> 32);
        }
        *row += 1;
        if (x[0] != x[1]) {
            span->y = (int16_t)(*row - 1);
            span->x0 = (int16_t)(x[0] < x[1] ? x[0] : x[1]);
            span->x1 = (int16_t)(x[0] < x[1] ? x[1] : x[0]);
            return true;
        }
    }
}

static void expect_same_span(const fxl_span *expected, const fxl_span *actual)
{
    TEST_ASSERT_EQUAL(expected->y, actual->y);
    TEST_ASSERT_EQUAL(expected->x0, actual->x0);
    TEST_ASSERT_EQUAL(expected->x1, actual->x1);
}

/* Spans and trapezoids of a polygon against the walk of every crossing. */
static void check_polygon(const fxl_screen_polygon *polygon, const fxl_band *band, bool by_chains)
{
    static fxl_scan spans, trapezoids;
    static fxl_active_edges crossings;
    const fxl_trapezoid *trapezoid = NULL;
    int32_t row = 0;
    fxl_span expected, span;
    TEST_ASSERT_EQUAL(FXL_OK, fxl_scan_begin(polygon, band, &spans));
    TEST_ASSERT_EQUAL(FXL_OK, fxl_scan_begin(polygon, band, &trapezoids));
    if (by_chains && FXL_SCANS_BY_CHAINS) {
        TEST_ASSERT_TRUE_MESSAGE(spans.by_chains, "the quick way was not taken");
    }
    fxl_active_edges_begin(&crossings, polygon->points, polygon->count, spans.outline_first,
                           spans.outline_end, band);
    while (fxl_active_edges_next(&crossings, &expected)) {
        TEST_ASSERT_TRUE(fxl_scan_next(&spans, &span));
        expect_same_span(&expected, &span);
        TEST_ASSERT_TRUE(next_of_trapezoids(&trapezoids, &trapezoid, &row, &span));
        expect_same_span(&expected, &span);
    }
    TEST_ASSERT_FALSE(fxl_scan_next(&spans, &span));
    TEST_ASSERT_FALSE(next_of_trapezoids(&trapezoids, &trapezoid, &row, &span));
}

static fxl_band any_band(int32_t width)
{
    static uint8_t unused[FXL_SCREEN_MAX];
    fxl_band band = UNIT_BAND(unused, (uint16_t)width, 0, 0);
    band.first_row = (uint16_t)(unit_random() % 2 ? 0 : unit_between(0, FXL_SCREEN_MAX - 1));
    band.rows = (uint16_t)unit_between(1, FXL_SCREEN_MAX - band.first_row);
    return band;
}

void test_small_polygons(void)
{
    fxl_screen_polygon polygon;
    for (int i = 0; i < UNIT_REPEAT; i++) {
        int32_t width = unit_between(1, 40), top = unit_between(0, 30 * 65536);
        fxl_band band = any_band(width);
        band.first_row = (uint16_t)unit_between(0, 8);
        band.rows = (uint16_t)unit_between(1, 40);
        two_chains(&polygon, width, top, unit_between(top, 40 * 65536));
        check_polygon(&polygon, &band, true);
    }
}

/* Up to the range's ends: edges that are good for a few rows only. */
void test_tall_polygons(void)
{
    fxl_screen_polygon polygon;
    for (int i = 0; i < UNIT_REPEAT / 50 + 20; i++) {
        int32_t width = unit_random() % 2 ? FXL_SCREEN_MAX : unit_between(1, FXL_SCREEN_MAX);
        bool highest = unit_random() % 2;
        int32_t top = highest ? -FXL_SCREEN_COORDINATE_MAX : unit_between(-Q16(200), Q16(800));
        int32_t bottom = highest ? FXL_SCREEN_COORDINATE_MAX : unit_between(top, Q16(800));
        fxl_band band = any_band(width);
        two_chains(&polygon, width, top, bottom);
        check_polygon(&polygon, &band, !highest);
    }
}

/* Corners on centres: many edges pass through centres, and many begin and end on one row. */
void test_polygons_through_centres(void)
{
    fxl_screen_polygon polygon;
    for (int i = 0; i < UNIT_REPEAT; i++) {
        fxl_band band = any_band(12);
        band.first_row = (uint16_t)unit_between(0, 4);
        band.rows = (uint16_t)unit_between(1, 12);
        two_chains(&polygon, band.width, 0, Q16(12));
        for (int j = 0; j < polygon.count; j++) {
            polygon.points[j].x = (polygon.points[j].x & ~65535) + 32768;
            polygon.points[j].y = (polygon.points[j].y & ~65535) + 32768;
        }
        check_polygon(&polygon, &band, false);
    }
}

/* An edge that misses a centre of its second row by the least: there a step's carry leaves nothing
 * over. */
void test_an_edge_that_just_misses_a_centre(void)
{
    for (int i = 0; i < UNIT_REPEAT; i++) {
        const int32_t rows = unit_between(2, 12);
        const fxl_screen_point top = {unit_between(Q16(16), Q16(32)), Q16(2.5)};
        const int32_t part = (top.x - 32768) & 65535;
        const int32_t dx = 1 - part * rows + unit_between(0, 1) * 65536 * rows;
        const fxl_screen_polygon polygon = {
            .count = 3,
            .points = {top, {Q16(46), top.y + Q16(rows) / 2}, {top.x + dx, top.y + Q16(rows)}}};
        fxl_band band = any_band(48);
        band.first_row = 0;
        band.rows = 16;
        check_polygon(&polygon, &band, true);
    }
}

/* What is not within the sides, or goes up and down, takes the other way. */
/* SPEC 5.3c */
void test_any_polygon(void)
{
    fxl_screen_polygon polygon;
    for (int i = 0; i < UNIT_REPEAT / 5; i++) {
        int32_t width = unit_between(1, 64);
        fxl_band band = any_band(width);
        band.first_row = (uint16_t)unit_between(0, 20);
        band.rows = (uint16_t)unit_between(1, 40);
        two_chains(&polygon, width, -Q16(20), Q16(60));
        int vertex = unit_between(0, polygon.count - 1);
        polygon.points[vertex].y += unit_random() % 2 ? unit_between(-2, 2) : Q16(5);
        polygon.points[vertex].x += unit_random() % 2 ? unit_between(-2, 2) : Q16(15);
        check_polygon(&polygon, &band, false);
    }
}

void test_the_sides_of_the_band_are_where_they_are_said_to_be(void)
{
    fxl_screen_polygon polygon = {
        .count = 3, .points = {{-32767, 0}, {Q16(8) + 32768, Q16(4)}, {Q16(4), Q16(8)}}};
    fxl_band band = any_band(8);
    fxl_scan scan;
    band.first_row = 0;
    band.rows = 8;
    check_polygon(&polygon, &band, true);
    polygon.points[0].x -= 1;
    TEST_ASSERT_EQUAL(FXL_OK, fxl_scan_begin(&polygon, &band, &scan));
    TEST_ASSERT_FALSE(scan.by_chains);
    check_polygon(&polygon, &band, false);
    polygon.points[0].x += 1;
    polygon.points[1].x += 1;
    TEST_ASSERT_EQUAL(FXL_OK, fxl_scan_begin(&polygon, &band, &scan));
    TEST_ASSERT_FALSE(scan.by_chains);
    check_polygon(&polygon, &band, false);
}

/* Every vertex of an outline must be in range, in x and in y. */
void test_outlines_out_of_range(void)
{
    static uint8_t frame[64];
    const fxl_band band = {.pixels = frame, .width = 8, .stride = 8, .first_row = 0, .rows = 8};
    fxl_scan scan;
    for (int i = 0; i < 16; i++) {
        fxl_screen_polygon polygon = {
            .count = 4, .points = {{0, 0}, {Q16(8), 0}, {Q16(8), Q16(8)}, {0, Q16(8)}}};
        fxl_q16_16 *const number = i & 1 ? &polygon.points[i / 4].x : &polygon.points[i / 4].y;
        const int sign = i & 2 ? 1 : -1;
        *number = sign * FXL_SCREEN_COORDINATE_MAX;
        TEST_ASSERT_EQUAL(FXL_OK, fxl_scan_begin(&polygon, &band, &scan));
        *number += sign;
        TEST_ASSERT_EQUAL(FXL_E_RANGE, fxl_scan_begin(&polygon, &band, &scan));
    }
}

/* SPDX-License-Identifier: MIT */
/* The fill rule, as pictures and against its definition. */
#include "picture.h"

/* SPEC 1.1c */
void test_whole_pixels(void)
{
    CHECK_PICTURE(POINTS(1, 1, 5, 1, 5, 4, 1, 4),
                  ROWS("......", ".####.", ".####.", ".####.", "......"));
}

/* Corners on pixel centres: the left and the top edge are in, the others out. */
/* SPEC 5.2 */
void test_ties_go_to_the_top_left(void)
{
    CHECK_PICTURE(POINTS(1.5, 1.5, 4.5, 1.5, 4.5, 3.5, 1.5, 3.5),
                  ROWS("......", ".###..", ".###..", "......", "......"));
}

/* SPEC 5.2 */
void test_a_hair_moves_a_tie(void)
{
    const double hair = 1.0 / 65536;
    CHECK_PICTURE(POINTS(1.5 + hair, 1.5 + hair, 4.5 + hair, 1.5 + hair, 4.5 + hair, 3.5 + hair,
                         1.5 + hair, 3.5 + hair),
                  ROWS("......", "......", "..###.", "..###.", "......"));
}

/* Every centre that the slanted edge passes through: in where it is a left
 * edge, out where it is a right edge. */
void test_a_diagonal_through_centres(void)
{
    CHECK_PICTURE(POINTS(0, 0, 5, 5, 0, 5), ROWS(".....", "#....", "##...", "###..", "####."));
    CHECK_PICTURE(POINTS(0, 0, 5, 0, 5, 5), ROWS("#####", ".####", "..###", "...##", "....#"));
}

void test_both_ways_round(void)
{
    CHECK_PICTURE(POINTS(1, 4, 5, 4, 5, 1, 1, 1),
                  ROWS("......", ".####.", ".####.", ".####.", "......"));
    CHECK_PICTURE(POINTS(0, 5, 5, 5, 0, 0), ROWS(".....", "#....", "##...", "###..", "####."));
}

void test_a_triangle_down(void)
{
    CHECK_PICTURE(POINTS(0, 0.5, 7, 0.5, 3.5, 4),
                  ROWS("#######", ".#####.", "..###..", "...#...", "......."));
}

/* Two triangles of a square: each pixel once, the diagonal to the lower right. */
/* SPEC 5.3b */
void test_a_shared_diagonal(void)
{
    picture canvas;
    picture_clear(&canvas, 6, 6);
    fxl_screen_polygon upper = picture_polygon(POINTS(1, 1, 5, 1, 5, 5), 3);
    fxl_screen_polygon lower = picture_polygon(POINTS(1, 1, 5, 5, 1, 5), 3);
    picture_add(&canvas, &upper, 'u');
    picture_add(&canvas, &lower, 'l');
    picture_expect(&canvas, ROWS("......", ".uuuu.", ".luuu.", ".lluu.", ".lllu.", "......"));
}

/* Six triangles around a corner that lies on a pixel centre. */
void test_a_fan_around_a_centre(void)
{
    const double rim[] = {0, 0, 4, 0, 7, 0, 7, 7, 3, 7, 0, 7};
    picture canvas;
    picture_clear(&canvas, 7, 7);
    for (int i = 0; i < 6; i++) {
        const double *a = rim + 2 * i, *b = rim + 2 * ((i + 1) % 6);
        fxl_screen_polygon part = picture_polygon(POINTS(3.5, 3.5, a[0], a[1], b[0], b[1]), 3);
        picture_add(&canvas, &part, (char)('a' + i));
    }
    for (int y = 0; y < 7; y++) {
        for (int x = 0; x < 7; x++) {
            TEST_ASSERT_TRUE_MESSAGE(canvas.pixels[y][x] != '.', "a gap in the fan");
        }
    }
    TEST_ASSERT_EQUAL_MESSAGE('c', canvas.pixels[3][3], "the corner goes to its right");
}

void test_a_sliver_between_centres_covers_nothing(void)
{
    CHECK_PICTURE(POINTS(1.6, 0, 2.4, 0, 2.4, 4, 1.6, 4), ROWS("....", "....", "....", "...."));
}

void test_a_sliver_covers_the_centres_it_meets(void)
{
    CHECK_PICTURE(POINTS(0, 0.4, 8, 3.4, 8, 3.6, 0, 0.6),
                  ROWS("........", "..#.....", ".....#..", "........"));
}

/* What rounding does to a many-sided polygon: a vertex a little inside. */
void test_a_dent_is_left_out(void)
{
    CHECK_PICTURE(POINTS(0, 0, 4, 2, 8, 0, 8, 5, 0, 5),
                  ROWS("#......#", "###..###", "########", "########", "########"));
}

/* SPEC 5.1a */
void test_two_prongs_are_two_spans(void)
{
    CHECK_PICTURE(POINTS(0, 0, 2, 0, 2, 3, 6, 3, 6, 0, 8, 0, 8, 5, 0, 5),
                  ROWS("##....##", "##....##", "##....##", "########", "########"));
}

/* Both halves of a bow are in, though they go round opposite ways. */
/* SPEC 5.1a */
void test_a_bow(void)
{
    CHECK_PICTURE(POINTS(0, 0, 7, 7, 7, 0, 0, 7), ROWS("......#", "#....##", "##..###", "#######",
                                                       "##..###", "#....##", "......#"));
}

/* A square gone round twice winds twice about its inside, which is in as well. */
/* SPEC 5.1a */
void test_overlap_is_filled_once(void)
{
    CHECK_PICTURE(
        POINTS(1, 1, 6, 1, 6, 6, 1, 6, 1, 1, 6, 1, 6, 6, 1, 6),
        ROWS(".......", ".#####.", ".#####.", ".#####.", ".#####.", ".#####.", "......."));
}

void test_repeated_vertices_change_nothing(void)
{
    CHECK_PICTURE(POINTS(1, 1, 1, 1, 5, 1, 5, 4, 5, 4, 1, 4),
                  ROWS("......", ".####.", ".####.", ".####.", "......"));
}

void test_no_area_covers_nothing(void)
{
    CHECK_PICTURE(POINTS(0.5, 0.5, 3.5, 3.5, 1.5, 1.5), ROWS("....", "....", "....", "...."));
    CHECK_PICTURE(POINTS(1.5, 0, 1.5, 4, 1.5, 2), ROWS("....", "....", "....", "...."));
}

void test_off_the_screen_is_cut(void)
{
    CHECK_PICTURE(POINTS(-4095, -4095, 4095, -4095, 4095, 4095, -4095, 4095),
                  ROWS("####", "####", "####"));
    CHECK_PICTURE(POINTS(-9, 1, 2, 1, 2, 2, -9, 2), ROWS("....", "##..", "...."));
    CHECK_PICTURE(POINTS(3, -9, 40, -9, 40, 2, 3, 2), ROWS("...#", "...#", "...."));
    CHECK_PICTURE(POINTS(-9, -9, -1, -9, -1, 99, -9, 99), ROWS("....", "....", "...."));
    CHECK_PICTURE(POINTS(0, 5, 4, 5, 4, 9, 0, 9), ROWS("....", "....", "...."));
}

/* place fill-rule: pictures; columns of edges; corners on centres */
static fxl_q16_16 random_coordinate(int32_t pixels)
{
    const int32_t range = pixels * 65536;
    switch (unit_random() % 8) {
    case 0:
        return unit_between(0, pixels) * 65536 + 32768; /* a centre */
    case 1:
        return unit_between(0, 2 * pixels) * 32768;
    case 2:
        return unit_between(-FXL_SCREEN_COORDINATE_MAX, FXL_SCREEN_COORDINATE_MAX);
    default:
        return unit_between(-range / 4, range + range / 4);
    }
}

static void random_polygon(fxl_screen_polygon *polygon, int32_t pixels)
{
    polygon->count =
        (uint8_t)(unit_random() % 4 ? unit_between(3, 6) : unit_between(3, FXL_POLYGON_CAPACITY));
    polygon->colour = 1;
    for (int i = 0; i < polygon->count; i++) {
        polygon->points[i].x = random_coordinate(pixels);
        polygon->points[i].y = random_coordinate(pixels);
    }
}

/* Any polygon, also crossing itself, has exactly the definition's pixels. */
/* SPEC 5.1a-e, accuracy 1.1t */
void test_coverage_is_the_definition(void)
{
    picture canvas;
    fxl_screen_polygon polygon;
    for (int i = 0; i < UNIT_REPEAT / 5; i++) {
        uint16_t width = (uint16_t)unit_between(1, 16), height = (uint16_t)unit_between(1, 16);
        picture_clear(&canvas, width, height);
        random_polygon(&polygon, 16);
        picture_add(&canvas, &polygon, '#');
        for (int y = 0; y < height; y++) {
            for (int x = 0; x < width; x++) {
                bool inside = picture_winding(&polygon, x, y) != 0;
                TEST_ASSERT_EQUAL(inside ? '#' : '.', canvas.pixels[y][x]);
            }
        }
    }
}

/* The number whose product with `factor` leaves 1 over modulo `modulus`; both
 * without a common divisor. Euclid. */
static int64_t inverse_of(int64_t factor, int64_t modulus)
{
    int64_t a = modulus, b = factor % modulus, x = 0, y = 1;
    while (b != 0) {
        int64_t quotient = a / b, swap = a - quotient * b;
        a = b;
        b = swap;
        swap = x - quotient * y;
        x = y;
        y = swap;
    }
    return (x + modulus) % modulus;
}

/* An edge that passes the centre of pixel (column, 0) by `side` units of
 * 2^-32 pixel / height, the least that there is; or, for 0, through it. It
 * begins t units above the centre, straight below a centre of column 0, and is
 * t + multiple of t high: dx t = 65536 height + side is solved for height. */
static void least_miss(int32_t side, int32_t column)
{
    int64_t t = unit_between(16384, 32767) * 2 + 1;
    int64_t height = (t - side) * inverse_of(65536 * column, t) % t;
    height += t * unit_between(2, 8);
    int64_t dx = (65536 * height * column + side) / t;
    TEST_ASSERT_EQUAL_INT64(65536 * height * column + side, dx * t);
    fxl_q16_16 x = 32768, top = (fxl_q16_16)(32768 - t), bottom = top + (fxl_q16_16)height;
    fxl_screen_polygon polygon = {
        .count = 3, .points = {{x, top}, {x + (fxl_q16_16)dx, bottom}, {x - Q16(1000), bottom}}};
    picture canvas;
    picture_clear(&canvas, 16, 16);
    picture_add(&canvas, &polygon, '#');
    for (int y = 0; y < 16; y++) {
        for (int column_at = 0; column_at < 16; column_at++) {
            bool inside = picture_winding(&polygon, column_at, y) != 0;
            TEST_ASSERT_EQUAL(inside ? '#' : '.', canvas.pixels[y][column_at]);
        }
    }
    /* A right edge: a centre on it is out, one the least bit left of it is in. */
    TEST_ASSERT_EQUAL(side > 0 ? '#' : '.', canvas.pixels[0][column]);
    TEST_ASSERT_EQUAL('#', canvas.pixels[0][column - 1]);
}

/* SPEC 5.3c */
void test_edges_that_just_miss_a_centre(void)
{
    for (int i = 0; i < UNIT_REPEAT / 20; i++) {
        least_miss(1, 1 << i % 4);
        least_miss(0, 1 << i % 4);
        least_miss(-1, 1 << i % 4);
    }
}

/* The widest screen, edges from end to end of the range. */
void test_coverage_on_the_largest_screen(void)
{
    static uint8_t row[FXL_SCREEN_MAX], unused[FXL_SCREEN_MAX];
    fxl_screen_polygon polygon;
    for (int i = 0; i < UNIT_REPEAT / 100 + 20; i++) {
        uint16_t y = (uint16_t)unit_between(0, FXL_SCREEN_MAX - 1);
        fxl_band band = UNIT_BAND(unused, FXL_SCREEN_MAX, y, 1);
        fxl_scan scan;
        fxl_span span;
        random_polygon(&polygon, FXL_SCREEN_MAX);
        memset(row, 0, sizeof row);
        TEST_ASSERT_EQUAL(FXL_OK, fxl_scan_begin(&polygon, &band, &scan));
        while (fxl_scan_next(&scan, &span)) {
            TEST_ASSERT_EQUAL(y, span.y);
            TEST_ASSERT_TRUE(span.x0 >= 0 && span.x1 <= FXL_SCREEN_MAX);
            memset(row + span.x0, 1, (size_t)(span.x1 - span.x0));
        }
        for (int x = 0; x < FXL_SCREEN_MAX; x++) {
            TEST_ASSERT_EQUAL(picture_winding(&polygon, x, y) != 0, row[x]);
        }
    }
}

void test_bands_are_cuts_of_the_whole(void)
{
    picture whole, banded;
    fxl_screen_polygon polygon;
    for (int i = 0; i < UNIT_REPEAT / 50 + 20; i++) {
        random_polygon(&polygon, 16);
        picture_clear(&whole, 16, 16);
        picture_clear(&banded, 16, 16);
        picture_add(&whole, &polygon, '#');
        for (uint16_t first = 0; first < 16;) {
            uint16_t rows = (uint16_t)unit_between(1, 16 - first);
            picture_add_band(&banded, &polygon, first, rows, '#');
            first = (uint16_t)(first + rows);
        }
        TEST_ASSERT_EQUAL_MEMORY(whole.pixels, banded.pixels, sizeof whole.pixels);
    }
}

/* An edge 4 rows high that leans 6 units: on row 0 its remainder is 262138 of
 * 262144 and it takes 6 a row, so with this start row 1 uses it up exactly. */
void test_a_band_may_begin_where_the_remainder_is_used_up(void)
{
    const fxl_q16_16 x = Q16(3.5) + 65534;
    fxl_screen_polygon polygon = {
        .count = 4, .points = {{Q16(10), 0}, {Q16(10), Q16(4)}, {x + 6, Q16(4)}, {x, 0}}};
    picture whole, banded;
    picture_clear(&whole, 16, 4);
    picture_clear(&banded, 16, 4);
    picture_add(&whole, &polygon, '#');
    for (uint16_t row = 0; row < 4; row++) {
        picture_add_band(&banded, &polygon, row, 1, '#');
    }
    TEST_ASSERT_EQUAL_MEMORY(whole.pixels, banded.pixels, sizeof whole.pixels);
    TEST_ASSERT_TRUE(picture_winding(&polygon, 4, 1) == 0 && whole.pixels[1][4] == '.');
}

/* The rows whose centres lie from the highest vertex, it included, to the
 * lowest, it not included; held to the screen. */
static void expect_rows(const fxl_screen_polygon *polygon, uint16_t height, fxl_rows rows)
{
    fxl_q16_16 top = polygon->points[0].y, bottom = top;
    for (int i = 1; i < polygon->count; i++) {
        top = polygon->points[i].y < top ? polygon->points[i].y : top;
        bottom = polygon->points[i].y > bottom ? polygon->points[i].y : bottom;
    }
    TEST_ASSERT_TRUE(rows.first <= rows.end && rows.end <= height);
    for (int32_t row = 0; row < height; row++) {
        int32_t centre = row * 65536 + 32768;
        TEST_ASSERT_EQUAL(top <= centre && centre < bottom, row >= rows.first && row < rows.end);
    }
}

/* SPEC 7.1a */
void test_the_rows_of_a_polygon(void)
{
    fxl_screen_polygon polygon;
    for (int i = 0; i < UNIT_REPEAT; i++) {
        uint16_t height = (uint16_t)unit_between(1, 20);
        random_polygon(&polygon, 16);
        expect_rows(&polygon, height, fxl_scan_rows(&polygon, height));
    }
}

/* Spans lie in these rows, also where nothing is checked. */
void test_an_outline_is_scanned_as_its_polygon_is(void)
{
    static uint8_t pixels[16];
    fxl_screen_polygon polygon;
    fxl_scan scan, unchecked;
    fxl_span span = {0, 0, 0}, same = {0, 0, 0};
    uint32_t spans = 0;
    for (int i = 0; i < UNIT_REPEAT / 5; i++) {
        fxl_band band = UNIT_BAND(pixels, 16, 0, (uint16_t)unit_between(1, 16));
        random_polygon(&polygon, 16);
        fxl_rows rows = fxl_scan_rows(&polygon, band.rows);
        TEST_ASSERT_EQUAL(FXL_OK, fxl_scan_begin(&polygon, &band, &scan));
        fxl_scan_outline(polygon.points, polygon.count, &band, &unchecked);
        while (fxl_scan_next(&scan, &span)) {
            TEST_ASSERT_TRUE(fxl_scan_next(&unchecked, &same));
            TEST_ASSERT_EQUAL_MEMORY(&span, &same, sizeof span);
            TEST_ASSERT_TRUE(span.y >= rows.first && span.y < rows.end);
            spans++;
        }
        TEST_ASSERT_FALSE(fxl_scan_next(&unchecked, &same));
    }
    TEST_ASSERT_TRUE(spans > UNIT_REPEAT / 5);
}

static void expect_refused(fxl_status status, const fxl_screen_polygon *polygon,
                           const fxl_band *band)
{
    fxl_scan scan;
    fxl_span span = {1, 2, 3};
    memset(&scan, 1, sizeof scan); /* whatever it was */
    TEST_ASSERT_EQUAL(status, fxl_scan_begin(polygon, band, &scan));
    TEST_ASSERT_NULL(fxl_scan_next_trapezoid(&scan));
    TEST_ASSERT_FALSE(fxl_scan_next(&scan, &span));
    TEST_ASSERT_EQUAL(1, span.y);
    TEST_ASSERT_EQUAL(2, span.x0);
    TEST_ASSERT_EQUAL(3, span.x1);
}

void test_what_breaks_the_contract_is_refused(void)
{
    static uint8_t pixels[64];
    fxl_band band = {.pixels = pixels, .width = 8, .stride = 8, .first_row = 0, .rows = 8};
    fxl_screen_polygon polygon = picture_polygon(POINTS(1, 1, 5, 1, 5, 4), 3);
    fxl_scan scan;
    TEST_ASSERT_EQUAL(FXL_E_ARGUMENT, fxl_scan_begin(&polygon, &band, NULL));
    expect_refused(FXL_E_ARGUMENT, NULL, &band);
    expect_refused(FXL_E_ARGUMENT, &polygon, NULL);
    polygon.count = 2;
    expect_refused(FXL_E_DEGENERATE, &polygon, &band);
    polygon.count = FXL_POLYGON_CAPACITY + 1;
    expect_refused(FXL_E_CAPACITY, &polygon, &band);
    polygon.count = 3;
    polygon.points[1].x = FXL_SCREEN_COORDINATE_MAX + 1;
    expect_refused(FXL_E_RANGE, &polygon, &band);
    polygon.points[1].x = FXL_SCREEN_COORDINATE_MAX;
    TEST_ASSERT_EQUAL(FXL_OK, fxl_scan_begin(&polygon, &band, &scan));
    polygon.points[2].y = -FXL_SCREEN_COORDINATE_MAX - 1;
    expect_refused(FXL_E_RANGE, &polygon, &band);
    polygon.points[2].y = 0;
    expect_refused(FXL_E_RANGE, &polygon, &(fxl_band){.pixels = pixels, .width = 0, .stride = 8,
                                                      .first_row = 0, .rows = 8});
    expect_refused(FXL_E_RANGE, &polygon, &(fxl_band){.pixels = pixels, .width = 8, .stride = 8,
                                                      .first_row = 0, .rows = 0});
    expect_refused(FXL_E_RANGE, &polygon, &(fxl_band){.pixels = pixels,
                                                      .width = FXL_SCREEN_MAX + 1, .stride = 8,
                                                      .first_row = 0, .rows = 8});
    expect_refused(FXL_E_RANGE, &polygon, &(fxl_band){.pixels = pixels, .width = 8, .stride = 8,
                                                      .first_row = 1, .rows = FXL_SCREEN_MAX});
    expect_refused(FXL_E_RANGE, &polygon, &(fxl_band){.pixels = pixels, .width = 8, .stride = 8,
                                                      .first_row = 0, .rows = 8,
                                                      .first_column = 5, .columns = 4});
    band = (fxl_band){.pixels = pixels, .width = FXL_SCREEN_MAX, .stride = FXL_SCREEN_MAX,
                      .first_row = FXL_SCREEN_MAX - 1, .rows = 1};
    TEST_ASSERT_EQUAL(FXL_OK, fxl_scan_begin(&polygon, &band, &scan));
}

void test_a_span_is_untouched_at_the_end(void)
{
    static uint8_t pixels[64];
    fxl_band band = {.pixels = pixels, .width = 8, .stride = 8, .first_row = 0, .rows = 8};
    fxl_screen_polygon polygon = picture_polygon(POINTS(1, 1, 5, 1, 5, 2, 1, 2), 4);
    fxl_scan scan;
    fxl_span span;
    TEST_ASSERT_EQUAL(FXL_OK, fxl_scan_begin(&polygon, &band, &scan));
    TEST_ASSERT_TRUE(fxl_scan_next(&scan, &span));
    for (int i = 0; i < 3; i++) {
        TEST_ASSERT_FALSE(fxl_scan_next(&scan, &span));
        TEST_ASSERT_EQUAL(1, span.y);
        TEST_ASSERT_EQUAL(1, span.x0);
        TEST_ASSERT_EQUAL(5, span.x1);
    }
}

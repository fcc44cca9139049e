/* SPDX-License-Identifier: MIT */
#include "unit.h"
#include "picture.h"
#include "raster/draw_outline.h"
#include "raster/scan.h"

enum {
    BAND_WIDTH = 8,
    STRIDE = 10,
    ROWS_OF_BAND = 4,
    FIRST = 5
};

static uint8_t memory[STRIDE * (ROWS_OF_BAND + 2)];

/* A row of untouched bytes before the band and one after it. */
static fxl_band band_of_memory(void)
{
    memset(memory, '.', sizeof memory);
    return (fxl_band){.pixels = memory + STRIDE, .width = BAND_WIDTH, .stride = STRIDE,
                      .first_row = FIRST, .rows = ROWS_OF_BAND};
}

static void expect_memory(const char *text)
{
    TEST_ASSERT_EQUAL_STRING_LEN(text, (const char *)memory, sizeof memory);
}

/* SPEC 4.9a */
void test_a_span_sets_its_pixels_only(void)
{
    fxl_band band = band_of_memory();
    fxl_fill_span(&band, &(fxl_span){6, 2, 5}, '#');
    fxl_fill_span(&band, &(fxl_span){8, 7, 8}, 'x');
    expect_memory(".........."
                  ".........."
                  "..###....."
                  ".........."
                  ".......x.."
                  "..........");
}

void test_a_span_may_take_the_whole_row(void)
{
    fxl_band band = band_of_memory();
    fxl_fill_span(&band, &(fxl_span){FIRST, 0, BAND_WIDTH}, '#');
    expect_memory(".........."
                  "########.."
                  ".........."
                  ".........."
                  ".........."
                  "..........");
}

/* SPEC 4.9a */
void test_a_band_stays_within_its_stride(void)
{
    fxl_band band = band_of_memory();
    fxl_fill_band(&band, '#');
    expect_memory(".........."
                  "########.."
                  "########.."
                  "########.."
                  "########.."
                  "..........");
}

/* Every start and length: fills by words must not touch neighbours. */
/* SPEC 4.9a */
void test_every_start_and_length(void)
{
    static uint8_t row[40];
    for (int16_t start = 0; start < 32; start++) {
        for (int16_t end = (int16_t)(start + 1); end <= 32; end++) {
            memset(row, '.', sizeof row);
            fxl_band band = UNIT_BAND(row + 4, 32, 0, 1);
            fxl_fill_span(&band, &(fxl_span){0, start, end}, 0xAB);
            for (int i = 0; i < 40; i++) {
                TEST_ASSERT_EQUAL_HEX8(i - 4 >= start && i - 4 < end ? 0xAB : '.', row[i]);
            }
        }
    }
}

/* A row lies between the smaller x and the larger one, whichever edge has which: edges may cross.
 */
void test_edges_that_cross(void)
{
    for (int first = 0; first < 2; first++) {
        fxl_band band = band_of_memory();
        fxl_trapezoid trapezoid = {.first_row = FIRST, .end_row = FIRST + ROWS_OF_BAND};
        trapezoid.edges[first] = (fxl_edge){1, 0, 2, 0};                /* 1 3 5 7 */
        trapezoid.edges[1 - first] = (fxl_edge){7, 0, -2, 0x80000000u}; /* 7 5.5 4 2.5 */
        fxl_fill_trapezoid(&band, &trapezoid, '#');
        expect_memory(".........."
                      ".######..."
                      "...##....."
                      "....#....."
                      "..#####..."
                      "..........");
    }
}

/* Down a tall trapezoid the last bit of a step decides in which row an edge comes to the next
 * pixel. */
/* accuracy 1.1t */
void test_no_bit_of_a_step_is_lost(void)
{
    enum {
        TALL = 255
    };
    static uint8_t tall[TALL * 4];
    for (uint32_t step = 1; step <= 0x10001u; step += 0x8000u) {
        for (uint32_t turn = 1; turn < TALL; turn += 127) {
            const fxl_band band = UNIT_BAND(tall, 4, 0, TALL);
            const fxl_trapezoid of = {0, TALL, {{1, 0u - turn * step, 0, step}, {3, 0, 0, 0}}};
            memset(tall, '.', sizeof tall);
            fxl_fill_trapezoid(&band, &of, '#');
            for (uint32_t row = 0; row < TALL; row++) {
                TEST_ASSERT_EQUAL_STRING_LEN(row < turn ? ".##." : "..#.", &tall[4 * row], 4);
            }
        }
    }
}

/* Outlines drawn in one call: the pixels of the definition, and whether they reach the band. */

enum {
    WIDTH = 20,
    HEIGHT = 16,
    COLOUR = 7,
    WIDE_COLOUR = 0xA05F
};

static uint8_t pixels[HEIGHT * WIDTH];
static uint16_t wide_pixels[2 + HEIGHT * WIDTH + 2]; /* of RGB565, between others */
static fxl_scan scan;
static uint32_t rows_at_once; /* beyond one a call */

/* Of any shape: one in four is convex, and those are the ones between two chains. Some lie above or
 * below the screen. */
static fxl_screen_polygon any_outline(void)
{
    static const int8_t ring[4][2] = {{0, -1}, {1, 0}, {0, 1}, {-1, 0}};
    fxl_screen_polygon outline = {.count = 4, .colour = COLOUR};
    const bool is_convex = unit_random() % 4 == 0;
    const int32_t x = unit_between(0, Q16(WIDTH)), y = unit_between(Q16(-6), Q16(HEIGHT + 6));
    const int32_t wide = unit_between(1, Q16(9)), high = unit_between(1, Q16(9));
    for (int i = 0; i < 4; i++) {
        fxl_screen_point *point = &outline.points[i];
        point->x = is_convex ? x + ring[i][0] * wide : unit_between(0, Q16(WIDTH));
        point->y = is_convex ? y + ring[i][1] * high : y + unit_between(-high, high);
        point->x = point->x < 0 ? 0 : point->x > Q16(WIDTH) ? Q16(WIDTH) : point->x;
        point->y = point->y < 0 ? 0 : point->y > Q16(HEIGHT) ? Q16(HEIGHT) : point->y;
    }
    return outline;
}

/* place fill-rule: pictures; columns of edges; corners on centres */
/* Whether a row of the band has a centre between the highest and the lowest point. */
static bool reaches(const fxl_screen_polygon *outline, int32_t first, int32_t rows)
{
    int32_t top = INT32_MAX, bottom = INT32_MIN;
    for (uint32_t i = 0; i < outline->count; i++) {
        top = outline->points[i].y < top ? outline->points[i].y : top;
        bottom = outline->points[i].y > bottom ? outline->points[i].y : bottom;
    }
    for (int32_t row = first; row < first + rows; row++) {
        const int32_t centre = row * 65536 + 32768;
        if (top <= centre && centre < bottom) {
            return true;
        }
    }
    return false;
}

typedef bool drawer(fxl_scan *scan, const fxl_screen_polygon *polygon, const fxl_band *band,
                    uint32_t colour);

static void expect_outline(drawer *draw, const fxl_screen_polygon *outline, const fxl_band *band,
                           bool wanted)
{
    memset(pixels, 0, sizeof pixels);
    const bool found = draw(&scan, outline, band, COLOUR);
    TEST_ASSERT_TRUE(FXL_IS_SMALL ? found : found == wanted);
    for (int32_t row = 0; row < band->rows; row++) {
        for (int32_t x = 0; x < WIDTH; x++) {
            TEST_ASSERT_EQUAL(picture_winding(outline, x, band->first_row + row) != 0 ? COLOUR : 0,
                              pixels[row * WIDTH + x]);
        }
    }
}

/* The same of RGB565; the first pixel has an odd or an even place. */
static void expect_wide_outline(drawer *draw, const fxl_screen_polygon *outline,
                                const fxl_band *band, uint32_t first, bool wanted)
{
    fxl_band wide = *band;
    uint32_t set = 0;
    wide.pixels = (uint8_t *)(wide_pixels + first);
    memset(wide_pixels, 0, sizeof wide_pixels);
    const bool found = draw(&scan, outline, &wide, WIDE_COLOUR);
    TEST_ASSERT_TRUE(FXL_IS_SMALL ? found : found == wanted);
    for (int32_t row = 0; row < band->rows; row++) {
        for (int32_t x = 0; x < WIDTH; x++) {
            const bool covers = picture_winding(outline, x, band->first_row + row) != 0;
            TEST_ASSERT_EQUAL_HEX16(covers ? WIDE_COLOUR : 0,
                                    wide_pixels[first + (uint32_t)(row * WIDTH + x)]);
            set += covers;
        }
    }
    for (size_t i = 0; i < sizeof wide_pixels / sizeof *wide_pixels; i++) {
        set -= wide_pixels[i] != 0;
    }
    TEST_ASSERT_EQUAL_UINT32(0, set); /* and no pixel around the band */
}

/* fxl_draw_by_active_edges as a small library does it, whatever this one is: all rows that two
 * edges cross at once. */
static bool draw_rows_at_once(fxl_scan *by, const fxl_screen_polygon *polygon, const fxl_band *band,
                              uint32_t colour)
{
    fxl_span span;
    fxl_active_edges *edges = &by->active_edges;
    const fxl_rows rows = fxl_scan_rows(polygon, (uint16_t)(band->first_row + band->rows));
    fxl_active_edges_begin(edges, polygon->points, polygon->count, rows.first, rows.end, band);
    while (fxl_active_edges_next(edges, &span)) {
        const int32_t row = edges->row;
        TEST_ASSERT_EQUAL_INT32(span.y, row);
        fxl_active_edges_fill(edges, &span, band, (uint8_t)colour);
        rows_at_once += (uint32_t)(edges->row - row);
    }
    return FXL_IS_SMALL || (rows.first < rows.end && rows.end > band->first_row);
}

void test_an_outline_has_its_pixels_and_says_whether_it_reaches_the_band(void)
{
    uint32_t reached = 0, missed = 0;
    for (int i = 0; i < UNIT_REPEAT / 40; i++) {
        const fxl_screen_polygon outline = any_outline();
        const int32_t first = unit_between(0, HEIGHT - 1), rows = unit_between(1, HEIGHT - first);
        const fxl_band band = UNIT_BAND(pixels, WIDTH, (uint16_t)first, (uint16_t)rows);
        const bool wanted = reaches(&outline, first, rows);
        expect_outline(fxl_draw_outline, &outline, &band, wanted);
        expect_outline(fxl_draw_by_active_edges, &outline, &band, wanted);
        expect_outline(draw_rows_at_once, &outline, &band, wanted);
        const uint32_t first_pixel = unit_random() % 4;
        expect_wide_outline(fxl_draw_outline_rgb565, &outline, &band, first_pixel, wanted);
        expect_wide_outline(fxl_draw_by_active_edges_rgb565, &outline, &band, first_pixel, wanted);
        reached += wanted;
        missed += !wanted;
    }
    TEST_ASSERT_TRUE(reached > UNIT_REPEAT / 200 && missed > UNIT_REPEAT / 400);
    TEST_ASSERT_TRUE(rows_at_once > UNIT_REPEAT / 200);
}

/* A band of some columns, whose pixels begin at column 0. */
void test_an_outline_is_cut_at_the_columns_of_the_band(void)
{
    for (int i = 0; i < UNIT_REPEAT / 200; i++) {
        const fxl_screen_polygon outline = any_outline();
        const uint16_t first = (uint16_t)unit_between(0, WIDTH - 2);
        fxl_band band = {.width = WIDTH, .stride = WIDTH, .rows = HEIGHT, .first_column = first};
        band.columns = (uint16_t)unit_between(1, WIDTH - 1 - first);
        memset(pixels, 0, sizeof pixels);
        memset(wide_pixels, 0, sizeof wide_pixels);
        band.pixels = pixels;
        (void)fxl_draw_outline(&scan, &outline, &band, COLOUR);
        band.pixels = (uint8_t *)wide_pixels;
        (void)fxl_draw_outline_rgb565(&scan, &outline, &band, WIDE_COLOUR);
        for (int32_t place = 0; place < HEIGHT * WIDTH; place++) {
            const int32_t x = place % WIDTH;
            const bool covers = x >= first && x < first + band.columns &&
                                picture_winding(&outline, x, place / WIDTH) != 0;
            TEST_ASSERT_EQUAL(covers ? COLOUR : 0, pixels[place]);
            TEST_ASSERT_EQUAL_HEX16(covers ? WIDE_COLOUR : 0, wide_pixels[place]);
        }
    }
}

/* All rows at once, of edges that run beyond the left or the right border. */
void test_rows_at_once_are_cut_at_the_borders(void)
{
    const fxl_band band = UNIT_BAND(pixels, WIDTH, 0, HEIGHT);
    for (int i = 0; i < UNIT_REPEAT / 100 + 20; i++) {
        fxl_screen_polygon outline = any_outline();
        const int32_t away = i % 2 ? Q16(8) : -Q16(8);
        for (int k = 0; k < 4; k++) {
            outline.points[k].x += away;
        }
        expect_outline(draw_rows_at_once, &outline, &band, reaches(&outline, 0, HEIGHT));
    }
}

/* SPDX-License-Identifier: MIT */
#include "unit.h"

enum {
    WIDTH = 8,
    STRIDE = 10,
    ROWS_OF_BAND = 4,
    FIRST = 5
};

static uint8_t memory[STRIDE * (ROWS_OF_BAND + 2)];

/* A row of untouched bytes before the band and one after it. */
static fxl_band band_of_memory(void)
{
    memset(memory, '.', sizeof memory);
    return (fxl_band){.pixels = memory + STRIDE, .width = WIDTH, .stride = STRIDE,
                      .first_row = FIRST, .rows = ROWS_OF_BAND};
}

static void expect_memory(const char *text)
{
    TEST_ASSERT_EQUAL_STRING_LEN(text, (const char *)memory, sizeof memory);
}

/* SPEC 4.9 */
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
    fxl_fill_span(&band, &(fxl_span){FIRST, 0, WIDTH}, '#');
    expect_memory(".........."
                  "########.."
                  ".........."
                  ".........."
                  ".........."
                  "..........");
}

/* SPEC 4.9 */
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
/* SPEC 4.9 */
void test_every_start_and_length(void)
{
    static uint8_t row[40];
    for (int16_t start = 0; start < 32; start++) {
        for (int16_t end = (int16_t)(start + 1); end <= 32; end++) {
            memset(row, '.', sizeof row);
            fxl_band band = {.pixels = row + 4, .width = 32, .stride = 32, .first_row = 0,
                             .rows = 1};
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

/* SPDX-License-Identifier: MIT */
/* The span buffer: each pixel is drawn once, by the first that covers it. */
#include "painters.h"
#include "unit.h"
#include "study/span_buffer.h"

enum {
    WIDTH = 24,
    HEIGHT = 4,
    INTERVALS = 40,
    NOTHING = '.',
    BEHIND = 0xA5
};

static uint64_t workspace[FXL_SPAN_BUFFER_BYTES(HEIGHT, INTERVALS) / 8 + 1];
static uint8_t pixels[HEIGHT][WIDTH];
static const fxl_band whole = UNIT_BAND(&pixels[0][0], WIDTH, 0, HEIGHT);
static fxl_span_buffer *buffer;
static uint32_t given; /* bytes of the workspace */

/* The same source with its fill counted: it does whatever the library's does. */
static uint64_t twin_workspace[FXL_SPAN_BUFFER_BYTES(HEIGHT, INTERVALS) / 8 + 1];
static uint8_t twin_pixels[HEIGHT][WIDTH], writes[HEIGHT][WIDTH];
static fxl_span_buffer *twin;

static fxl_band twin_of(const fxl_band *band)
{
    fxl_band other = *band;
    other.pixels = &twin_pixels[0][0] + (band->pixels - &pixels[0][0]);
    return other;
}

/* What is behind the memory that a buffer was given. */
static void expect_nothing_behind(void)
{
    uint8_t *end = (uint8_t *)workspace + given;
    TEST_ASSERT_EACH_EQUAL_HEX8(BEHIND, end, (uint8_t *)workspace + sizeof workspace - end);
}

static void make(uint32_t size, uint16_t height)
{
    given = size;
    memset((uint8_t *)workspace + size, BEHIND, sizeof workspace - size);
    buffer = fxl_span_buffer_make(workspace, size, height);
    twin = counted_span_buffer_make(twin_workspace, size, height);
    TEST_ASSERT_EQUAL_PTR(workspace, buffer);
    TEST_ASSERT_EQUAL_PTR(twin_workspace, twin);
    TEST_ASSERT_EQUAL_UINT16(0, buffer->row_count);
}

static void begin(const fxl_band *band)
{
    const fxl_band other = twin_of(band);
    fxl_span_buffer_begin(buffer, band);
    counted_span_buffer_begin(twin, &other);
}

static bool draw_trapezoid(const fxl_trapezoid *trapezoid, char colour, const fxl_band *band)
{
    const fxl_band other = twin_of(band);
    const bool drawn = fxl_span_buffer_draw(buffer, trapezoid, (uint8_t)colour, band);
    TEST_ASSERT_EQUAL(drawn, counted_span_buffer_draw(twin, trapezoid, (uint8_t)colour, &other));
    TEST_ASSERT_EQUAL_MEMORY(twin_pixels, pixels, sizeof pixels);
    TEST_ASSERT_EQUAL_UINT16(twin->used, buffer->used);
    TEST_ASSERT_EQUAL_UINT16(twin->unused, buffer->unused);
    TEST_ASSERT_EQUAL_UINT16(twin->open_rows, buffer->open_rows);
    TEST_ASSERT_EQUAL(0, memcmp(twin->pool, buffer->pool, buffer->used * sizeof *buffer->pool));
    return drawn;
}

static void start(uint32_t intervals)
{
    make(FXL_SPAN_BUFFER_BYTES(HEIGHT, intervals), HEIGHT);
    TEST_ASSERT_EQUAL(intervals, buffer->capacity);
    begin(&whole);
    (void)counted_begin(&writes[0][0], &twin_pixels[0][0], sizeof writes);
    memset(pixels, NOTHING, sizeof pixels);
    memset(twin_pixels, NOTHING, sizeof twin_pixels);
}

/* A number of an interval has 16 bits, one of which is that of none. Making a buffer writes its head alone, so so much memory
 * need not be there. */
void test_a_pool_has_no_more_intervals_than_numbers(void)
{
    const uint32_t intervals[][2] = {{FXL_COVERED_END - 1, FXL_COVERED_END - 1},
                                     {FXL_COVERED_END, FXL_COVERED_END},
                                     {FXL_COVERED_END + 1, FXL_COVERED_END},
                                     {(1 << 20) + 7, FXL_COVERED_END}};
    for (int i = 0; i < 4; i++) {
        buffer =
            fxl_span_buffer_make(workspace, FXL_SPAN_BUFFER_BYTES(HEIGHT, intervals[i][0]), HEIGHT);
        TEST_ASSERT_EQUAL_UINT32(intervals[i][1], buffer->capacity);
    }
}

static bool draw_span(int y, int x0, int x1, char colour, const fxl_band *band)
{
    const fxl_span span = {(int16_t)y, (int16_t)x0, (int16_t)x1};
    const fxl_trapezoid row = fxl_trapezoid_of_span(&span);
    return draw_trapezoid(&row, colour, band);
}

static bool draw(int y, int x0, int x1, char colour)
{
    return draw_span(y, x0, x1, colour, &whole);
}

/* A row as text, and its intervals: "0-3 7-9". */
static void expect_row(int y, const char *picture, const char *intervals)
{
    char said[WIDTH * 6 + 1] = "", *to = said;
    for (uint16_t at = buffer->rows[y]; at != FXL_COVERED_END; at = buffer->pool[at].next) {
        const fxl_covered *covered = &buffer->pool[at];
        const uint16_t ends[2] = {covered->x0, covered->x1};
        to += to == said ? 0 : (*to = ' ', 1);
        for (int i = 0; i < 2; i++) {
            if (ends[i] >= 10) {
                *to++ = (char)('0' + ends[i] / 10);
            }
            *to++ = (char)('0' + ends[i] % 10);
            if (i == 0) {
                *to++ = '-';
            }
        }
        *to = '\0';
    }
    TEST_ASSERT_EQUAL_STRING_LEN(picture, &pixels[y][0], WIDTH);
    TEST_ASSERT_EQUAL_STRING(intervals, said);
}

/* spans 2.2a */
void test_the_first_keeps_its_pixels(void)
{
    start(INTERVALS);
    TEST_ASSERT_TRUE(draw(1, 4, 10, 'a'));
    expect_row(1, "....aaaaaa..............", "4-10");
    TEST_ASSERT_TRUE(draw(1, 2, 12, 'b'));
    expect_row(1, "..bbaaaaaabb............", "2-12");
    TEST_ASSERT_TRUE(draw(1, 16, 20, 'c'));
    expect_row(1, "..bbaaaaaabb....cccc....", "2-12 16-20");
    TEST_ASSERT_TRUE(draw(1, 0, 24, 'd'));
    expect_row(1, "ddbbaaaaaabbddddccccdddd", "0-24");
    TEST_ASSERT_TRUE(draw(1, 0, 24, 'e'));
    expect_row(1, "ddbbaaaaaabbddddccccdddd", "0-24");
    expect_row(0, "........................", "");
    expect_row(2, "........................", "");
    TEST_ASSERT_EQUAL(HEIGHT - 1, buffer->open_rows);
}

/* spans 2.1b */
void test_what_touches_becomes_one(void)
{
    start(INTERVALS);
    TEST_ASSERT_TRUE(draw(0, 4, 8, 'a') && draw(0, 8, 10, 'b') && draw(0, 2, 4, 'c'));
    expect_row(0, "..ccaaaabb..............", "2-10");
    TEST_ASSERT_TRUE(draw(0, 11, 13, 'd') && draw(0, 14, 16, 'e'));
    expect_row(0, "..ccaaaabb.dd.ee........", "2-10 11-13 14-16");
    TEST_ASSERT_TRUE(draw(0, 10, 11, 'f'));
    expect_row(0, "..ccaaaabbfdd.ee........", "2-13 14-16");
    TEST_ASSERT_TRUE(draw(0, 5, 14, 'g'));
    expect_row(0, "..ccaaaabbfddgee........", "2-16");
    TEST_ASSERT_TRUE(draw(0, 20, 21, 'h') && draw(0, 18, 19, 'i') && draw(0, 23, 24, 'j'));
    expect_row(0, "..ccaaaabbfddgee..i.h..j", "2-16 18-19 20-21 23-24");
    TEST_ASSERT_TRUE(draw(0, 0, 21, 'k'));
    expect_row(0, "kkccaaaabbfddgeekkikh..j", "0-21 23-24");
}

/* A span that ends where an interval begins, or begins where one ends. */
/* spans 2.1b */
void test_ends_that_meet(void)
{
    start(INTERVALS);
    TEST_ASSERT_TRUE(draw(3, 10, 12, 'a') && draw(3, 4, 6, 'b') && draw(3, 6, 10, 'c'));
    expect_row(3, "....bbccccaa............", "4-12");
    TEST_ASSERT_TRUE(draw(3, 4, 12, 'd') && draw(3, 4, 5, 'd') && draw(3, 11, 12, 'd'));
    expect_row(3, "....bbccccaa............", "4-12");
    TEST_ASSERT_TRUE(draw(3, 11, 13, 'e') && draw(3, 3, 5, 'f'));
    expect_row(3, "...fbbccccaae...........", "3-13");
}

/* What is full refuses and draws nothing; what merges wants no room, and gives some back. */
/* spans 2.3b-c */
void test_a_full_pool_refuses(void)
{
    start(2);
    TEST_ASSERT_TRUE(draw(0, 0, 2, 'a') && draw(1, 4, 6, 'b'));
    TEST_ASSERT_FALSE(draw(0, 3, 4, 'c'));
    TEST_ASSERT_FALSE(draw(2, 3, 4, 'c'));
    expect_row(0, "aa......................", "0-2");
    expect_row(2, "........................", "");
    TEST_ASSERT_TRUE(draw(0, 1, 4, 'd') && draw(1, 2, 5, 'd'));
    expect_row(0, "aadd....................", "0-4");
    expect_row(1, "..ddbb..................", "2-6");
    start(2);
    TEST_ASSERT_TRUE(draw(0, 0, 2, 'a') && draw(0, 4, 6, 'b') && draw(0, 1, 5, 'c'));
    expect_row(0, "aaccbb..................", "0-6");
    TEST_ASSERT_TRUE(draw(3, 7, 8, 'd'));
    TEST_ASSERT_FALSE(draw(2, 7, 8, 'e'));
    expect_nothing_behind();
}

/* Every other pixel, from any end: then a row holds as much as it can. */
/* spans 3.3a */
void test_the_stated_pool_is_enough_for_a_row(void)
{
    static const int steps[] = {1, 5, 7, 11}; /* none has a factor of WIDTH / 2 */
    for (int k = 0; k < 4; k++) {
        start(FXL_SPAN_BUFFER_ROW(WIDTH));
        for (int i = 0; i < WIDTH / 2; i++) {
            int at = i * steps[k] % (WIDTH / 2) * 2;
            TEST_ASSERT_TRUE(draw(0, at, at + 1, 'a'));
        }
        TEST_ASSERT_FALSE(draw(1, 0, 1, 'a'));
        expect_nothing_behind();
        TEST_ASSERT_TRUE(draw(0, 0, WIDTH, 'b'));
        expect_row(0, "abababababababababababab", "0-24");
        TEST_ASSERT_EACH_EQUAL_HEX8(1, writes[0], WIDTH);
    }
}

/* A row of an odd number of pixels holds one more. */
/* spans 3.3a */
void test_an_odd_width(void)
{
    enum {
        ODD = 7
    };
    const fxl_band band = {
        .pixels = &pixels[0][0], .width = ODD, .stride = WIDTH, .first_row = 0, .rows = 1};
    make(FXL_SPAN_BUFFER_BYTES_LEAST(ODD, 1), 1);
    begin(&band);
    for (int16_t x = ODD - 1; x >= 0; x = (int16_t)(x - 2)) {
        TEST_ASSERT_TRUE(draw_span(0, x, x + 1, 'a', &band));
    }
    TEST_ASSERT_TRUE(draw_span(0, 0, ODD, 'b', &band));
    TEST_ASSERT_EQUAL_STRING_LEN("abababa", &pixels[0][0], ODD);
    TEST_ASSERT_EQUAL(0, buffer->open_rows);
}

/* spans 3.1 */
void test_a_new_band_finds_nothing_covered(void)
{
    start(INTERVALS);
    TEST_ASSERT_TRUE(draw(0, 0, WIDTH, 'a') && draw(3, 2, 8, 'a'));
    const fxl_band lower = UNIT_BAND(&pixels[2][0], WIDTH, 2, 2);
    begin(&lower);
    TEST_ASSERT_EQUAL(2, buffer->open_rows);
    TEST_ASSERT_TRUE(draw_span(3, 4, 12, 'b', &lower));
    TEST_ASSERT_EQUAL_STRING_LEN("..aabbbbbbbb............", &pixels[3][0], WIDTH);
}

/* Edges that cross, an empty row, and rows after which the pool is full. */
/* Rows that are not wholly covered are counted, however a row comes to be covered. */
/* spans 2.3a */
void test_open_rows_are_counted(void)
{
    start(INTERVALS);
    TEST_ASSERT_EQUAL_UINT16(HEIGHT, buffer->open_rows);
    TEST_ASSERT_TRUE(draw(0, 0, WIDTH, 'a'));
    TEST_ASSERT_EQUAL_UINT16(HEIGHT - 1, buffer->open_rows);
    TEST_ASSERT_TRUE(draw(0, 3, 7, 'b')); /* covered already */
    TEST_ASSERT_EQUAL_UINT16(HEIGHT - 1, buffer->open_rows);
    TEST_ASSERT_TRUE(draw(1, 1, WIDTH, 'c'));
    TEST_ASSERT_TRUE(draw(2, 0, WIDTH - 1, 'd'));
    TEST_ASSERT_EQUAL_UINT16(HEIGHT - 1, buffer->open_rows);
    TEST_ASSERT_TRUE(draw(1, 0, 1, 'e')); /* to the left of what is there */
    TEST_ASSERT_EQUAL_UINT16(HEIGHT - 2, buffer->open_rows);
    TEST_ASSERT_TRUE(draw(2, WIDTH - 1, WIDTH, 'f')); /* to the right */
    TEST_ASSERT_EQUAL_UINT16(HEIGHT - 3, buffer->open_rows);
    TEST_ASSERT_TRUE(draw(3, 0, 5, 'g') && draw(3, 9, WIDTH, 'h') && draw(3, 5, 9, 'i'));
    TEST_ASSERT_EQUAL_UINT16(0, buffer->open_rows);
}

void test_a_trapezoid(void)
{
    const fxl_trapezoid crossed = {0, 4, {{4, 0, 2, 0}, {10, 0x80000000u, -2, 0x80000000u}}};
    start(INTERVALS);
    TEST_ASSERT_TRUE(draw_trapezoid(&crossed, 'a', &whole));
    expect_row(0, "....aaaaaa..............", "4-10");
    expect_row(1, "......aaa...............", "6-9");
    expect_row(2, ".......a................", "7-8");
    expect_row(3, "......aaaa..............", "6-10");
    start(2);
    TEST_ASSERT_FALSE(draw_trapezoid(&crossed, 'a', &whole));
    expect_row(1, "......aaa...............", "6-9");
    expect_row(2, "........................", "");
    TEST_ASSERT_EACH_EQUAL_HEX8(0, writes[3], WIDTH);
    start(1);
    const fxl_trapezoid empty = {0, 4, {{7, 0, 0, 0}, {7, 0, 0, 0}}};
    TEST_ASSERT_TRUE(draw_trapezoid(&empty, 'a', &whole));
    expect_row(3, "........................", "");
}

/* Spans anywhere, in a pool of any size, against a mark for each pixel. */
/* spans 2.1a, 2.2a-b, accuracy 1.2e */
void test_any_spans(void)
{
    static uint8_t expected[HEIGHT][WIDTH];
    uint32_t refused = 0, taken = 0, visibility = 0;
    for (int round = 0; round < UNIT_REPEAT / 50; round++) {
        start((uint32_t)unit_between(1, INTERVALS));
        memset(expected, NOTHING, sizeof expected);
        for (int i = 0; i < 30; i++) {
            int y = unit_between(0, HEIGHT - 1), x0 = unit_between(0, WIDTH - 1);
            int x1 = unit_between(x0 + 1, i % 3 ? (x0 + 4 < WIDTH ? x0 + 4 : WIDTH) : WIDTH);
            const uint32_t in_use = buffer->used;
            if (!draw(y, x0, x1, (char)('a' + i))) {
                TEST_ASSERT_TRUE(in_use == buffer->capacity && buffer->unused == FXL_COVERED_END);
                TEST_ASSERT_EQUAL_MEMORY(expected, pixels, sizeof pixels);
                refused++;
                break;
            }
            uint32_t seen = 0;
            for (int x = x0; x < x1; x++) {
                seen += expected[y][x] == NOTHING;
                expected[y][x] = expected[y][x] == NOTHING ? (uint8_t)('a' + i) : expected[y][x];
            }
            visibility += seen == 0;
            taken++;
        }
        TEST_ASSERT_EQUAL_MEMORY(expected, pixels, sizeof pixels);
        uint32_t open = 0;
        for (int y = 0; y < HEIGHT; y++) {
            open += memchr(expected[y], NOTHING, WIDTH) != NULL;
            for (int x = 0; x < WIDTH; x++) {
                TEST_ASSERT_EQUAL(expected[y][x] != NOTHING, writes[y][x]);
            }
        }
        TEST_ASSERT_EQUAL(open, buffer->open_rows);
    }
    TEST_ASSERT_TRUE(refused > UNIT_REPEAT / 500 && visibility > taken / 20);
}

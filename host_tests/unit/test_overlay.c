/* SPDX-License-Identifier: MIT */
/* What is drawn over a picture: each function against its definition, pixel by pixel, in a band
 * whose neighbours must stay as they are. Each is drawn as palette indices and in RGB565, whose
 * pixels are the colours of the same indices. */
#include "unit.h"

enum {
    WIDTH = 24,
    STRIDE = 26,
    HEIGHT = 16,
    FIRST = 5, /* row of the band */
    GROUND = 0xEE
};

static uint8_t drawn[HEIGHT][STRIDE], wanted[HEIGHT][STRIDE];
static const fxl_band band = {.pixels = drawn[1], .width = WIDTH, .stride = STRIDE,
                              .first_row = FIRST, .rows = HEIGHT - 2};
static uint16_t drawn_565[HEIGHT][STRIDE], palette[256];
static const fxl_band band_565 = {.pixels = (uint8_t *)drawn_565[1], .width = WIDTH,
                                  .stride = STRIDE, .first_row = FIRST, .rows = HEIGHT - 2,
                                  .palette = palette};

/* Two indices have two colours: the factor is odd. */
static uint16_t colour_of(uint32_t index)
{
    return (uint16_t)(index * 40503u + 12345u);
}

static void clear(void)
{
    memset(drawn, GROUND, sizeof drawn);
    for (uint32_t i = 0; i < HEIGHT * STRIDE; i++) {
        drawn_565[i / STRIDE][i % STRIDE] = colour_of(GROUND);
    }
}

void setUp(void)
{
    for (uint32_t i = 0; i < 256; i++) {
        palette[i] = colour_of(i);
    }
    clear();
    memset(wanted, GROUND, sizeof wanted);
}

void tearDown(void)
{
}

/* A pixel of the screen in the wanted picture, where the band has it. */
static void want(int64_t x, int64_t y, uint8_t colour)
{
    if (x >= 0 && x < WIDTH && y >= FIRST && y < FIRST + HEIGHT - 2) {
        wanted[y - FIRST + 1][x] = colour;
    }
}

static void expect_equal(void)
{
    TEST_ASSERT_EQUAL_MEMORY(wanted, drawn, sizeof drawn);
    for (uint32_t i = 0; i < HEIGHT * STRIDE; i++) {
        TEST_ASSERT_EQUAL_HEX16(colour_of(wanted[i / STRIDE][i % STRIDE]),
                                drawn_565[i / STRIDE][i % STRIDE]);
    }
}

static void expect_wanted(void)
{
    expect_equal();
    setUp();
}

/* In both formats. */
static fxl_status rectangle(int32_t x, int32_t y, int32_t width, int32_t height, uint8_t colour)
{
    const fxl_status status = fxl_draw_rectangle(&band, x, y, width, height, colour);
    TEST_ASSERT_EQUAL(status, fxl_draw_rectangle(&band_565, x, y, width, height, colour));
    return status;
}

static fxl_status border(int32_t x, int32_t y, int32_t width, int32_t height, uint8_t colour)
{
    const fxl_status status = fxl_draw_border(&band, x, y, width, height, colour);
    TEST_ASSERT_EQUAL(status, fxl_draw_border(&band_565, x, y, width, height, colour));
    return status;
}

static fxl_status line(int32_t x0, int32_t y0, int32_t x1, int32_t y1, uint8_t colour)
{
    const fxl_status status = fxl_draw_line(&band, x0, y0, x1, y1, colour);
    TEST_ASSERT_EQUAL(status, fxl_draw_line(&band_565, x0, y0, x1, y1, colour));
    return status;
}

static fxl_status sprite_at(int32_t x, int32_t y, const fxl_sprite *sprite)
{
    const fxl_status status = fxl_draw_sprite(&band, x, y, sprite);
    TEST_ASSERT_EQUAL(status, fxl_draw_sprite(&band_565, x, y, sprite));
    return status;
}

static fxl_status text_at(int32_t x, int32_t y, const char *text, const fxl_text_style *style)
{
    const fxl_status status = fxl_draw_text(&band, x, y, text, style);
    TEST_ASSERT_EQUAL(status, fxl_draw_text(&band_565, x, y, text, style));
    return status;
}

/* Near the band, or anywhere. */
static int32_t any(void)
{
    static const int32_t ends[] = {INT32_MIN, INT32_MAX, 0, -1, FIRST, WIDTH};
    const int32_t kind = unit_between(0, 15);
    return kind == 0   ? ends[unit_between(0, 5)]
           : kind == 1 ? (int32_t)unit_random()
                       : unit_between(-12, 40);
}

/* overlay 1.1, 1.2, 1.3, 1.4 */
void test_rectangles_and_borders_are_what_they_say(void)
{
    for (int i = 0; i < UNIT_REPEAT / 30; i++) {
        const int32_t x = any(), y = any(), width = any(), height = any();
        const bool is_border = unit_random() % 2;
        for (int32_t row = FIRST; row < FIRST + HEIGHT; row++) {
            for (int32_t column = 0; column < WIDTH; column++) {
                const int64_t right = (int64_t)x + width - 1, bottom = (int64_t)y + height - 1;
                if (column >= x && column <= right && row >= y && row <= bottom &&
                    (!is_border || column == x || column == right || row == y || row == bottom)) {
                    want(column, row, 7);
                }
            }
        }
        TEST_ASSERT_EQUAL(FXL_OK, is_border ? border(x, y, width, height, 7)
                                         : rectangle(x, y, width, height, 7));
        expect_wanted();
    }
}

/* floor(a / b + 1/2), b > 0. */
static int64_t rounded(int64_t a, int64_t b)
{
    const int64_t twice = 2 * a + b;
    return twice >= 0 ? twice / (2 * b) : -((-twice + 2 * b - 1) / (2 * b));
}

/* By its definition: each row or column of the band for itself. */
static void want_line(int64_t x0, int64_t y0, int64_t x1, int64_t y1)
{
    const int64_t width = x1 - x0, height = y1 - y0;
    const bool steep = (height < 0 ? -height : height) > (width < 0 ? -width : width);
    const int64_t length = steep ? height : width;
    for (int64_t at = 0; at < 64; at++) {
        const int64_t along = at - (steep ? y0 : x0); /* in the direction of the line */
        const int64_t part = length < 0 ? -along : along, whole = length < 0 ? -length : length;
        if (part < 0 || part > whole) {
            continue;
        }
        const int64_t across = whole == 0 ? 0 : rounded(part * (steep ? width : height), whole);
        want(steep ? x0 + across : at, steep ? at : y0 + across, 9);
    }
}

/* overlay 1.2, 2.1 */
void test_lines_follow_their_rule_in_either_direction(void)
{
    for (int i = 0; i < UNIT_REPEAT / 30; i++) {
        int32_t at[4];
        for (int k = 0; k < 4; k++) {
            at[k] = unit_random() % 4 ? any() / 4 : unit_between(-30, 50);
            at[k] = at[k] > FXL_LINE_COORDINATE_MAX    ? FXL_LINE_COORDINATE_MAX
                    : at[k] < -FXL_LINE_COORDINATE_MAX ? -FXL_LINE_COORDINATE_MAX
                                                       : at[k];
        }
        want_line(at[0], at[1], at[2], at[3]);
        TEST_ASSERT_EQUAL(FXL_OK, line(at[0], at[1], at[2], at[3], 9));
        expect_equal();
        clear();
        TEST_ASSERT_EQUAL(FXL_OK, line(at[2], at[3], at[0], at[1], 9));
        expect_wanted();
    }
}

/* overlay 2.1 */
void test_a_line_has_both_its_ends(void)
{
    TEST_ASSERT_EQUAL(FXL_OK, line(3, 7, 3, 7, 1));
    want(3, 7, 1);
    expect_wanted();
    TEST_ASSERT_EQUAL(FXL_OK, line(2, 9, 5, 10, 1));
    want(2, 9, 1);
    want(3, 9, 1);
    want(4, 10, 1);
    want(5, 10, 1);
    expect_wanted();
    const int32_t far = FXL_LINE_COORDINATE_MAX;
    TEST_ASSERT_EQUAL(FXL_E_RANGE, line(far + 1, 0, 0, 0, 1));
    TEST_ASSERT_EQUAL(FXL_E_RANGE, line(0, -far - 1, 0, 0, 1));
    TEST_ASSERT_EQUAL(FXL_E_RANGE, line(0, 0, INT32_MIN, 0, 1));
    TEST_ASSERT_EQUAL(FXL_E_RANGE, line(0, 0, 0, INT32_MAX, 1));
    expect_wanted();
    TEST_ASSERT_EQUAL(FXL_OK, line(-far, -far + 1, far, far, 9));
    want_line(-far, -far + 1, far, far);
    expect_wanted();
}

static void want_sprite(int64_t x, int64_t y, const fxl_sprite *sprite)
{
    const uint32_t row_bytes = (sprite->width * sprite->bits + 7u) / 8u;
    for (uint32_t row = 0; row < sprite->height; row++) {
        for (uint32_t column = 0; column < sprite->width; column++) {
            const uint32_t bit = column * sprite->bits;
            uint32_t value = 0;
            for (uint32_t k = bit; k < bit + sprite->bits; k++) {
                value = value << 1 |
                        (uint32_t)(sprite->pixels[row * row_bytes + k / 8] >> (7 - k % 8) & 1);
            }
            if (value != sprite->key) {
                want(x + column, y + row,
                     sprite->colours == NULL ? (uint8_t)value : sprite->colours[value]);
            }
        }
    }
}

void test_sprites_of_every_depth_are_drawn_bit_by_bit(void)
{
    static const uint8_t depths[] = {1, 4, 8};
    uint8_t pixels[20 * 20], colours[256];
    for (int i = 0; i < UNIT_REPEAT / 100; i++) {
        fxl_sprite sprite = {pixels, unit_random() % 2 ? colours : NULL, 0, 0, 0, 0};
        sprite.width = (uint16_t)unit_between(0, 20);
        sprite.height = (uint16_t)unit_between(0, 20);
        sprite.bits = depths[unit_between(0, 2)];
        sprite.key = (uint16_t)(unit_random() % 3 ? unit_random() % 4 : FXL_SPRITE_OPAQUE);
        for (uint32_t k = 0; k < sizeof pixels; k++) {
            pixels[k] = (uint8_t)(unit_random() % 2 ? unit_random() : unit_random() % 4);
        }
        for (uint32_t k = 0; k < sizeof colours; k++) {
            colours[k] = (uint8_t)unit_random();
        }
        const int32_t x = any(), y = any();
        want_sprite(x, y, &sprite);
        TEST_ASSERT_EQUAL(FXL_OK, sprite_at(x, y, &sprite));
        expect_wanted();
    }
}

/* A picture that takes 65,535 columns: only those of the band are read. */
void test_a_sprite_may_be_wider_than_the_band(void)
{
    static const uint8_t row[8192] = {[512] = 0x0F, [513] = 0xFF, [514] = 0xC0};
    const uint8_t colours[2] = {3, 4};
    const fxl_sprite sprite = {row, colours, 65535, 1, 1, 0};
    TEST_ASSERT_EQUAL(FXL_OK, sprite_at(-4096, FIRST + 2, &sprite));
    for (int32_t x = 4; x < 18; x++) {
        want(x, FIRST + 2, 4);
    }
    expect_wanted();
}

static void expect_text(const fxl_text_style *style, const char *text, const char *const *rows,
                        int32_t count)
{
    TEST_ASSERT_EQUAL(FXL_OK, text_at(1, FIRST, text, style));
    for (int32_t row = 0; row < count; row++) {
        for (int32_t column = 0; rows[row][column] != '\0'; column++) {
            if (rows[row][column] == 'X') {
                want(1 + column, FIRST + row, style->colour);
            }
        }
    }
    expect_wanted();
}

/* overlay 4.1 */
void test_text_is_what_is_drawn_here(void)
{
    const fxl_text_style style = {&fxl_font_5x7, 5, 0}, fixed = {&fxl_font_5x7, 6, 6};
    static const char *const hi[] = {
        "X...X.X", "X...X..", "X...X.X", "XXXXX.X", "X...X.X", "X...X.X", "X...X.X",
    };
    expect_text(&style, "Hi", hi, 7);
    static const char *const cells[] = {
        "X...X...X", "X...X", "X...X...X", "XXXXX...X", "X...X...X", "X...X...X", "X...X...X",
    };
    expect_text(&fixed, "Hi", cells, 7);
    static const char *const lines[] = {"X", "X", "X", "X", "X", ".", "X",
                                        ".", ".", "X", "X", "X", "X", "X"}; /* the band ends */
    expect_text(&style, "!\n!", lines, 14);
    static const char *const question[] = {".XXX..", "X...X", "....X", "...X.",
                                           "..X..",  ".....", "..X.."};
    expect_text(&style, "\x7F", question, 7);
}

/* Two characters of one pixel: one begins right of the pen, one left of it. */
/* overlay 4.1 */
void test_a_character_may_begin_beside_the_pen(void)
{
    static const uint8_t bits[] = {0x80};
    static const fxl_glyph glyphs[] = {
        {.first_byte = 0, .width = 1, .height = 1, .left = 2, .top = 1, .advance = 4},
        {.first_byte = 0, .width = 1, .height = 1, .left = -1, .top = -1, .advance = 4}};
    static const fxl_font font = {
        .glyphs = glyphs, .bits = bits, .first = 'a', .count = 2, .unknown = 'a', .line_height = 3};
    const fxl_text_style style = {&font, 5, 0}, fixed = {&font, 6, 7};
    TEST_ASSERT_EQUAL(FXL_OK, text_at(2, FIRST + 1, "ab", &style));
    want(4, FIRST + 2, 5);
    want(5, FIRST, 5);
    expect_wanted();
    TEST_ASSERT_EQUAL(FXL_OK, text_at(2, FIRST + 1, "ab", &fixed));
    want(5, FIRST + 2, 6); /* one of the three pixels that are over is to the left */
    want(9, FIRST, 6);
    expect_wanted();
}

/* overlay 4.3 */
void test_a_byte_that_the_font_has_not_is_the_unknown_character(void)
{
    static const uint8_t bits[] = {0x80};
    static const fxl_glyph glyphs[] = {
        {.first_byte = 0, .width = 1, .height = 1, .left = 2, .top = 1, .advance = 4},
        {.first_byte = 0, .width = 1, .height = 1, .left = 0, .top = 0, .advance = 3}};
    static const fxl_font font = {
        .glyphs = glyphs, .bits = bits, .first = 'a', .count = 2, .unknown = 'b', .line_height = 3};
    const fxl_text_style style = {&font, 5, 0};
    const char text[] = {'a' - 1, 'a', 'c', (char)0xFF, 0};
    TEST_ASSERT_EQUAL(FXL_OK, text_at(2, FIRST + 1, text, &style));
    want(2, FIRST + 1, 5);
    want(2 + 3 + 2, FIRST + 2, 5);
    want(2 + 3 + 4, FIRST + 1, 5);
    want(2 + 3 + 4 + 3, FIRST + 1, 5);
    expect_wanted();
}

/* The same text through its sprites. */
/* overlay 4.2 */
void test_text_anywhere_is_its_characters_side_by_side(void)
{
    static const uint8_t mask[2] = {0, 8};
    for (int i = 0; i < UNIT_REPEAT / 100; i++) {
        char text[6];
        const int32_t cell = i % 2 ? unit_between(1, 9) : 0; /* characters advance by 2 to 6 */
        const fxl_text_style style = {&fxl_font_5x7, 8, (uint8_t)cell};
        const int32_t x = any(), y = any();
        int64_t pen = x, top = y;
        uint32_t width = 0, widest = 0, lines = 1;
        for (uint32_t k = 0; k < 5; k++) {
            text[k] = (char)(unit_random() % 6 ? unit_between(32, 126) : '\n');
            if (text[k] == '\n') {
                pen = x;
                top += 9;
                lines++;
                width = 0;
                continue;
            }
            const fxl_glyph *glyph = &fxl_font_5x7.glyphs[text[k] - 32];
            const fxl_sprite picture = {
                fxl_font_5x7.bits + glyph->first_byte, mask, glyph->width, glyph->height, 1, 0};
            const int32_t room = cell != 0 ? cell - glyph->advance : 0;
            const int32_t right = room < 0 ? -((1 - room) / 2) : room / 2;
            want_sprite(pen + right, top + glyph->top, &picture);
            pen += cell != 0 ? cell : glyph->advance;
            width += (uint32_t)(cell != 0 ? cell : glyph->advance);
            widest = width > widest ? width : widest;
        }
        text[5] = '\0';
        TEST_ASSERT_EQUAL(FXL_OK, text_at(x, y, text, &style));
        expect_wanted();
        fxl_text_size size;
        TEST_ASSERT_EQUAL(FXL_OK, fxl_measure_text(text, &style, &size));
        TEST_ASSERT_EQUAL_UINT32(widest, size.width);
        TEST_ASSERT_EQUAL_UINT32(9 * lines, size.height);
    }
}

/* overlay 4.4 */
void test_every_character_of_the_font_is_another(void)
{
    TEST_ASSERT_EQUAL(95, fxl_font_5x7.count);
    TEST_ASSERT_EQUAL(32, fxl_font_5x7.first);
    TEST_ASSERT_EQUAL('?', fxl_font_5x7.unknown);
    TEST_ASSERT_EQUAL(9, fxl_font_5x7.line_height);
    for (uint32_t a = 0; a < 95; a++) {
        const fxl_glyph *first = &fxl_font_5x7.glyphs[a];
        TEST_ASSERT_TRUE(first->width <= 5 && first->height == 7 &&
                         first->advance == first->width + 1);
        for (uint32_t b = 0; b < a; b++) {
            const fxl_glyph *second = &fxl_font_5x7.glyphs[b];
            TEST_ASSERT_TRUE(memcmp(fxl_font_5x7.bits + first->first_byte,
                                    fxl_font_5x7.bits + second->first_byte, 7) != 0);
        }
        for (uint32_t row = 0; row < 7; row++) { /* no pixel beyond the width */
            TEST_ASSERT_EQUAL(0, fxl_font_5x7.bits[first->first_byte + row] & 0xFF >> first->width);
        }
    }
}

/* overlay 4.2 */
void test_a_cell_measures_its_width(void)
{
    const fxl_text_style fixed = {&fxl_font_5x7, 6, 9};
    fxl_text_size size;
    TEST_ASSERT_EQUAL(FXL_OK, fxl_measure_text("a\nbcd", &fixed, &size));
    TEST_ASSERT_EQUAL_UINT32(27, size.width);
    TEST_ASSERT_EQUAL_UINT32(18, size.height);
}

static void expect_refused_by_all(fxl_status status, const fxl_band *wrong)
{
    static const uint8_t pixel[1] = {1};
    const fxl_sprite sprite = {pixel, NULL, 1, 1, 8, FXL_SPRITE_OPAQUE};
    const fxl_text_style style = {&fxl_font_5x7, 1, 0};
    TEST_ASSERT_EQUAL(status, fxl_draw_rectangle(wrong, 0, 0, 40, 40, 1));
    TEST_ASSERT_EQUAL(status, fxl_draw_border(wrong, 0, 0, 40, 40, 1));
    TEST_ASSERT_EQUAL(status, fxl_draw_line(wrong, 0, 0, 40, 40, 1));
    TEST_ASSERT_EQUAL(status, fxl_draw_sprite(wrong, 1, FIRST, &sprite));
    TEST_ASSERT_EQUAL(status, fxl_draw_text(wrong, 1, FIRST, "x", &style));
    expect_wanted();
}

/* Everything at once, in a band of some columns: the pixels of the band of all of them. */
/* overlay 1.1 */
void test_a_band_of_some_columns(void)
{
    static const uint8_t row[2] = {0xA5, 0x3C};
    const fxl_sprite sprite = {row, NULL, 8, 2, 1, 0};
    const fxl_text_style style = {&fxl_font_5x7, 5, 0};
    for (int i = 0; i < UNIT_REPEAT / 100; i++) {
        fxl_band parts[2] = {band, band_565};
        const int32_t first = unit_between(0, WIDTH - 1);
        const int32_t columns = unit_between(1, WIDTH - first);
        int32_t at[8];
        for (int k = 0; k < 8; k++) {
            at[k] = unit_between(-12, 40);
        }
        for (int k = 0; k < 3; k++) {
            const fxl_band *into = k < 2 ? &parts[k] : &band;
            if (k < 2) {
                parts[k].first_column = (uint16_t)first;
                parts[k].columns = (uint16_t)columns;
                parts[k].pixels += (uint32_t)first << k;
            } else {
                memcpy(wanted, drawn, sizeof drawn);
                memset(drawn, GROUND, sizeof drawn);
            }
            TEST_ASSERT_EQUAL(FXL_OK, fxl_draw_rectangle(into, at[0], at[1], at[2], at[3], 7));
            TEST_ASSERT_EQUAL(FXL_OK, fxl_draw_border(into, at[1], at[2], at[3], at[4], 8));
            TEST_ASSERT_EQUAL(FXL_OK, fxl_draw_line(into, at[4], at[5], at[6], at[7], 9));
            TEST_ASSERT_EQUAL(FXL_OK, fxl_draw_sprite(into, at[7], at[0], &sprite));
            TEST_ASSERT_EQUAL(FXL_OK, fxl_draw_text(into, at[3], at[6], "Wg", &style));
        }
        for (int32_t y = 0; y < HEIGHT; y++) {
            for (int32_t x = 0; x < STRIDE; x++) {
                const bool inside = x >= first && x < first + columns;
                const uint8_t colour = inside ? drawn[y][x] : GROUND;
                TEST_ASSERT_EQUAL_HEX8(colour, wanted[y][x]);
                TEST_ASSERT_EQUAL_HEX16(colour_of(colour), drawn_565[y][x]);
            }
        }
        setUp();
    }
}

/* overlay 1.3 */
void test_bands_that_are_none_are_refused(void)
{
    const fxl_band bad[] = {{.pixels = drawn[1], .width = 0, .stride = STRIDE, .first_row = 0,
                             .rows = 1},
                            {.pixels = drawn[1], .width = FXL_SCREEN_MAX + 1, .stride = 2000,
                             .first_row = 0, .rows = 1},
                            {.pixels = drawn[1], .width = WIDTH, .stride = WIDTH - 1,
                             .first_row = 0, .rows = 1},
                            {.pixels = drawn[1], .width = WIDTH, .stride = STRIDE, .first_row = 0,
                             .rows = 0},
                            {.pixels = drawn[1], .width = WIDTH, .stride = STRIDE,
                             .first_row = 1000, .rows = 25}};
    for (size_t i = 0; i < sizeof bad / sizeof bad[0]; i++) {
        expect_refused_by_all(FXL_E_RANGE, &bad[i]);
    }
    fxl_band beyond = band;
    beyond.first_column = 1;
    beyond.columns = WIDTH;
    expect_refused_by_all(FXL_E_RANGE, &beyond);
    uint8_t pixel = 5;
    const fxl_band least = {.pixels = &pixel, .width = 1, .stride = 1,
                            .first_row = FXL_SCREEN_MAX - 1, .rows = 1}; /* the last row there is */
    TEST_ASSERT_EQUAL(FXL_OK, fxl_draw_rectangle(&least, -3, FXL_SCREEN_MAX - 1, 9, 9, 7));
    TEST_ASSERT_EQUAL_UINT8(7, pixel);
    fxl_band odd = band_565;
    odd.pixels++;
    expect_refused_by_all(FXL_E_ALIGNMENT, &odd);
    const fxl_band none = {.pixels = NULL, .width = WIDTH, .stride = STRIDE, .first_row = 0,
                           .rows = 1};
    expect_refused_by_all(FXL_E_ARGUMENT, &none);
    expect_refused_by_all(FXL_E_ARGUMENT, NULL);
}

void test_sprites_and_fonts_that_are_none_are_refused(void)
{
    fxl_sprite sprite = {NULL, NULL, 1, 1, 8, FXL_SPRITE_OPAQUE};
    TEST_ASSERT_EQUAL(FXL_E_ARGUMENT, sprite_at(1, FIRST, &sprite));
    TEST_ASSERT_EQUAL(FXL_E_ARGUMENT, sprite_at(1, FIRST, NULL));
    sprite.pixels = drawn[0];
    sprite.bits = 2;
    TEST_ASSERT_EQUAL(FXL_E_RANGE, sprite_at(1, FIRST, &sprite));
    fxl_font font = fxl_font_5x7;
    fxl_text_style style = {&font, 1, 0};
    fxl_text_size size = {1, 2};
    TEST_ASSERT_EQUAL(FXL_E_ARGUMENT, fxl_measure_text("x", &style, NULL));
    TEST_ASSERT_EQUAL(FXL_E_ARGUMENT, fxl_measure_text(NULL, &style, &size));
    TEST_ASSERT_EQUAL(FXL_E_ARGUMENT, text_at(1, FIRST, "x", NULL));
    font.count = 0;
    TEST_ASSERT_EQUAL(FXL_E_RANGE, fxl_measure_text("x", &style, &size));
    font.count = 225;
    TEST_ASSERT_EQUAL(FXL_E_RANGE, fxl_measure_text("x", &style, &size));
    font.count = 224; /* up to the last byte that a character can be */
    TEST_ASSERT_EQUAL(FXL_OK, fxl_measure_text("x", &style, &size));
    size = (fxl_text_size){1, 2};
    font.count = 31; /* without the question mark */
    TEST_ASSERT_EQUAL(FXL_E_RANGE, text_at(1, FIRST, "x", &style));
    font.unknown = 31;
    TEST_ASSERT_EQUAL(FXL_E_RANGE, text_at(1, FIRST, "x", &style));
    font.bits = NULL;
    TEST_ASSERT_EQUAL(FXL_E_ARGUMENT, text_at(1, FIRST, "x", &style));
    font = fxl_font_5x7;
    font.glyphs = NULL;
    TEST_ASSERT_EQUAL(FXL_E_ARGUMENT, fxl_measure_text("x", &style, &size));
    style.font = NULL;
    TEST_ASSERT_EQUAL(FXL_E_ARGUMENT, fxl_measure_text("x", &style, &size));
    TEST_ASSERT_TRUE(size.width == 1 && size.height == 2);
    expect_wanted();
}

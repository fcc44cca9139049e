/* SPDX-License-Identifier: MIT */
/* Shapes, sprites and text that are drawn over a picture: each function against its definition,
 * pixel by pixel, in a band whose neighbours must stay as they are; and what is refused. */
#include "overlay_unit.h"

void setUp(void)
{
    overlay_begin();
}

/* In both formats. */
static fxl_status rectangle(int32_t x, int32_t y, int32_t width, int32_t height, uint8_t colour)
{
    const fxl_status status = fxl_draw_rectangle(&overlay_band, x, y, width, height, colour);
    TEST_ASSERT_EQUAL(status, fxl_draw_rectangle(&overlay_band_565, x, y, width, height, colour));
    return status;
}

static fxl_status border(int32_t x, int32_t y, int32_t width, int32_t height, uint8_t colour)
{
    const fxl_status status = fxl_draw_border(&overlay_band, x, y, width, height, colour);
    TEST_ASSERT_EQUAL(status, fxl_draw_border(&overlay_band_565, x, y, width, height, colour));
    return status;
}

static fxl_status line(int32_t x0, int32_t y0, int32_t x1, int32_t y1, uint8_t colour)
{
    const fxl_status status = fxl_draw_line(&overlay_band, x0, y0, x1, y1, colour);
    TEST_ASSERT_EQUAL(status, fxl_draw_line(&overlay_band_565, x0, y0, x1, y1, colour));
    return status;
}

/* overlay 1.1a-b, 1.2a, 1.3a-b, 1.4b, accuracy 1.2m */
void test_rectangles_and_borders_are_what_they_say(void)
{
    for (int i = 0; i < UNIT_REPEAT / 30; i++) {
        const int32_t x = overlay_any(), y = overlay_any(), width = overlay_any(),
                      height = overlay_any();
        const bool is_border = unit_random() % 2;
        for (int32_t row = OVERLAY_FIRST; row < OVERLAY_FIRST + OVERLAY_HEIGHT; row++) {
            for (int32_t column = 0; column < OVERLAY_WIDTH; column++) {
                const int64_t right = (int64_t)x + width - 1, bottom = (int64_t)y + height - 1;
                if (column >= x && column <= right && row >= y && row <= bottom &&
                    (!is_border || column == x || column == right || row == y || row == bottom)) {
                    overlay_want(column, row, 7);
                }
            }
        }
        TEST_ASSERT_EQUAL(FXL_OK, is_border ? border(x, y, width, height, 7)
                                            : rectangle(x, y, width, height, 7));
        overlay_expect_wanted();
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
        overlay_want(steep ? x0 + across : at, steep ? at : y0 + across, 9);
    }
}

/* overlay 1.2b, 2.1b-d */
void test_lines_follow_their_rule_in_either_direction(void)
{
    for (int i = 0; i < UNIT_REPEAT / 30; i++) {
        int32_t at[4];
        for (int k = 0; k < 4; k++) {
            at[k] = unit_random() % 4 ? overlay_any() / 4 : unit_between(-30, 50);
            at[k] = at[k] > FXL_LINE_COORDINATE_MAX    ? FXL_LINE_COORDINATE_MAX
                    : at[k] < -FXL_LINE_COORDINATE_MAX ? -FXL_LINE_COORDINATE_MAX
                                                       : at[k];
        }
        want_line(at[0], at[1], at[2], at[3]);
        TEST_ASSERT_EQUAL(FXL_OK, line(at[0], at[1], at[2], at[3], 9));
        overlay_expect_equal();
        overlay_clear();
        TEST_ASSERT_EQUAL(FXL_OK, line(at[2], at[3], at[0], at[1], 9));
        overlay_expect_wanted();
    }
}

/* overlay 2.1a */
void test_a_line_has_both_its_ends(void)
{
    TEST_ASSERT_EQUAL(FXL_OK, line(3, 7, 3, 7, 1));
    overlay_want(3, 7, 1);
    overlay_expect_wanted();
    TEST_ASSERT_EQUAL(FXL_OK, line(2, 9, 5, 10, 1));
    overlay_want(2, 9, 1);
    overlay_want(3, 9, 1);
    overlay_want(4, 10, 1);
    overlay_want(5, 10, 1);
    overlay_expect_wanted();
    const int32_t far = FXL_LINE_COORDINATE_MAX;
    TEST_ASSERT_EQUAL(FXL_E_RANGE, line(far + 1, 0, 0, 0, 1));
    TEST_ASSERT_EQUAL(FXL_E_RANGE, line(0, -far - 1, 0, 0, 1));
    TEST_ASSERT_EQUAL(FXL_E_RANGE, line(0, 0, INT32_MIN, 0, 1));
    TEST_ASSERT_EQUAL(FXL_E_RANGE, line(0, 0, 0, INT32_MAX, 1));
    overlay_expect_wanted();
    TEST_ASSERT_EQUAL(FXL_OK, line(-far, -far + 1, far, far, 9));
    want_line(-far, -far + 1, far, far);
    overlay_expect_wanted();
}

/* billboards 3.2b */
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
        const int32_t x = overlay_any(), y = overlay_any();
        overlay_want_sprite(x, y, &sprite);
        TEST_ASSERT_EQUAL(FXL_OK, overlay_sprite_at(x, y, &sprite));
        overlay_expect_wanted();
    }
}

/* A picture that takes 65,535 columns: only those of the band are read. */
void test_a_sprite_may_be_wider_than_the_band(void)
{
    static const uint8_t row[8192] = {[512] = 0x0F, [513] = 0xFF, [514] = 0xC0};
    const uint8_t colours[2] = {3, 4};
    const fxl_sprite sprite = {row, colours, 65535, 1, 1, 0};
    TEST_ASSERT_EQUAL(FXL_OK, overlay_sprite_at(-4096, OVERLAY_FIRST + 2, &sprite));
    for (int32_t x = 4; x < 18; x++) {
        overlay_want(x, OVERLAY_FIRST + 2, 4);
    }
    overlay_expect_wanted();
}

static void expect_refused_by_all(fxl_status status, const fxl_band *wrong)
{
    static const uint8_t pixel[1] = {1};
    const fxl_sprite sprite = {pixel, NULL, 1, 1, 8, FXL_SPRITE_OPAQUE};
    const fxl_text_style style = {&fxl_font_5x7, 1, 0};
    TEST_ASSERT_EQUAL(status, fxl_draw_rectangle(wrong, 0, 0, 40, 40, 1));
    TEST_ASSERT_EQUAL(status, fxl_draw_border(wrong, 0, 0, 40, 40, 1));
    TEST_ASSERT_EQUAL(status, fxl_draw_line(wrong, 0, 0, 40, 40, 1));
    TEST_ASSERT_EQUAL(status, fxl_draw_sprite(wrong, 1, OVERLAY_FIRST, &sprite));
    TEST_ASSERT_EQUAL(status, fxl_draw_text(wrong, 1, OVERLAY_FIRST, "x", &style));
    overlay_expect_wanted();
}

/* Everything at once, in a band of some columns: the pixels of the band of all of them. */
/* overlay 1.1d */
void test_a_band_of_some_columns(void)
{
    static const uint8_t row[2] = {0xA5, 0x3C};
    const fxl_sprite sprite = {row, NULL, 8, 2, 1, 0};
    const fxl_text_style style = {&fxl_font_5x7, 5, 0};
    for (int i = 0; i < UNIT_REPEAT / 100; i++) {
        fxl_band parts[2] = {overlay_band, overlay_band_565};
        const int32_t first = unit_between(0, OVERLAY_WIDTH - 1);
        const int32_t columns = unit_between(1, OVERLAY_WIDTH - first);
        int32_t at[8];
        for (int k = 0; k < 8; k++) {
            at[k] = unit_between(-12, 40);
        }
        for (int k = 0; k < 3; k++) {
            const fxl_band *into = k < 2 ? &parts[k] : &overlay_band;
            if (k < 2) {
                parts[k].first_column = (uint16_t)first;
                parts[k].columns = (uint16_t)columns;
                parts[k].pixels += (uint32_t)first << k;
            } else {
                memcpy(overlay_wanted, overlay_drawn, sizeof overlay_drawn);
                memset(overlay_drawn, OVERLAY_GROUND, sizeof overlay_drawn);
            }
            TEST_ASSERT_EQUAL(FXL_OK, fxl_draw_rectangle(into, at[0], at[1], at[2], at[3], 7));
            TEST_ASSERT_EQUAL(FXL_OK, fxl_draw_border(into, at[1], at[2], at[3], at[4], 8));
            TEST_ASSERT_EQUAL(FXL_OK, fxl_draw_line(into, at[4], at[5], at[6], at[7], 9));
            TEST_ASSERT_EQUAL(FXL_OK, fxl_draw_sprite(into, at[7], at[0], &sprite));
            TEST_ASSERT_EQUAL(FXL_OK, fxl_draw_text(into, at[3], at[6], "Wg", &style));
        }
        for (int32_t y = 0; y < OVERLAY_HEIGHT; y++) {
            for (int32_t x = 0; x < OVERLAY_STRIDE; x++) {
                const bool inside = x >= first && x < first + columns;
                const uint8_t colour = inside ? overlay_drawn[y][x] : OVERLAY_GROUND;
                TEST_ASSERT_EQUAL_HEX8(colour, overlay_wanted[y][x]);
                TEST_ASSERT_EQUAL_HEX16(overlay_colour_of(colour), overlay_drawn_565[y][x]);
            }
        }
        overlay_begin();
    }
}

/* overlay 1.3c */
void test_bands_that_are_none_are_refused(void)
{
    const fxl_band bad[] = {{.pixels = overlay_drawn[1],
                             .width = 0,
                             .stride = OVERLAY_STRIDE,
                             .first_row = 0,
                             .rows = 1},
                            {.pixels = overlay_drawn[1],
                             .width = FXL_SCREEN_MAX + 1,
                             .stride = 2000,
                             .first_row = 0,
                             .rows = 1},
                            {.pixels = overlay_drawn[1],
                             .width = OVERLAY_WIDTH,
                             .stride = OVERLAY_WIDTH - 1,
                             .first_row = 0,
                             .rows = 1},
                            {.pixels = overlay_drawn[1],
                             .width = OVERLAY_WIDTH,
                             .stride = OVERLAY_STRIDE,
                             .first_row = 0,
                             .rows = 0},
                            {.pixels = overlay_drawn[1],
                             .width = OVERLAY_WIDTH,
                             .stride = OVERLAY_STRIDE,
                             .first_row = 1000,
                             .rows = 25}};
    for (size_t i = 0; i < sizeof bad / sizeof bad[0]; i++) {
        expect_refused_by_all(FXL_E_RANGE, &bad[i]);
    }
    fxl_band beyond = overlay_band;
    beyond.first_column = 1;
    beyond.columns = OVERLAY_WIDTH;
    expect_refused_by_all(FXL_E_RANGE, &beyond);
    uint8_t pixel = 5;
    const fxl_band least = UNIT_BAND(&pixel, 1, FXL_SCREEN_MAX - 1, 1); /* the last row there is */
    TEST_ASSERT_EQUAL(FXL_OK, fxl_draw_rectangle(&least, -3, FXL_SCREEN_MAX - 1, 9, 9, 7));
    TEST_ASSERT_EQUAL_UINT8(7, pixel);
    fxl_band odd = overlay_band_565;
    odd.pixels++;
    expect_refused_by_all(FXL_E_ALIGNMENT, &odd);
    const fxl_band none = {.pixels = NULL,
                           .width = OVERLAY_WIDTH,
                           .stride = OVERLAY_STRIDE,
                           .first_row = 0,
                           .rows = 1};
    expect_refused_by_all(FXL_E_ARGUMENT, &none);
    expect_refused_by_all(FXL_E_ARGUMENT, NULL);
}

void test_sprites_and_fonts_that_are_none_are_refused(void)
{
    fxl_sprite sprite = {NULL, NULL, 1, 1, 8, FXL_SPRITE_OPAQUE};
    TEST_ASSERT_EQUAL(FXL_E_ARGUMENT, overlay_sprite_at(1, OVERLAY_FIRST, &sprite));
    TEST_ASSERT_EQUAL(FXL_E_ARGUMENT, overlay_sprite_at(1, OVERLAY_FIRST, NULL));
    sprite.pixels = overlay_drawn[0];
    sprite.bits = 2;
    TEST_ASSERT_EQUAL(FXL_E_RANGE, overlay_sprite_at(1, OVERLAY_FIRST, &sprite));
    fxl_font font = fxl_font_5x7;
    fxl_text_style style = {&font, 1, 0};
    fxl_text_size size = {1, 2};
    TEST_ASSERT_EQUAL(FXL_E_ARGUMENT, fxl_measure_text("x", &style, NULL));
    TEST_ASSERT_EQUAL(FXL_E_ARGUMENT, fxl_measure_text(NULL, &style, &size));
    TEST_ASSERT_EQUAL(FXL_E_ARGUMENT, overlay_text_at(1, OVERLAY_FIRST, "x", NULL));
    font.count = 0;
    TEST_ASSERT_EQUAL(FXL_E_RANGE, fxl_measure_text("x", &style, &size));
    font.count = 225;
    TEST_ASSERT_EQUAL(FXL_E_RANGE, fxl_measure_text("x", &style, &size));
    font.count = 224; /* up to the last byte that a character can be */
    TEST_ASSERT_EQUAL(FXL_OK, fxl_measure_text("x", &style, &size));
    size = (fxl_text_size){1, 2};
    font.count = 31; /* without the question mark */
    TEST_ASSERT_EQUAL(FXL_E_RANGE, overlay_text_at(1, OVERLAY_FIRST, "x", &style));
    font.unknown = 31;
    TEST_ASSERT_EQUAL(FXL_E_RANGE, overlay_text_at(1, OVERLAY_FIRST, "x", &style));
    font.bits = NULL;
    TEST_ASSERT_EQUAL(FXL_E_ARGUMENT, overlay_text_at(1, OVERLAY_FIRST, "x", &style));
    font = fxl_font_5x7;
    font.glyphs = NULL;
    TEST_ASSERT_EQUAL(FXL_E_ARGUMENT, fxl_measure_text("x", &style, &size));
    style.font = NULL;
    TEST_ASSERT_EQUAL(FXL_E_ARGUMENT, fxl_measure_text("x", &style, &size));
    TEST_ASSERT_TRUE(size.width == 1 && size.height == 2);
    overlay_expect_wanted();
}

static void expect_text(const fxl_text_style *style, const char *text, const char *const *rows,
                        int32_t count)
{
    TEST_ASSERT_EQUAL(FXL_OK, overlay_text_at(1, OVERLAY_FIRST, text, style));
    for (int32_t row = 0; row < count; row++) {
        for (int32_t column = 0; rows[row][column] != '\0'; column++) {
            if (rows[row][column] == 'X') {
                overlay_want(1 + column, OVERLAY_FIRST + row, style->colour);
            }
        }
    }
    overlay_expect_wanted();
}

/* overlay 4.1a, 4.1c-d */
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
/* overlay 4.1b */
void test_a_character_may_begin_beside_the_pen(void)
{
    static const uint8_t bits[] = {0x80};
    static const fxl_glyph glyphs[] = {
        {.first_byte = 0, .width = 1, .height = 1, .left = 2, .top = 1, .advance = 4},
        {.first_byte = 0, .width = 1, .height = 1, .left = -1, .top = -1, .advance = 4}};
    static const fxl_font font = {
        .glyphs = glyphs, .bits = bits, .first = 'a', .count = 2, .unknown = 'a', .line_height = 3};
    const fxl_text_style style = {&font, 5, 0}, fixed = {&font, 6, 7};
    TEST_ASSERT_EQUAL(FXL_OK, overlay_text_at(2, OVERLAY_FIRST + 1, "ab", &style));
    overlay_want(4, OVERLAY_FIRST + 2, 5);
    overlay_want(5, OVERLAY_FIRST, 5);
    overlay_expect_wanted();
    TEST_ASSERT_EQUAL(FXL_OK, overlay_text_at(2, OVERLAY_FIRST + 1, "ab", &fixed));
    overlay_want(5, OVERLAY_FIRST + 2,
                 6); /* one of the three pixels that are over is to the left */
    overlay_want(9, OVERLAY_FIRST, 6);
    overlay_expect_wanted();
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
    TEST_ASSERT_EQUAL(FXL_OK, overlay_text_at(2, OVERLAY_FIRST + 1, text, &style));
    overlay_want(2, OVERLAY_FIRST + 1, 5);
    overlay_want(2 + 3 + 2, OVERLAY_FIRST + 2, 5);
    overlay_want(2 + 3 + 4, OVERLAY_FIRST + 1, 5);
    overlay_want(2 + 3 + 4 + 3, OVERLAY_FIRST + 1, 5);
    overlay_expect_wanted();
}

/* The same text through its sprites. */
/* overlay 4.2, 4.1c */
void test_text_anywhere_is_its_characters_side_by_side(void)
{
    static const uint8_t mask[2] = {0, 8};
    for (int i = 0; i < UNIT_REPEAT / 100; i++) {
        char text[6];
        const int32_t cell = i % 2 ? unit_between(1, 9) : 0; /* characters advance by 2 to 6 */
        const fxl_text_style style = {&fxl_font_5x7, 8, (uint8_t)cell};
        const int32_t x = overlay_any(), y = overlay_any();
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
            overlay_want_sprite(pen + right, top + glyph->top, &picture);
            pen += cell != 0 ? cell : glyph->advance;
            width += (uint32_t)(cell != 0 ? cell : glyph->advance);
            widest = width > widest ? width : widest;
        }
        text[5] = '\0';
        TEST_ASSERT_EQUAL(FXL_OK, overlay_text_at(x, y, text, &style));
        overlay_expect_wanted();
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

/* overlay 4.2a-b */
void test_a_cell_measures_its_width(void)
{
    const fxl_text_style fixed = {&fxl_font_5x7, 6, 9};
    fxl_text_size size;
    TEST_ASSERT_EQUAL(FXL_OK, fxl_measure_text("a\nbcd", &fixed, &size));
    TEST_ASSERT_EQUAL_UINT32(27, size.width);
    TEST_ASSERT_EQUAL_UINT32(18, size.height);
}

/* SPDX-License-Identifier: MIT */
/* Text that is drawn over a picture, and fonts, pixel by pixel. */
#include "overlay_unit.h"

void setUp(void)
{
    overlay_begin();
}

void tearDown(void)
{
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
/* overlay 4.2 */
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

/* overlay 4.2 */
void test_a_cell_measures_its_width(void)
{
    const fxl_text_style fixed = {&fxl_font_5x7, 6, 9};
    fxl_text_size size;
    TEST_ASSERT_EQUAL(FXL_OK, fxl_measure_text("a\nbcd", &fixed, &size));
    TEST_ASSERT_EQUAL_UINT32(27, size.width);
    TEST_ASSERT_EQUAL_UINT32(18, size.height);
}

/* SPDX-License-Identifier: MIT */
/* The panel of dark and light against a controller that the test plays. */
#include <string.h>

#include "fixel/pixels.h"
#include "parts/ssd0303.h"
#include "unity.h"

#define WIDTH       SSD0303_WIDTH
#define HEIGHT      SSD0303_HEIGHT
#define PAGES       8u
#define COLUMNS     132u
#define LEFT        36u /* the module's first column */
#define SIDE_MAX    130u
#define NEVER       UINT32_MAX
#define TWO_BYTES   "\x81\xA8\xAD\xD3\xD5\xD8\xD9\xDA\xDB"
#define ONE_BYTE_UP "\xA1\xA4\xA6\xAE\xAF\xC8"

static struct {
    uint8_t memory[PAGES][COLUMNS];
    uint32_t page, column;
    bool on, wants_argument;
    uint32_t sends, refuse_send;
} oled;

static uint8_t palette[768], frame[SIDE_MAX * SIDE_MAX], pixel_bits;
static uint16_t frame_565[SIDE_MAX * SIDE_MAX];

static void take_command(uint8_t command)
{
    if (oled.wants_argument) {
        oled.wants_argument = false;
    } else if (command < 0x10) {
        oled.column = (oled.column & 0xF0u) | command;
    } else if (command < 0x20) {
        oled.column = (oled.column & 0x0Fu) | (command & 15u) << 4;
    } else if (command >= 0xB0 && command < 0xB8) {
        oled.page = command & 7u;
    } else if (strchr(TWO_BYTES, command) != NULL) {
        oled.wants_argument = true;
    } else if (command != 0x40) {
        TEST_ASSERT_NOT_NULL_MESSAGE(strchr(ONE_BYTE_UP, command), "no such command");
        oled.on = command == 0xAF || (oled.on && command != 0xAE);
    }
}

bool ssd0303_send(const uint8_t *bytes, size_t size)
{
    size_t i;

    if (oled.sends++ == oled.refuse_send) {
        return false;
    }
    TEST_ASSERT_GREATER_OR_EQUAL(2, size);
    if (bytes[0] == 0x80) {
        TEST_ASSERT_EQUAL_MESSAGE(2, size, "one command a message");
        take_command(bytes[1]);
        return true;
    }
    TEST_ASSERT_EQUAL_HEX8(0x40, bytes[0]);
    for (i = 1; i < size; i++) {
        TEST_ASSERT_LESS_THAN(COLUMNS, oled.column);
        oled.memory[oled.page][oled.column++] = bytes[i];
    }
    return true;
}

void setUp(void)
{
    uint32_t i;

    memset(&oled, 0, sizeof oled);
    memset(oled.memory, 0xA5, sizeof oled.memory);
    oled.refuse_send = NEVER;
    for (i = 0; i < sizeof palette; i++) {
        palette[i] = (uint8_t)(i * 11u);
    }
    for (i = 0; i < sizeof frame; i++) {
        frame[i] = (uint8_t)(i * 53u + i / 97u);
        frame_565[i] = (uint16_t)(i * 40503u);
    }
    pixel_bits = 8;
}

void tearDown(void)
{
}

static panel_answer open_panel(uint32_t width, uint32_t height)
{
    const panel_format format = {palette, 1, (uint16_t)width, (uint16_t)height, pixel_bits};

    return ssd0303_panel.open(&format);
}

/* A frame in bands, each drawn over as soon as it is the caller's again. */
static bool show(uint32_t width, uint32_t height, uint32_t rows)
{
    static const fxl_counters counters;
    static uint16_t lent[SIDE_MAX * SIDE_MAX];
    const uint32_t row_bytes = width * pixel_bits / 8u;
    const uint8_t *const shown = pixel_bits == 16 ? (const uint8_t *)frame_565 : frame;
    uint32_t y;

    for (y = 0; y < height; y += rows) {
        const uint32_t count = rows < height - y ? rows : height - y;

        memcpy(lent, shown + y * row_bytes, count * row_bytes);
        if (!ssd0303_panel.flush(0, (uint16_t)y, (uint16_t)width, (uint16_t)count, lent)) {
            return false;
        }
        memset(lent, 0, count * row_bytes);
    }
    return ssd0303_panel.end(&counters, 0, 0);
}

static void assert_middle_shown(uint32_t width, uint32_t height)
{
    const uint32_t left = (width - WIDTH) / 2u, top = (height - HEIGHT) / 2u;
    uint16_t table[256];
    uint32_t x, y;

    fxl_grey_table(table, palette, 1);
    for (y = 0; y < HEIGHT; y++) {
        for (x = 0; x < WIDTH; x++) {
            const uint32_t place = (top + y) * width + left + x;
            const uint16_t entry = pixel_bits == 16 ? fxl_grey_of_rgb565(frame_565[place], 1)
                                                    : table[frame[place]];
            const uint32_t bit = (uint32_t)oled.memory[y / 8u][LEFT + x] >> (y % 8u) & 1u;

            TEST_ASSERT_EQUAL(fxl_grey_level(entry, left + x, top + y), bit);
        }
    }
}

void test_it_is_dark_and_on_when_it_is_open(void)
{
    uint32_t page;

    TEST_ASSERT_EQUAL(PANEL_READY, open_panel(WIDTH, HEIGHT));
    TEST_ASSERT_TRUE(oled.on);
    for (page = 0; page < HEIGHT / 8u; page++) {
        TEST_ASSERT_EACH_EQUAL_HEX8(0, &oled.memory[page][LEFT], WIDTH);
    }
}

void test_the_middle_of_frames_of_many_sizes_in_bands_of_many_heights(void)
{
    static const uint32_t sizes[][2] = {{96, 16}, {97, 17}, {130, 61}, {96, 130}, {129, 16}};
    uint32_t i, rows;

    for (i = 0; i < sizeof sizes / sizeof sizes[0]; i++) {
        for (rows = 1; rows <= sizes[i][1]; rows += 5) {
            setUp();
            TEST_ASSERT_EQUAL(PANEL_READY, open_panel(sizes[i][0], sizes[i][1]));
            TEST_ASSERT_TRUE(show(sizes[i][0], sizes[i][1], rows));
            assert_middle_shown(sizes[i][0], sizes[i][1]);
        }
    }
}

void test_the_middle_of_frames_of_rgb565(void)
{
    pixel_bits = 16;
    TEST_ASSERT_EQUAL(PANEL_READY, open_panel(97, 19));
    TEST_ASSERT_TRUE(show(97, 19, 5));
    assert_middle_shown(97, 19);
}

void test_other_frames_are_not_for_it_and_leave_it_alone(void)
{
    TEST_ASSERT_EQUAL(PANEL_UNSUITABLE, open_panel(WIDTH - 1u, HEIGHT));
    TEST_ASSERT_EQUAL(PANEL_UNSUITABLE, open_panel(WIDTH, HEIGHT - 1u));
    TEST_ASSERT_EQUAL(0, oled.sends);
}

void test_a_display_that_is_not_there_is_left_out(void)
{
    oled.refuse_send = 0;
    TEST_ASSERT_EQUAL(PANEL_UNSUITABLE, open_panel(WIDTH, HEIGHT));
    TEST_ASSERT_EQUAL(1, oled.sends);
}

void test_a_display_that_stops_answering_fails(void)
{
    uint32_t sends, n;

    TEST_ASSERT_EQUAL(PANEL_READY, open_panel(WIDTH, HEIGHT));
    TEST_ASSERT_TRUE(show(WIDTH, HEIGHT, 5));
    sends = oled.sends;
    for (n = 1; n < sends; n++) {
        panel_answer answer;

        setUp();
        oled.refuse_send = n;
        answer = open_panel(WIDTH, HEIGHT);
        TEST_ASSERT_NOT_EQUAL(PANEL_UNSUITABLE, answer);
        if (answer == PANEL_READY) {
            TEST_ASSERT_FALSE(show(WIDTH, HEIGHT, 5));
        }
        TEST_ASSERT_EQUAL_MESSAGE(n + 1u, oled.sends, "it went on after a failure");
    }
}

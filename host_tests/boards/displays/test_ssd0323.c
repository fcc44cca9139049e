/* SPDX-License-Identifier: MIT */
/* The panel of 16 greys against a controller that the test plays: what ends up
 * in its memory, and what becomes of wires that fail. */
#include <string.h>

#include "fixel/pixels.h"
#include "parts/ssd0323.h"
#include "unity.h"

#define WIDTH   SSD0323_WIDTH
#define HEIGHT  SSD0323_HEIGHT
#define COLUMNS (WIDTH / 2u)
#define ROWS    80u /* of the controller's memory */
#define NEVER   UINT32_MAX

static struct {
    uint8_t memory[ROWS][COLUMNS];
    uint32_t columns[2], rows[2], column, row;
    bool open, on, refuse_open;
    uint32_t sends, refuse_send;
} oled;

static uint8_t palette[768], frame[HEIGHT][WIDTH], pixel_bits;
static uint16_t frame_565[HEIGHT][WIDTH];

bool ssd0323_wires_open(void)
{
    oled.open = !oled.refuse_open;
    return oled.open;
}

/* Bytes of a command, its own included. */
static uint32_t length_of(uint8_t command)
{
    static const uint8_t two[] = {0x81, 0xA0, 0xA1, 0xA2, 0xA8, 0xAD,
                                  0xB1, 0xB2, 0xB3, 0xBC, 0xBE, 0xBF};
    static const uint8_t one[] = {0x84, 0x85, 0x86, 0xA4, 0xA5, 0xA6, 0xA7, 0xAE, 0xAF};

    if (command == 0x15 || command == 0x75) {
        return 3;
    }
    if (command == 0xB8) {
        return 9;
    }
    if (memchr(two, command, sizeof two) != NULL) {
        return 2;
    }
    TEST_ASSERT_NOT_NULL_MESSAGE(memchr(one, command, sizeof one), "no such command");
    return 1;
}

static void set_range(uint32_t *range, uint32_t *at, const uint8_t *command, uint32_t limit)
{
    range[0] = *at = command[1];
    range[1] = command[2];
    TEST_ASSERT_LESS_OR_EQUAL(range[1], range[0]);
    TEST_ASSERT_LESS_THAN(limit, range[1]);
}

static void take_command(const uint8_t *command)
{
    if (command[0] == 0x15) {
        set_range(oled.columns, &oled.column, command, COLUMNS);
    } else if (command[0] == 0x75) {
        set_range(oled.rows, &oled.row, command, ROWS);
    } else if (command[0] == 0xA0) {
        TEST_ASSERT_EQUAL_MESSAGE(0, command[1] & 4u, "it would count down the columns");
    } else if (command[0] == 0xAE || command[0] == 0xAF) {
        oled.on = command[0] == 0xAF;
    }
}

static void take_data(uint8_t byte)
{
    oled.memory[oled.row][oled.column] = byte;
    if (oled.column++ == oled.columns[1]) {
        oled.column = oled.columns[0];
        oled.row = oled.row == oled.rows[1] ? oled.rows[0] : oled.row + 1u;
    }
}

bool ssd0323_send(ssd0323_kind kind, const uint8_t *bytes, size_t size)
{
    size_t i = 0;

    TEST_ASSERT_TRUE(oled.open);
    if (oled.sends++ == oled.refuse_send) {
        return false;
    }
    if (kind == SSD0323_DATA) {
        for (i = 0; i < size; i++) {
            take_data(bytes[i]);
        }
        return true;
    }
    while (i < size) {
        const uint32_t length = length_of(bytes[i]);

        TEST_ASSERT_LESS_OR_EQUAL(size - i, length);
        take_command(&bytes[i]);
        i += length;
    }
    return true;
}

void setUp(void)
{
    uint32_t i;

    memset(&oled, 0, sizeof oled);
    memset(oled.memory, 0xA5, sizeof oled.memory);
    oled.columns[1] = COLUMNS - 1u;
    oled.rows[1] = ROWS - 1u;
    oled.refuse_send = NEVER;
    for (i = 0; i < sizeof palette; i++) {
        palette[i] = (uint8_t)(i * 7u);
    }
    for (i = 0; i < WIDTH * HEIGHT; i++) {
        frame[i / WIDTH][i % WIDTH] = (uint8_t)(i * 37u + i / WIDTH);
        frame_565[i / WIDTH][i % WIDTH] = (uint16_t)(i * 40503u);
    }
    pixel_bits = 8;
}

void tearDown(void)
{
}

static panel_answer open_panel(uint16_t width, uint16_t height)
{
    const panel_format format = {palette, 1, width, height, pixel_bits};

    return ssd0323_panel.open(&format);
}

/* A frame in bands, each drawn over as soon as it is the caller's again. */
static bool flush_frame(uint32_t rows)
{
    static uint16_t lent[HEIGHT * WIDTH];
    const uint32_t row_bytes = WIDTH * pixel_bits / 8u;
    uint32_t y;

    for (y = 0; y < HEIGHT; y += rows) {
        const uint32_t count = rows < HEIGHT - y ? rows : HEIGHT - y;

        memcpy(lent, pixel_bits == 16 ? (const void *)frame_565[y] : (const void *)frame[y],
               count * row_bytes);
        if (!ssd0323_panel.flush(0, (uint16_t)y, WIDTH, (uint16_t)count, lent)) {
            return false;
        }
        memset(lent, 0, count * row_bytes);
    }
    return true;
}

static void assert_shown(void)
{
    uint16_t table[256];
    uint32_t x, y;

    fxl_grey_table(table, palette, 15);
    for (y = 0; y < HEIGHT; y++) {
        for (x = 0; x < WIDTH; x++) {
            const uint32_t byte = oled.memory[y][x / 2u];

            const uint16_t entry = pixel_bits == 16 ? fxl_grey_of_rgb565(frame_565[y][x], 15)
                                                    : table[frame[y][x]];

            TEST_ASSERT_EQUAL(fxl_grey_level(entry, x, y),
                              x % 2u == 0 ? byte >> 4 : byte & 15u);
        }
    }
}

void test_it_is_dark_and_on_when_it_is_open(void)
{
    uint32_t y;

    TEST_ASSERT_EQUAL(PANEL_READY, open_panel(WIDTH, HEIGHT));
    TEST_ASSERT_TRUE(oled.on);
    for (y = 0; y < HEIGHT; y++) {
        TEST_ASSERT_EACH_EQUAL_HEX8(0, oled.memory[y], COLUMNS);
    }
}

void test_a_frame_in_bands_of_any_height(void)
{
    uint32_t rows;

    for (rows = 1; rows <= HEIGHT; rows++) {
        setUp();
        TEST_ASSERT_EQUAL(PANEL_READY, open_panel(WIDTH, HEIGHT));
        TEST_ASSERT_TRUE(flush_frame(rows));
        assert_shown();
        TEST_ASSERT_TRUE(ssd0323_panel.close(true));
        TEST_ASSERT_TRUE_MESSAGE(oled.on, "the last frame stays");
    }
}

void test_a_frame_of_rgb565(void)
{
    pixel_bits = 16;
    TEST_ASSERT_EQUAL(PANEL_READY, open_panel(WIDTH, HEIGHT));
    TEST_ASSERT_TRUE(flush_frame(7));
    assert_shown();
}

void test_other_frames_are_not_for_it_and_leave_it_alone(void)
{
    TEST_ASSERT_EQUAL(PANEL_UNSUITABLE, open_panel(WIDTH, HEIGHT - 1));
    TEST_ASSERT_EQUAL(PANEL_UNSUITABLE, open_panel(WIDTH + 1, HEIGHT));
    TEST_ASSERT_EQUAL(PANEL_UNSUITABLE, open_panel(320, 240));
    TEST_ASSERT_FALSE(oled.open);
}

void test_wires_that_do_not_open(void)
{
    oled.refuse_open = true;
    TEST_ASSERT_EQUAL(PANEL_FAILED, open_panel(WIDTH, HEIGHT));
}

void test_wires_that_fail_at_any_time(void)
{
    uint32_t sends, n;

    TEST_ASSERT_EQUAL(PANEL_READY, open_panel(WIDTH, HEIGHT));
    TEST_ASSERT_TRUE(flush_frame(16));
    sends = oled.sends;
    for (n = 0; n < sends; n++) {
        setUp();
        oled.refuse_send = n;
        if (open_panel(WIDTH, HEIGHT) == PANEL_READY) {
            TEST_ASSERT_FALSE(flush_frame(16));
        }
        TEST_ASSERT_EQUAL_MESSAGE(n + 1u, oled.sends, "it went on after a failure");
    }
}

/* SPDX-License-Identifier: MIT */
/* The frame dump that boards write: its bytes, and that it gets a tail only
 * where everything came in order and arrived. */
#include <string.h>

#include "contract/display.h"
#include "contract/journal.h"
#include "contract/panel.h"
#include "parts/dump.h"
#include "unity.h"

#define WIDTH  3
#define HEIGHT 2
#define HEAD   (16 + 768)
#define FRAME  (32 + WIDTH * HEIGHT + 48)
#define TAIL   12

static const fxl_pose pose = {{1, -2, 0x01020304}, 5, 6, 0xFFFFFFFFu};
static const fxl_counters counters = {10, 1, 2, 3, 0, 4, 5, 6, 8, 9, 0};
static const uint8_t pixels[WIDTH * HEIGHT] = {1, 2, 3, 4, 5, 6};

static uint8_t palette[768];
static uint8_t written[4096];
static size_t size, room;
static bool was_opened, is_open, was_whole, refuse_open, refuse_close;

const panel *const *board_panels(void)
{
    static const panel *const panels[] = {&dump_panel, NULL};

    return panels;
}

bool sink_open(void)
{
    TEST_ASSERT_FALSE(is_open);
    is_open = was_opened = !refuse_open;
    return is_open;
}

bool sink_write(const void *bytes, size_t count)
{
    TEST_ASSERT_TRUE(is_open);
    if (count > room - size) {
        return false;
    }
    memcpy(written + size, bytes, count);
    size += count;
    return true;
}

bool sink_close(bool whole)
{
    TEST_ASSERT_TRUE(is_open);
    is_open = false;
    was_whole = whole;
    return !refuse_close;
}

void setUp(void)
{
    size_t i;

    for (i = 0; i < sizeof palette; i++) {
        palette[i] = (uint8_t)(i * 5);
    }
    size = 0;
    room = sizeof written;
    was_opened = is_open = was_whole = refuse_open = refuse_close = false;
}

void tearDown(void)
{
    if (is_open) {
        (void)display_close();
    }
}

static void open_dump(uint32_t frames)
{
    TEST_ASSERT_TRUE(journal_open(frames));
    TEST_ASSERT_TRUE(display_open(WIDTH, HEIGHT, 8, palette));
}

static void write_frame(uint32_t number)
{
    TEST_ASSERT_TRUE(journal_begin(number, &pose));
    TEST_ASSERT_TRUE(display_flush(0, 0, WIDTH, 1, pixels));
    TEST_ASSERT_TRUE(display_flush(0, 1, WIDTH, 1, pixels + WIDTH));
    TEST_ASSERT_TRUE(journal_end(&counters, 7, 0x0102030405060708u));
}

static uint32_t u32(size_t at)
{
    return written[at] | (uint32_t)written[at + 1] << 8 | (uint32_t)written[at + 2] << 16 |
           (uint32_t)written[at + 3] << 24;
}

static uint32_t crc_by_bits(const uint8_t *data, size_t count)
{
    uint32_t crc = ~0u;
    size_t i;
    int bit;

    for (i = 0; i < count; i++) {
        crc ^= data[i];
        for (bit = 0; bit < 8; bit++) {
            crc = (crc >> 1) ^ ((crc & 1u) != 0 ? 0xEDB88320u : 0u);
        }
    }
    return ~crc;
}

static void assert_not_whole(void)
{
    TEST_ASSERT_FALSE(display_close());
    TEST_ASSERT_FALSE(was_whole);
    TEST_ASSERT_TRUE(size < TAIL || memcmp(written + size - TAIL, "FEND", 4) != 0);
}

void test_the_bytes_of_a_dump(void)
{
    const size_t frame = HEAD + FRAME;
    const size_t end = frame + 32 + WIDTH * HEIGHT;

    open_dump(2);
    write_frame(0);
    write_frame(1);
    TEST_ASSERT_TRUE(display_close());
    TEST_ASSERT_TRUE(was_whole);
    TEST_ASSERT_EQUAL(HEAD + 2 * FRAME + TAIL, size);
    TEST_ASSERT_EQUAL_MEMORY("FXLD\3\0\3\0\2\0\10\0\2\0\0\0", written, 16);
    TEST_ASSERT_EQUAL_MEMORY(palette, written + 16, sizeof palette);
    TEST_ASSERT_EQUAL_MEMORY(
        "FRAM\1\0\0\0\1\0\0\0\376\377\377\377\4\3\2\1\5\0\0\0\6\0\0\0\377\377\377\377",
        written + frame, 32);
    TEST_ASSERT_EQUAL_MEMORY(pixels, written + frame + 32, sizeof pixels);
    TEST_ASSERT_EQUAL(10, u32(end));
    TEST_ASSERT_EQUAL(4, u32(end + 20)); /* drawn */
    TEST_ASSERT_EQUAL(6, u32(end + 28)); /* refused_calls */
    TEST_ASSERT_EQUAL(8, u32(end + 32)); /* spilled */
    TEST_ASSERT_EQUAL(7, u32(end + 36));
    TEST_ASSERT_EQUAL_HEX32(0x05060708u, u32(end + 40));
    TEST_ASSERT_EQUAL_HEX32(0x01020304u, u32(end + 44));
    TEST_ASSERT_EQUAL_MEMORY("FEND\2\0\0\0", written + size - TAIL, 8);
    TEST_ASSERT_EQUAL_HEX32(crc_by_bits(written, size - 4), u32(size - 4));
}

void test_a_dump_of_16_bits_a_pixel(void)
{
    static const uint16_t colours[WIDTH * HEIGHT] = {0x1234, 0xFFFF, 0, 0x8001};

    TEST_ASSERT_TRUE(journal_open(1));
    TEST_ASSERT_FALSE(display_open(WIDTH, HEIGHT, 12, palette));
    TEST_ASSERT_TRUE(display_open(WIDTH, HEIGHT, 16, palette));
    TEST_ASSERT_TRUE(journal_begin(0, &pose));
    TEST_ASSERT_TRUE(display_flush(0, 0, WIDTH, 1, colours));
    TEST_ASSERT_TRUE(display_flush(0, 1, WIDTH, 1, colours + WIDTH));
    TEST_ASSERT_TRUE(journal_end(&counters, 7, 0));
    TEST_ASSERT_TRUE(display_close());
    TEST_ASSERT_EQUAL(HEAD + FRAME + sizeof colours / 2 + TAIL, size);
    TEST_ASSERT_EQUAL_MEMORY("\20\0", written + 10, 2);
    TEST_ASSERT_EQUAL_MEMORY(colours, written + HEAD + 32, sizeof colours);
}

void test_a_display_before_its_journal_or_without_size_is_refused(void)
{
    TEST_ASSERT_FALSE(display_open(WIDTH, HEIGHT, 8, palette));
    TEST_ASSERT_FALSE(journal_open(0));
    TEST_ASSERT_TRUE(journal_open(1));
    TEST_ASSERT_FALSE(display_open(0, HEIGHT, 8, palette));
    TEST_ASSERT_FALSE(was_opened);
}

void test_a_sink_that_does_not_open(void)
{
    refuse_open = true;
    TEST_ASSERT_TRUE(journal_open(1));
    TEST_ASSERT_FALSE(display_open(WIDTH, HEIGHT, 8, palette));
    TEST_ASSERT_FALSE(display_close());
}

void test_a_frame_out_of_turn(void)
{
    open_dump(2);
    TEST_ASSERT_FALSE(journal_begin(1, &pose));
    assert_not_whole();
}

void test_a_frame_too_many(void)
{
    open_dump(1);
    write_frame(0);
    TEST_ASSERT_FALSE(journal_begin(1, &pose));
    assert_not_whole();
}

void test_a_frame_too_few(void)
{
    open_dump(2);
    write_frame(0);
    assert_not_whole();
}

void test_pixels_outside_a_frame(void)
{
    open_dump(1);
    TEST_ASSERT_FALSE(display_flush(0, 0, WIDTH, HEIGHT, pixels));
    assert_not_whole();
}

/* x, y, width, height of a second rectangle, after row 0. */
static void refuse_rectangle(uint16_t x, uint16_t y, uint16_t width, uint16_t height)
{
    setUp();
    open_dump(1);
    TEST_ASSERT_TRUE(journal_begin(0, &pose));
    TEST_ASSERT_TRUE(display_flush(0, 0, WIDTH, 1, pixels));
    TEST_ASSERT_FALSE(display_flush(x, y, width, height, pixels));
    TEST_ASSERT_FALSE(journal_end(&counters, 0, 0));
    assert_not_whole();
}

void test_rectangles_that_do_not_follow(void)
{
    refuse_rectangle(0, 0, WIDTH, 1);     /* twice */
    refuse_rectangle(0, 1, WIDTH, 2);     /* below the frame */
    refuse_rectangle(0, 1, WIDTH - 1, 1); /* part of a row */
    refuse_rectangle(1, 1, WIDTH - 1, 1);
    refuse_rectangle(0, 1, WIDTH, 0); /* nothing */
}

void test_a_frame_with_rows_missing(void)
{
    open_dump(1);
    TEST_ASSERT_TRUE(journal_begin(0, &pose));
    TEST_ASSERT_TRUE(display_flush(0, 0, WIDTH, 1, pixels));
    TEST_ASSERT_FALSE(journal_end(&counters, 0, 0));
    assert_not_whole();
}

void test_a_sink_that_is_full_at_any_byte_never_gets_a_whole_dump(void)
{
    size_t limit;

    for (limit = 0; limit < HEAD + FRAME + TAIL; limit++) {
        bool good;

        setUp();
        room = limit;
        TEST_ASSERT_TRUE(journal_open(1));
        good = display_open(WIDTH, HEIGHT, 8, palette);
        good = good && journal_begin(0, &pose);
        good = good && display_flush(0, 0, WIDTH, HEIGHT, pixels);
        good = good && journal_end(&counters, 0, 0);
        TEST_ASSERT_TRUE(good || limit < HEAD + FRAME);
        TEST_ASSERT_FALSE(display_close());
        TEST_ASSERT_FALSE(was_whole);
    }
}

void test_a_sink_that_fails_to_close(void)
{
    refuse_close = true;
    open_dump(1);
    write_frame(0);
    TEST_ASSERT_FALSE(display_close());
}

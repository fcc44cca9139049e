/* SPDX-License-Identifier: MIT */
#include "board_double.h"

#include <string.h>

#include "mock_clock.h"
#include "mock_display.h"
#include "mock_input.h"
#include "mock_journal.h"
#include "mock_store.h"
#include "mock_system.h"
#include "unity.h"

board_double board;

static const void *on_store(size_t *size)
{
    *size = board.scene != NULL ? board.scene_size : 0;
    return board.scene != NULL ? board.scene->words : NULL;
}

static bool on_journal_open(uint32_t frames)
{
    TEST_ASSERT_FALSE_MESSAGE(board.display_was_opened, "the journal comes before the display");
    board.announced = frames;
    return !board.refuse_journal;
}

static bool on_display_open(uint16_t width, uint16_t height, uint8_t pixel_bits,
                            const uint8_t *palette)
{
    TEST_ASSERT_EQUAL(SCENE_WIDTH, width);
    TEST_ASSERT_EQUAL(SCENE_HEIGHT, height);
    TEST_ASSERT_EQUAL(8, pixel_bits);
    TEST_ASSERT_EQUAL(7, palette[7]);
    TEST_ASSERT_GREATER_THAN(0, board.announced);
    board.display_was_opened = true;
    board.display_is_open = !board.refuse_display;
    return board.display_is_open;
}

static bool on_journal_begin(uint32_t number, const fxl_pose *pose)
{
    TEST_ASSERT_TRUE(board.display_is_open);
    TEST_ASSERT_FALSE_MESSAGE(board.in_frame, "a frame within a frame");
    TEST_ASSERT_EQUAL(board.begun, number);
    TEST_ASSERT_LESS_THAN(FRAMES_MAX, number);
    board.poses[number] = *pose;
    board.in_frame = true;
    return board.begun++ != board.refuse_begin;
}

static bool on_flush(uint16_t x, uint16_t y, uint16_t width, uint16_t height, const void *pixels)
{
    const uint32_t frame = board.begun - 1;
    uint16_t row;

    TEST_ASSERT_TRUE_MESSAGE(board.in_frame, "pixels outside a frame");
    TEST_ASSERT_EQUAL(0, x);
    TEST_ASSERT_EQUAL(SCENE_WIDTH, width);
    TEST_ASSERT_LESS_OR_EQUAL(SCENE_HEIGHT, y + height);
    if (y > 0) {
        TEST_ASSERT_EQUAL_MESSAGE(1, board.times_covered[frame][y - 1], "not downward");
    }
    for (row = 0; row < height; row++) {
        memcpy(board.pixels[frame][y + row], (const uint8_t *)pixels + (size_t)row * width, width);
        board.times_covered[frame][y + row]++;
    }
    board.clock += board.flush_cost;
    return board.flushes++ != board.refuse_flush;
}

static bool on_journal_end(const fxl_counters *counters, uint32_t clamped, uint64_t instructions)
{
    TEST_ASSERT_TRUE(board.in_frame);
    TEST_ASSERT_EQUAL(0, clamped);
    board.counters[board.ended] = *counters;
    board.instructions[board.ended] = instructions;
    board.in_frame = false;
    return board.ended++ != board.refuse_end;
}

static bool on_display_close(void)
{
    TEST_ASSERT_TRUE_MESSAGE(board.display_is_open, "closed, but was not open");
    board.display_is_open = false;
    return !board.refuse_close;
}

static uint64_t on_clock(void)
{
    board.clock += board.clock_step;
    if (board.clock_read++ == board.clock_backward) {
        board.clock -= 2 * board.clock_step;
    }
    return board.clock;
}

static uint32_t on_keys(void)
{
    const uint32_t frame = board.keys_read++;

    return board.keys_of_frame != NULL ? board.keys_of_frame[frame] : board.keys;
}

static void on_alive(void)
{
    TEST_ASSERT_EQUAL(board.flushes, board.alive); /* once between any two */
    board.alive++;
}

static uint32_t on_frames(void)
{
    return board.frames_asked;
}

static bool on_live(void)
{
    return board.live;
}

static void on_text(const char *text)
{
    TEST_ASSERT_LESS_THAN(sizeof board.text, strlen(board.text) + strlen(text));
    strcat(board.text, text);
}

void board_double_begin(const scene_bytes *scene)
{
    memset(&board, 0, sizeof board);
    board.scene = scene;
    board.scene_size = sizeof scene->words; /* a partition is longer than what is in it */
    board.clock_backward = NEVER;
    board.refuse_begin = board.refuse_flush = board.refuse_end = NEVER;
    store_scene_Stub(on_store);
    journal_open_Stub(on_journal_open);
    journal_begin_Stub(on_journal_begin);
    journal_end_Stub(on_journal_end);
    display_open_Stub(on_display_open);
    display_flush_Stub(on_flush);
    display_close_Stub(on_display_close);
    clock_instructions_Stub(on_clock);
    input_keys_Stub(on_keys);
    system_frames_Stub(on_frames);
    system_live_Stub(on_live);
    system_alive_Stub(on_alive);
    system_text_Stub(on_text);
}

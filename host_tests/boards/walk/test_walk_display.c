/* SPDX-License-Identifier: MIT */
/* One display over the board's panels: who is asked what, in which order, and
 * what becomes of the others when one does not suit or fails. The list of
 * panels is mocked; the panels write down what they are asked. */
#include <string.h>

#include "contract/display.h"
#include "contract/journal.h"
#include "mock_panel.h"
#include "unity.h"

#define WIDTH  4
#define HEIGHT 3
#define NEVER  UINT32_MAX

enum call {
    OPEN,
    BEGIN,
    FLUSH,
    END,
    CLOSE,
    CALLS
};

/* A panel of the tests. */
typedef struct {
    panel_answer answer;    /* to open */
    uint32_t refuse[CALLS]; /* the how-manieth call of each kind fails, from 0 */
    uint32_t calls[CALLS];
    uint32_t frames; /* that were announced */
    uint16_t next_row;
    bool was_whole;
} double_panel;

static double_panel first, second;
static char diary[256]; /* a letter a call, of all panels: upper case for the first */
static uint8_t palette[768];
static const uint8_t pixels[WIDTH * HEIGHT] = {1, 2, 3};
static const fxl_pose pose = {{1, 2, 3}, 4, 5, 6};
static const fxl_counters counters = {.in = 1, .drawn = 1};

static bool note(double_panel *one, enum call call)
{
    static const char letters[2][CALLS + 1] = {"OBFEC", "obfec"};
    const size_t length = strlen(diary);

    TEST_ASSERT_LESS_THAN(sizeof diary - 1, length);
    diary[length] = letters[one == &second][call];
    return one->calls[call]++ != one->refuse[call];
}

static panel_answer open_one(double_panel *one, const panel_format *format)
{
    (void)note(one, OPEN);
    TEST_ASSERT_EQUAL(WIDTH, format->width);
    TEST_ASSERT_EQUAL(HEIGHT, format->height);
    TEST_ASSERT_EQUAL_PTR(palette, format->palette);
    one->frames = format->frames;
    return one->answer;
}

static bool begin_one(double_panel *one, uint32_t number, const fxl_pose *at)
{
    TEST_ASSERT_EQUAL(one->calls[BEGIN], number);
    TEST_ASSERT_EQUAL_PTR(&pose, at);
    return note(one, BEGIN);
}

static bool flush_one(double_panel *one, uint16_t x, uint16_t y, uint16_t width, uint16_t height,
                      const uint8_t *lent)
{
    TEST_ASSERT_EQUAL(0, x);
    TEST_ASSERT_EQUAL(WIDTH, width);
    TEST_ASSERT_EQUAL(one->next_row, y);
    TEST_ASSERT_NOT_NULL(lent);
    one->next_row = (uint16_t)((y + height) % HEIGHT);
    return note(one, FLUSH);
}

static bool end_one(double_panel *one, uint32_t clamped, uint64_t instructions)
{
    TEST_ASSERT_EQUAL(7, clamped);
    TEST_ASSERT_EQUAL_UINT64(1000, instructions);
    return note(one, END);
}

static bool close_one(double_panel *one, bool whole)
{
    one->was_whole = whole;
    return note(one, CLOSE);
}

/* The same five functions for each: a panel's functions have no other handle. */
#define PANEL(name) \
    static panel_answer name##_open(const panel_format *format) \
    { \
        return open_one(&name, format); \
    } \
    static bool name##_begin(uint32_t number, const fxl_pose *at) \
    { \
        return begin_one(&name, number, at); \
    } \
    static bool name##_flush(uint16_t x, uint16_t y, uint16_t width, uint16_t height, \
                             const void *lent) \
    { \
        return flush_one(&name, x, y, width, height, lent); \
    } \
    static bool name##_end(const fxl_counters *all, uint32_t clamped, uint64_t instructions) \
    { \
        TEST_ASSERT_EQUAL_PTR(&counters, all); \
        return end_one(&name, clamped, instructions); \
    } \
    static bool name##_close(bool whole) \
    { \
        return close_one(&name, whole); \
    } \
    static const panel name##_panel = {name##_open, name##_begin, name##_flush, name##_end, \
                                       name##_close};

PANEL(first)
PANEL(second)

static const panel silent_panel = {second_open, NULL, second_flush, NULL, second_close};
static const panel *list[40];

static const panel *const *on_panels(void)
{
    return list;
}

void setUp(void)
{
    memset(&first, 0, sizeof first);
    memset(first.refuse, 0xFF, sizeof first.refuse);
    second = first;
    memset(list, 0, sizeof list);
    memset(diary, 0, sizeof diary);
    list[0] = &first_panel;
    list[1] = &second_panel;
    board_panels_Stub(on_panels);
}

/* Leaves the display closed for the next test. */
void tearDown(void)
{
    (void)display_close();
}

static bool open_display(uint32_t frames)
{
    TEST_ASSERT_TRUE(journal_open(frames));
    return display_open(WIDTH, HEIGHT, 8, palette);
}

/* A frame in two bands. */
static bool show_frame(uint32_t number)
{
    return journal_begin(number, &pose) && display_flush(0, 0, WIDTH, 2, pixels) &&
           display_flush(0, 2, WIDTH, 1, pixels) && journal_end(&counters, 7, 1000);
}

static void assert_closed_once(const double_panel *one, bool whole)
{
    TEST_ASSERT_EQUAL(1, one->calls[CLOSE]);
    TEST_ASSERT_EQUAL(whole, one->was_whole);
}

void test_two_panels_at_once(void)
{
    TEST_ASSERT_TRUE(open_display(2));
    TEST_ASSERT_TRUE(show_frame(0));
    TEST_ASSERT_TRUE(show_frame(1));
    TEST_ASSERT_TRUE(display_close());
    TEST_ASSERT_EQUAL_STRING("OoBbFfFfEeBbFfFfEeCc", diary);
    TEST_ASSERT_EQUAL(2, first.frames);
    TEST_ASSERT_EQUAL(2, second.frames);
    assert_closed_once(&first, true);
    assert_closed_once(&second, true);
}

void test_a_panel_that_does_not_suit_is_left_out(void)
{
    first.answer = PANEL_UNSUITABLE;
    TEST_ASSERT_TRUE(open_display(1));
    TEST_ASSERT_TRUE(show_frame(0));
    TEST_ASSERT_TRUE(display_close());
    TEST_ASSERT_EQUAL_STRING("Oobffec", diary);
    assert_closed_once(&second, true);
}

void test_no_panel_that_suits(void)
{
    first.answer = second.answer = PANEL_UNSUITABLE;
    TEST_ASSERT_FALSE(open_display(1));
    TEST_ASSERT_FALSE(display_close());
    TEST_ASSERT_EQUAL_STRING("Oo", diary);
}

void test_a_board_without_panels(void)
{
    list[0] = NULL;
    TEST_ASSERT_FALSE(open_display(1));
    TEST_ASSERT_EQUAL_STRING("", diary);
}

void test_a_panel_that_fails_to_open_closes_those_before_it(void)
{
    second.answer = PANEL_FAILED;
    TEST_ASSERT_FALSE(open_display(1));
    TEST_ASSERT_FALSE(journal_begin(0, &pose));
    TEST_ASSERT_FALSE(display_close());
    TEST_ASSERT_EQUAL_STRING("OoC", diary);
    assert_closed_once(&first, false);
}

void test_a_panel_without_use_for_the_journal(void)
{
    list[1] = &silent_panel;
    TEST_ASSERT_TRUE(open_display(1));
    TEST_ASSERT_TRUE(show_frame(0));
    TEST_ASSERT_TRUE(display_close());
    TEST_ASSERT_EQUAL_STRING("OoBFfFfECc", diary);
}

/* After its failure a panel gets nothing but close, and so do the others. */
static void fail_in_the_second_frame(double_panel *one, enum call call, uint32_t number,
                                     const char *expected)
{
    setUp();
    one->refuse[call] = number;
    TEST_ASSERT_TRUE(open_display(3));
    TEST_ASSERT_TRUE(show_frame(0));
    TEST_ASSERT_FALSE(show_frame(1));
    TEST_ASSERT_FALSE_MESSAGE(show_frame(1), "it went on");
    TEST_ASSERT_FALSE(display_flush(0, 2, WIDTH, 1, pixels));
    TEST_ASSERT_FALSE(journal_end(&counters, 7, 1000));
    TEST_ASSERT_FALSE(display_close());
    TEST_ASSERT_EQUAL_STRING(expected, diary);
    assert_closed_once(&first, false);
    assert_closed_once(&second, false);
}

void test_a_panel_that_fails_in_the_middle(void)
{
    fail_in_the_second_frame(&first, BEGIN, 1, "OoBbFfFfEeBCc");
    fail_in_the_second_frame(&second, BEGIN, 1, "OoBbFfFfEeBbCc");
    fail_in_the_second_frame(&first, FLUSH, 2, "OoBbFfFfEeBbFCc");
    fail_in_the_second_frame(&second, FLUSH, 3, "OoBbFfFfEeBbFfFfCc");
    fail_in_the_second_frame(&first, END, 1, "OoBbFfFfEeBbFfFfECc");
    fail_in_the_second_frame(&second, END, 1, "OoBbFfFfEeBbFfFfEeCc");
}

void test_a_panel_that_fails_to_close(void)
{
    first.refuse[CLOSE] = 0;
    TEST_ASSERT_TRUE(open_display(1));
    TEST_ASSERT_TRUE(show_frame(0));
    TEST_ASSERT_FALSE(display_close());
    assert_closed_once(&first, true);
    assert_closed_once(&second, false); /* it learns of the first one's failure */
}

/* A second flush, after the first two rows, that is out of order. */
static void flush_out_of_order(uint16_t x, uint16_t y, uint16_t width, uint16_t height)
{
    setUp();
    TEST_ASSERT_TRUE(open_display(1));
    TEST_ASSERT_TRUE(journal_begin(0, &pose));
    TEST_ASSERT_TRUE(display_flush(0, 0, WIDTH, 2, pixels));
    TEST_ASSERT_FALSE(display_flush(x, y, width, height, pixels));
    TEST_ASSERT_FALSE_MESSAGE(display_flush(0, 2, WIDTH, 1, pixels), "it went on");
    TEST_ASSERT_FALSE(display_close());
    TEST_ASSERT_EQUAL_STRING("OoBbFfCc", diary);
    assert_closed_once(&first, false);
}

void test_no_panel_sees_a_flush_out_of_order(void)
{
    flush_out_of_order(0, 0, WIDTH, 2);          /* from the top again */
    flush_out_of_order(0, 1, WIDTH, 1);          /* a row twice */
    flush_out_of_order(0, 3, WIDTH, 1);          /* below the frame */
    flush_out_of_order(0, 2, WIDTH, 2);          /* over its end */
    flush_out_of_order(0, 2, WIDTH, UINT16_MAX); /* no matter how far */
    flush_out_of_order(0, 2, WIDTH, 0);          /* nothing */
    flush_out_of_order(0, 2, WIDTH - 1, 1);      /* part of a row */
    flush_out_of_order(1, 2, WIDTH - 1, 1);
}

void test_no_panel_sees_pixels_outside_a_frame(void)
{
    TEST_ASSERT_TRUE(open_display(1));
    TEST_ASSERT_FALSE(display_flush(0, 0, WIDTH, HEIGHT, pixels));
    TEST_ASSERT_FALSE(display_close());
    TEST_ASSERT_EQUAL_STRING("OoCc", diary);
}

void test_no_panel_sees_the_end_of_a_frame_with_rows_missing(void)
{
    TEST_ASSERT_TRUE(open_display(1));
    TEST_ASSERT_TRUE(journal_begin(0, &pose));
    TEST_ASSERT_TRUE(display_flush(0, 0, WIDTH, 2, pixels));
    TEST_ASSERT_FALSE(journal_end(&counters, 7, 1000));
    TEST_ASSERT_FALSE(display_close());
    TEST_ASSERT_EQUAL_STRING("OoBbFfCc", diary);
}

void test_frames_that_do_not_follow(void)
{
    static const uint32_t wrong[] = {0, 2, UINT32_MAX};
    size_t i;

    for (i = 0; i < sizeof wrong / sizeof wrong[0]; i++) {
        setUp();
        TEST_ASSERT_TRUE(open_display(3));
        TEST_ASSERT_TRUE(show_frame(0));
        TEST_ASSERT_FALSE(journal_begin(wrong[i], &pose));
        TEST_ASSERT_FALSE(display_close());
        TEST_ASSERT_EQUAL_STRING("OoBbFfFfEeCc", diary);
    }
}

void test_a_frame_within_a_frame(void)
{
    TEST_ASSERT_TRUE(open_display(2));
    TEST_ASSERT_TRUE(journal_begin(0, &pose));
    TEST_ASSERT_FALSE(journal_begin(1, &pose));
    TEST_ASSERT_FALSE(display_close());
    TEST_ASSERT_EQUAL_STRING("OoBbCc", diary);
}

void test_a_frame_more_and_a_frame_less_than_announced(void)
{
    TEST_ASSERT_TRUE(open_display(1));
    TEST_ASSERT_TRUE(show_frame(0));
    TEST_ASSERT_FALSE(show_frame(1));
    TEST_ASSERT_FALSE(display_close());
    assert_closed_once(&first, false);
    setUp();
    TEST_ASSERT_TRUE(open_display(2));
    TEST_ASSERT_TRUE(show_frame(0));
    TEST_ASSERT_FALSE(display_close());
    assert_closed_once(&first, false);
}

void test_what_cannot_be_opened_reaches_no_panel(void)
{
    TEST_ASSERT_FALSE(display_open(WIDTH, HEIGHT, 8, palette)); /* nothing was announced */
    TEST_ASSERT_FALSE(journal_open(0));
    TEST_ASSERT_TRUE(journal_open(1));
    TEST_ASSERT_FALSE(display_open(0, HEIGHT, 8, palette));
    TEST_ASSERT_FALSE(display_open(WIDTH, 0, 8, palette));
    TEST_ASSERT_FALSE(display_open(WIDTH, HEIGHT, 8, NULL));
    TEST_ASSERT_EQUAL_STRING("", diary);
    TEST_ASSERT_TRUE(display_open(WIDTH, HEIGHT, 8, palette));
    TEST_ASSERT_FALSE(journal_open(1));
    TEST_ASSERT_FALSE(display_open(WIDTH, HEIGHT, 8, palette));
    TEST_ASSERT_EQUAL_STRING("Oo", diary);
}

void test_a_display_can_be_opened_again(void)
{
    TEST_ASSERT_TRUE(open_display(1));
    TEST_ASSERT_TRUE(journal_begin(0, &pose));
    TEST_ASSERT_FALSE(display_close());
    setUp();
    TEST_ASSERT_TRUE(open_display(1));
    TEST_ASSERT_TRUE(show_frame(0));
    TEST_ASSERT_TRUE(display_close());
    TEST_ASSERT_EQUAL_STRING("OoBbFfFfEeCc", diary);
}

void test_more_panels_than_can_be_served_are_refused(void)
{
    size_t i;

    for (i = 0; i < 33; i++) {
        list[i] = &silent_panel;
    }
    TEST_ASSERT_FALSE(open_display(1));
    TEST_ASSERT_EQUAL(32, second.calls[OPEN]);
    TEST_ASSERT_EQUAL(32, second.calls[CLOSE]);
    list[32] = NULL;
    TEST_ASSERT_TRUE(open_display(1));
}

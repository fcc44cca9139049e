/* SPDX-License-Identifier: MIT */
/* The window: who is let in, that no frame is ever seen half drawn, that the
 * board waits for its viewer. */
#include <string.h>

#include "mock_system.h"
#include "parts/window.h"
#include "unity.h"

#define WIDTH  5
#define HEIGHT 3
#define AREA   (WIDTH * HEIGHT)

/* As long as the linker says that fxl_window_size is. */
_Alignas(4096) uint8_t fxl_window[65536];

static uint8_t palette[768];
static const fxl_pose pose = {{1, -2, 3}, 4, 5, 6};
static const fxl_counters counters = {10, 1, 2, 3, 0, 4, 5, 6, 8, 9, 0};
static window_header *const header = (window_header *)(void *)fxl_window;
static uint32_t naps, signs, naps_until_request;

/* A viewer that asks for one more after a while. */
void window_nap(void)
{
    naps++;
    TEST_ASSERT_LESS_OR_EQUAL_MESSAGE(100, naps, "it waits for ever");
    if (naps == naps_until_request) {
        header->requested = header->finished + 1;
    }
}

static void on_alive(void)
{
    signs++;
}

void setUp(void)
{
    size_t i;

    memset(fxl_window, 0xA5, sizeof fxl_window);
    memset(header, 0, sizeof *header);
    for (i = 0; i < sizeof palette; i++) {
        palette[i] = (uint8_t)(7 * i);
    }
    header->invitation = WINDOW_INVITATION;
    header->requested = 1000;
    naps = signs = naps_until_request = 0;
    system_alive_Stub(on_alive);
}

void tearDown(void)
{
}

static panel_answer open_of(uint16_t width, uint16_t height, uint32_t frames)
{
    const panel_format format = {palette, frames, width, height, 8};

    return window_panel.open(&format);
}

static void open_window(void)
{
    TEST_ASSERT_EQUAL(PANEL_READY, open_of(WIDTH, HEIGHT, 100));
}

/* Rows first to last of a frame of one colour. */
static void draw_rows(uint16_t first, uint16_t last, uint8_t colour)
{
    uint8_t pixels[AREA];
    const uint16_t height = (uint16_t)(last - first + 1);

    memset(pixels, colour, sizeof pixels);
    TEST_ASSERT_TRUE(window_panel.flush(0, first, WIDTH, height, pixels));
}

static void draw_frame(uint32_t number, uint8_t colour)
{
    TEST_ASSERT_TRUE(window_panel.begin(number, &pose));
    draw_rows(0, 0, colour);
    draw_rows(1, HEIGHT - 1, colour);
    TEST_ASSERT_TRUE(window_panel.end(&counters, 9, 0x100000002u));
}

/* What a viewer sees: the slot that it is told of. */
static const window_frame *front(void)
{
    TEST_ASSERT_LESS_THAN(WINDOW_SLOTS, header->front);
    return (const window_frame *)(const void *)(fxl_window + header->slots[header->front]);
}

static void assert_front(uint32_t number, uint8_t colour)
{
    TEST_ASSERT_EQUAL(number, front()->number);
    TEST_ASSERT_EACH_EQUAL_UINT8(colour, front() + 1, AREA);
}

/* formats 3.3b, 3.1j */
void test_without_an_invitation_it_stays_out(void)
{
    static uint8_t before[sizeof fxl_window];

    header->invitation = WINDOW_INVITATION ^ 1u;
    header->keys = 3;
    memcpy(before, fxl_window, sizeof before);
    TEST_ASSERT_FALSE(window_invited());
    TEST_ASSERT_EQUAL(0, window_keys());
    TEST_ASSERT_EQUAL(PANEL_UNSUITABLE, open_of(WIDTH, HEIGHT, 1));
    TEST_ASSERT_EQUAL_MEMORY(before, fxl_window, sizeof before);
}

/* formats 3.1a-e, 3.1g-h, 3.1l */
void test_the_header_tells_the_format(void)
{
    header->finished = 77; /* of a run before */
    open_window();
    TEST_ASSERT_EQUAL_HEX32(WINDOW_MAGIC, header->magic);
    TEST_ASSERT_EQUAL_MEMORY("FXLW", fxl_window, 4);
    TEST_ASSERT_EQUAL_MEMORY("VIEW", fxl_window + 32, 4);
    TEST_ASSERT_EQUAL(WINDOW_VERSION, header->version);
    TEST_ASSERT_EQUAL(WIDTH, header->width);
    TEST_ASSERT_EQUAL(HEIGHT, header->height);
    TEST_ASSERT_EQUAL(8, header->pixel_bits);
    TEST_ASSERT_EQUAL(0, header->finished);
    TEST_ASSERT_EQUAL_MEMORY(palette, fxl_window + 48, sizeof palette);
    TEST_ASSERT_EQUAL(WINDOW_FIRST_SLOT, header->slots[0]);
    TEST_ASSERT_GREATER_OR_EQUAL(header->slots[0] + sizeof(window_frame) + AREA, header->slots[1]);
    TEST_ASSERT_EQUAL(0, header->slots[1] % 8);
}

void test_a_screen_that_does_not_fit_is_refused(void)
{
    TEST_ASSERT_EQUAL(PANEL_FAILED, open_of(256, 128, 1)); /* twice 32 KiB and the heads */
    TEST_ASSERT_EQUAL(0, header->magic);
    TEST_ASSERT_EQUAL(PANEL_READY, open_of(256, 119, 1));
    TEST_ASSERT_LESS_OR_EQUAL(sizeof fxl_window,
                              header->slots[1] + sizeof(window_frame) + 256 * 119);
}

/* formats 3.2a-d */
void test_a_frame_and_what_is_told_of_it(void)
{
    open_window();
    draw_frame(0, 17);
    TEST_ASSERT_EQUAL(1, header->finished);
    assert_front(0, 17);
    TEST_ASSERT_EQUAL_MEMORY(&pose, &front()->pose, sizeof pose);
    TEST_ASSERT_EQUAL_MEMORY(&counters, &front()->counters, sizeof counters);
    TEST_ASSERT_EQUAL(9, front()->clamped);
    TEST_ASSERT_EQUAL_HEX64(0x100000002u, front()->instructions);
}

void test_rows_go_where_they_belong(void)
{
    uint8_t pixels[AREA];
    int i;

    open_window();
    for (i = 0; i < AREA; i++) {
        pixels[i] = (uint8_t)i;
    }
    TEST_ASSERT_TRUE(window_panel.begin(0, &pose));
    TEST_ASSERT_TRUE(window_panel.flush(0, 0, WIDTH, 2, pixels));
    TEST_ASSERT_TRUE(window_panel.flush(0, 2, WIDTH, 1, pixels + (size_t)2 * WIDTH));
    TEST_ASSERT_TRUE(window_panel.end(&counters, 0, 0));
    TEST_ASSERT_EQUAL_MEMORY(pixels, front() + 1, AREA);
}

/* formats 3.3e-f, 3.1f */
void test_what_is_in_front_is_never_drawn_on(void)
{
    uint32_t number;

    open_window();
    draw_frame(0, 100);
    for (number = 1; number < 6; number++) {
        const uint8_t before = (uint8_t)(99 + number);

        TEST_ASSERT_TRUE(window_panel.begin(number, &pose));
        assert_front(number - 1, before);
        draw_rows(0, 1, (uint8_t)(100 + number));
        assert_front(number - 1, before);
        draw_rows(2, 2, (uint8_t)(100 + number));
        assert_front(number - 1, before);
        TEST_ASSERT_EQUAL(number, header->finished);
        TEST_ASSERT_TRUE(window_panel.end(&counters, 0, 0));
        assert_front(number, (uint8_t)(100 + number));
        TEST_ASSERT_EQUAL(number + 1, header->finished);
    }
}

void test_it_writes_nothing_beyond_its_slots(void)
{
    size_t i, end;

    open_window();
    draw_frame(0, 1);
    draw_frame(1, 2);
    end = header->slots[1] + sizeof(window_frame) + AREA;
    for (i = sizeof *header; i < WINDOW_FIRST_SLOT; i++) {
        TEST_ASSERT_EQUAL_HEX8(0xA5, fxl_window[i]);
    }
    for (i = end; i < sizeof fxl_window; i++) {
        TEST_ASSERT_EQUAL_HEX8(0xA5, fxl_window[i]);
    }
}

void test_it_waits_for_the_first_request(void)
{
    header->requested = 0;
    naps_until_request = 3;
    open_window();
    TEST_ASSERT_EQUAL(3, naps);
    TEST_ASSERT_EQUAL_MESSAGE(3, signs, "a watchdog would have barked");
}

/* formats 3.3d, 3.1i */
void test_it_waits_for_each_request(void)
{
    header->requested = 1;
    open_window();
    TEST_ASSERT_EQUAL(0, naps);
    naps_until_request = 2;
    draw_frame(0, 1);
    TEST_ASSERT_EQUAL(2, naps);
    TEST_ASSERT_EQUAL(2, header->requested);
    TEST_ASSERT_EQUAL(1, header->finished);
}

/* formats 3.2f */
void test_pixels_of_16_bits(void)
{
    static const uint16_t colours[AREA] = {0x1234, 0xFFFF, 0, 0x8001};
    const panel_format format = {palette, 100, WIDTH, HEIGHT, 16};

    TEST_ASSERT_EQUAL(PANEL_READY, window_panel.open(&format));
    TEST_ASSERT_EQUAL(16, header->pixel_bits);
    TEST_ASSERT_GREATER_OR_EQUAL(header->slots[0] + sizeof(window_frame) + 2 * AREA,
                                 header->slots[1]);
    TEST_ASSERT_TRUE(window_panel.begin(0, &pose));
    TEST_ASSERT_TRUE(window_panel.flush(0, 0, WIDTH, 1, colours));
    TEST_ASSERT_TRUE(window_panel.flush(0, 1, WIDTH, HEIGHT - 1, colours + WIDTH));
    TEST_ASSERT_TRUE(window_panel.end(&counters, 9, 0));
    TEST_ASSERT_EQUAL_MEMORY(colours, front() + 1, sizeof colours);
}

void test_it_does_not_wait_where_many_are_wanted(void)
{
    header->requested = 0x7FFFFFFFu;
    open_window();
    draw_frame(0, 1);
    draw_frame(1, 2);
    TEST_ASSERT_EQUAL(0, naps);
}

void test_a_request_that_is_past_is_none(void)
{
    header->requested = 3;
    open_window();
    draw_frame(0, 1);
    draw_frame(1, 2);
    header->requested = 1;
    naps_until_request = 4;
    draw_frame(2, 3);
    TEST_ASSERT_EQUAL(4, naps);
}

void test_after_the_last_frame_it_does_not_wait(void)
{
    header->requested = 2;
    TEST_ASSERT_EQUAL(PANEL_READY, open_of(WIDTH, HEIGHT, 2));
    draw_frame(0, 1);
    draw_frame(1, 2);
    TEST_ASSERT_EQUAL(0, naps);
    TEST_ASSERT_TRUE(window_panel.close(true));
}

void test_the_viewers_keys(void)
{
    header->keys = 0x85;
    TEST_ASSERT_EQUAL_HEX32(0x85, window_keys());
    header->keys = 0;
    TEST_ASSERT_EQUAL_HEX32(0, window_keys());
}

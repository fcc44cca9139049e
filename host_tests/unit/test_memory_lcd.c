/* SPDX-License-Identifier: MIT */
/* The driver of memory LCDs against one after the data sheets of LS013B7DH03 and LS027B7DH01. A
 * message is what comes while its chip is selected. Its bits are counted as they come: M0 writes,
 * M1 is the polarity of the glass, M2 clears, five mean nothing; then the number of a row from 1
 * on, its lowest bit first, its pixels from the left, of which 1 is white, and sixteen that mean
 * nothing. */
#include "fixel/driver.h"
#include "unit.h"

enum {
    SIDE = 128, /* of the smaller glass, which the model keeps */
    ROWS_MAX = 240
};

static uint8_t memory[SIDE][SIDE / 8];
static uint8_t taken[ROWS_MAX + 1]; /* how often each row came */
static uint32_t columns, sends, refused, clears;
static bool polarity;
static fxl_display display;
static uint8_t palette[768];

/* Bit `n` of a message, as they come. */
static uint32_t bit_of(const uint8_t *message, uint32_t n)
{
    return (uint32_t)message[n / 8u] >> (7u - n % 8u) & 1u;
}

static bool send(void *user, bool is_data, const uint8_t *message, size_t size)
{
    uint32_t row = 0;
    (void)user;
    TEST_ASSERT_TRUE_MESSAGE(is_data, "it has no line for commands");
    if (sends++ == refused) {
        return false;
    }
    polarity = bit_of(message, 1) != 0;
    if (bit_of(message, 2) != 0) {
        TEST_ASSERT_TRUE(size == 2 && bit_of(message, 0) == 0);
        clears++;
        return true;
    }
    if (bit_of(message, 0) == 0) { /* the polarity alone */
        TEST_ASSERT_EQUAL(2, size);
        return true;
    }
    TEST_ASSERT_EQUAL(4u + columns / 8u, size);
    for (uint32_t i = 0; i < 8; i++) {
        row |= bit_of(message, 8u + i) << i;
    }
    TEST_ASSERT_TRUE(row >= 1 && row <= ROWS_MAX);
    taken[row]++;
    if (columns == SIDE) {
        TEST_ASSERT_LESS_OR_EQUAL(SIDE, row);
        memcpy(memory[row - 1u], &message[2], SIDE / 8);
    }
    return true;
}

static void pause(void *user, uint32_t milliseconds)
{
    (void)user;
    (void)milliseconds;
}

static const fxl_display_port port = {NULL, send, NULL, NULL, pause};

void setUp(void)
{
    memset(memory, 0xA5, sizeof memory);
    memset(taken, 0, sizeof taken);
    sends = clears = 0;
    refused = UINT32_MAX;
}

static void open_small(void)
{
    const fxl_display_config config = fxl_display_config_default(&fxl_ls013b7dh03, 0);
    columns = SIDE;
    TEST_ASSERT_EQUAL(FXL_OK, fxl_display_open(&display, &config, &port, palette));
}

/* Pixels of a frame: a pattern without a period of eight. */
static uint32_t pixel_at(uint32_t x, uint32_t y)
{
    return (x * x + 3u * y) % 5u < 2u;
}

/* Sends a frame of a size in one band, of pixels that the pump would make. */
static void show(uint16_t width, uint16_t height)
{
    static uint8_t bytes[SIDE * SIDE / 8];
    const uint32_t each = (width + 7u) / 8u;
    TEST_ASSERT_EQUAL(FXL_OK, fxl_display_place(&display, width, height));
    memset(bytes, 0, sizeof bytes);
    for (uint32_t y = 0; y < height; y++) {
        for (uint32_t x = 0; x < width; x++) {
            bytes[y * each + x / 8u] |= (uint8_t)(pixel_at(x, y) << (7u - x % 8u));
        }
    }
    TEST_ASSERT_TRUE(display.sink.start(display.sink.user, 0, height, bytes, each * height));
}

/* A frame in the middle, and black around it. */
static void assert_shown(uint32_t width, uint32_t height)
{
    const uint32_t left = (SIDE - width) / 2u, top = (SIDE - height) / 2u;
    for (uint32_t y = 0; y < SIDE; y++) {
        for (uint32_t x = 0; x < SIDE; x++) {
            const bool is_inside = x - left < width && y - top < height;
            const uint32_t expected = is_inside ? pixel_at(x - left, y - top) : 0;
            TEST_ASSERT_EQUAL(expected, bit_of(memory[y], x));
        }
    }
}

/* At every place within a byte, and at the sides of the glass. */
void test_a_frame_in_the_middle_of_whole_rows(void)
{
    static const uint8_t widths[] = {128, 127, 126, 121, 113, 64, 61, 9, 1};
    for (uint32_t i = 0; i < sizeof widths; i++) {
        setUp();
        open_small();
        TEST_ASSERT_EQUAL(1, clears);
        show(widths[i], widths[i]);
        assert_shown(widths[i], widths[i]);
    }
}

/* All rows of the larger one, from 1 to 240, whose numbers have eight bits. */
void test_every_row_has_its_number(void)
{
    const fxl_display_config config = fxl_display_config_default(&fxl_ls027b7dh01, 0);
    columns = 400;
    TEST_ASSERT_EQUAL(FXL_OK, fxl_display_open(&display, &config, &port, palette));
    TEST_ASSERT_EQUAL(0, taken[0]);
    TEST_ASSERT_EACH_EQUAL_UINT8(1, &taken[1], ROWS_MAX);
    TEST_ASSERT_EQUAL(1 + ROWS_MAX, sends);
}

/* The glass is worn by a voltage that does not change its sign. */
void test_the_polarity_changes_from_frame_to_frame(void)
{
    static const uint8_t bytes[8 * SIDE / 8] = {0};
    bool before = false;
    open_small();
    for (uint32_t n = 0; n < 6; n++) {
        for (uint16_t y = 0; y < SIDE; y = (uint16_t)(y + 8)) {
            TEST_ASSERT_TRUE(display.sink.start(display.sink.user, y, 8, bytes, sizeof bytes));
            TEST_ASSERT_TRUE(y == 0 ? polarity != before : polarity == before);
            before = polarity;
        }
    }
}

void test_wires_that_fail_at_any_row(void)
{
    const fxl_display_config config = fxl_display_config_default(&fxl_ls013b7dh03, 0);
    columns = SIDE;
    for (refused = 0; refused <= SIDE; refused++) {
        sends = 0;
        TEST_ASSERT_EQUAL(FXL_E_DISPLAY, fxl_display_open(&display, &config, &port, palette));
        TEST_ASSERT_EQUAL(refused + 1u, sends);
    }
}

/* A record of the caller's whose rows, or their numbers, a message has no room for, and an inversion,
 * for which there is no command. */
void test_what_it_can_not_be_is_not_opened(void)
{
    static const uint16_t sizes[][2] = {{520, 16}, {404, 16}, {128, 256}, {128, 128}};
    for (uint32_t i = 0; i < sizeof sizes / sizeof sizes[0]; i++) {
        fxl_display_driver own = fxl_ls013b7dh03;
        fxl_display_config config = fxl_display_config_default(&own, 0);
        own.memory_columns = sizes[i][0];
        own.memory_rows = sizes[i][1];
        config.height = 16;
        config.is_inverted = i == 3;
        sends = 0;
        TEST_ASSERT_EQUAL(FXL_E_DISPLAY, fxl_display_open(&display, &config, &port, palette));
        TEST_ASSERT_EQUAL(0, sends);
    }
}

static bool never_ready(void *user)
{
    (void)user;
    return false;
}

/* changed 4.4b */
void test_the_voltage_alternates_without_a_frame(void)
{
    fxl_display other = {0};
    open_small();
    for (uint32_t i = 0; i < 4; i++) {
        const bool before = polarity;
        const uint32_t count = sends;
        TEST_ASSERT_EQUAL(FXL_OK, fxl_display_alternate(&display));
        TEST_ASSERT_EQUAL(count + 1u, sends);
        TEST_ASSERT_TRUE(i == 0 || polarity != before);
    }
    refused = sends;
    TEST_ASSERT_EQUAL(FXL_E_DISPLAY, fxl_display_alternate(&display));
    TEST_ASSERT_EQUAL(FXL_E_ARGUMENT, fxl_display_alternate(NULL));
    TEST_ASSERT_EQUAL(FXL_E_RANGE, fxl_display_alternate(&other));
    other.driver = &fxl_st7789;
    TEST_ASSERT_EQUAL(FXL_E_RANGE, fxl_display_alternate(&other));
    const uint32_t before = sends;
    display.sink.wait = never_ready;
    TEST_ASSERT_EQUAL(FXL_E_DISPLAY, fxl_display_alternate(&display));
    TEST_ASSERT_EQUAL(before, sends);
}

/* SPDX-License-Identifier: MIT */
/* The drivers of OLEDs that fill windows: the order of their bytes, at each turn, and wires that
 * fail. */
#include "fixel/driver.h"
#include "unit.h"

/* The last bytes that came, in order: arguments and pixels as they are, commands above 255. */
static uint16_t log_of[512];
static uint32_t sends, refused, logged;
static bool takes_data;                /* arguments come as data, and not with their command */
static uint8_t command, settings[256]; /* the last command; of each the last argument or itself */
static fxl_display display;
static const uint8_t palette[768];

static bool send(void *user, bool is_data, const uint8_t *bytes, size_t size)
{
    (void)user;
    if (sends++ == refused) {
        return false;
    }
    TEST_ASSERT_TRUE(is_data || size == 1 || !takes_data);
    command = is_data ? command : bytes[0];
    TEST_ASSERT_TRUE_MESSAGE(!is_data || takes_data || command == 0x15 || command == 0x75,
                             "data are pixels, which come behind a window");
    for (size_t i = 0; i < size; i++) {
        log_of[logged++ % 512u] = (uint16_t)(bytes[i] + (is_data || i > 0 ? 0u : 256u));
        settings[command] = bytes[i];
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
    sends = logged = 0;
    refused = UINT32_MAX;
    takes_data = true;
}

/* The facts of each, and where the first row of a frame of 8 x 4 goes, which is in the middle of
 * the glass: columns in addresses, which have one, two or four pixels, and rows of the memory. */
typedef struct {
    const fxl_display_module *module;
    bool takes_data; /* if so, CA is the multiplex ratio and A6 shows the memory, else A8 and A4 */
    uint32_t accesses;                /* at turns 0 to 3, a byte each; 0: it has no such turn */
    uint8_t column, last_column, row; /* at turn 0 */
    uint8_t turned_column, turned_row, last_turned_row; /* at turn 1 */
    uint8_t bytes;                                      /* of the row */
} oled_facts;

static const oled_facts oleds[] = {
    {&fxl_module_ssd1351_128x128, true, 0x74776665, 60, 67, 62, 62, 60, 67, 16},
    {&fxl_module_ssd1331_96x64, false, 0x72716063, 44, 51, 30, 46, 28, 35, 16},
    {&fxl_module_ssd1327_128x128, false, 0x51004200, 30, 33, 62, 0, 0, 0, 4},
    {&fxl_module_ssd1327_96x96, false, 0x51004200, 30, 33, 46, 0, 0, 0, 4},
    {&fxl_module_ssd1322_256x64, true, 0x14000600, 59, 60, 30, 0, 0, 0, 4},
};

static uint32_t access_at(const oled_facts *of, uint32_t turns)
{
    return of->accesses >> (24u - 8u * turns) & 0xFFu;
}

/* Opens one at a turn, with a frame of a size in its middle, and forgets what was sent. */
static void open_with_frame(const oled_facts *of, uint32_t turns, uint16_t width, uint16_t height)
{
    const fxl_display_config config = fxl_display_config_turned(of->module, turns);
    setUp();
    takes_data = of->takes_data;
    memset(settings, 0, sizeof settings);
    TEST_ASSERT_EQUAL(FXL_OK, fxl_display_open(&display, &config, &port, palette));
    TEST_ASSERT_EQUAL_HEX16(0x1AF, log_of[(logged - 1u) % 512u]); /* on, last of all */
    TEST_ASSERT_EQUAL(FXL_OK, fxl_display_place(&display, width, height));
    logged = 0;
}

/* The windows of columns and rows come in this order, and behind them the pixels. */
void test_a_window_at_each_turn(void)
{
    static const uint8_t bytes[16] = {1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16};
    for (uint32_t each = 0; each < 4u * sizeof oleds / sizeof oleds[0]; each++) {
        const oled_facts *of = &oleds[each / 4u];
        const uint32_t turns = each % 4u, write = of->takes_data ? 7 : 6;
        const uint16_t upright[] = {0x115, of->column, of->last_column, 0x175, of->row, of->row};
        const uint16_t turned[] = {0x175, of->turned_row,    of->last_turned_row,
                                   0x115, of->turned_column, of->turned_column};
        if (access_at(of, turns) == 0) {
            TEST_ASSERT_NULL(fxl_display_config_turned(of->module, turns).driver);
            continue;
        }
        open_with_frame(of, turns, 8, 4);
        TEST_ASSERT_EQUAL_HEX8(access_at(of, turns), display.access);
        TEST_ASSERT_TRUE(display.sink.start(display.sink.user, 0, 1, bytes, of->bytes));
        TEST_ASSERT_EQUAL(write + of->bytes, logged);
        TEST_ASSERT_EQUAL_HEX16_ARRAY(turns % 2u == 0 ? upright : turned, log_of, 6);
        TEST_ASSERT_TRUE(!of->takes_data || log_of[6] == 0x15C);
        for (uint32_t i = 0; i < of->bytes; i++) {
            TEST_ASSERT_EQUAL_HEX16(bytes[i], log_of[write + i]);
        }
    }
}

/* Five greys have three bytes. An address of four pixels has two
 * bytes, so a byte of black ends each row. */
void test_rows_of_greys_that_end_within_an_address(void)
{
    static const uint8_t bytes[6] = {0x12, 0x34, 0x50, 0x67, 0x89, 0xA0};
    static const uint16_t of_two[] = {0x115, 30,   32,   0x175, 63,   64,
                                      0x12,  0x34, 0x50, 0x67,  0x89, 0xA0};
    static const uint16_t of_four[] = {0x115, 59,   60,   0x175, 31,   32,   0x15C, 0x12,
                                       0x34,  0x50, 0x00, 0x67,  0x89, 0xA0, 0x00};
    open_with_frame(&oleds[2], 0, 5, 2);
    TEST_ASSERT_TRUE(display.sink.start(display.sink.user, 0, 2, bytes, sizeof bytes));
    TEST_ASSERT_EQUAL(12, logged);
    TEST_ASSERT_EQUAL_HEX16_ARRAY(of_two, log_of, 12);
    open_with_frame(&oleds[4], 0, 5, 2);
    TEST_ASSERT_TRUE(display.sink.start(display.sink.user, 0, 2, bytes, sizeof bytes));
    TEST_ASSERT_EQUAL(15, logged);
    TEST_ASSERT_EQUAL_HEX16_ARRAY(of_four, log_of, 15);
    for (uint32_t n = 0; n <= 9; n++) { /* five sends of the window, four of the rows */
        refused = sends + n;
        const bool is_sent = display.sink.start(display.sink.user, 0, 2, bytes, sizeof bytes);
        TEST_ASSERT_EQUAL(n == 9, is_sent);
    }
}

/* Lines, start, offset, and what is shown, by the data sheet of each. The offset of a module of 96
 * rows is 32, and 128 - 32 where the scan is not mirrored. */
void test_what_each_oled_is_told_at_each_turn(void)
{
    for (uint32_t each = 0; each < 4u * sizeof oleds / sizeof oleds[0]; each++) {
        const oled_facts *of = &oleds[each / 4u];
        const uint32_t turns = each % 4u;
        const uint32_t offset = of->module != &fxl_module_ssd1327_96x96 ? 0 : turns == 0 ? 32 : 96;
        if (access_at(of, turns) != 0) {
            open_with_frame(of, turns, 8, 4);
            TEST_ASSERT_EQUAL(of->module->height - 1u, settings[of->takes_data ? 0xCA : 0xA8]);
            TEST_ASSERT_EQUAL(0, settings[0xA1]);
            TEST_ASSERT_EQUAL(offset, settings[0xA2]);
            TEST_ASSERT_EQUAL_HEX8(of->takes_data ? 0 : 0xA4, settings[0xA4]);
            TEST_ASSERT_EQUAL_HEX8(of->takes_data ? 0xA6 : 0, settings[0xA6]);
            TEST_ASSERT_EQUAL(0, settings[0xA7]);
            /* The last argument: an SSD1322 has two. */
            TEST_ASSERT_EQUAL_HEX8(each / 4u == 4 ? 0x11 : access_at(of, turns), settings[0xA0]);
        }
    }
}

/* By the data sheet line i of the scan shows the row of the memory that lies i behind the start
 * line. It drives COM i, or, in a scan that is mirrored, the COM that lies i before the last one of
 * the multiplex ratio. Whoever holds the module so that the picture is upright has COM 0 below if
 * the scan is mirrored, else above. */
void test_what_each_module_is_told_at_each_turn(void)
{
    static const struct {
        const fxl_display_module *module;
        uint8_t height;
    } modules[] = {{&fxl_module_ssd1351_128x128, 128}, {&fxl_module_ssd1351_128x96, 96}};
    static const uint8_t accesses[4] = {0x74, 0x77, 0x66, 0x65};
    for (uint32_t each = 0; each < 8; each++) {
        const fxl_display_module *module = modules[each / 4].module;
        const uint32_t turns = each % 4, height = modules[each / 4].height;
        const fxl_display_config config = fxl_display_config_turned(module, turns);
        memset(settings, 0, sizeof settings);
        TEST_ASSERT_EQUAL(FXL_OK, fxl_display_open(&display, &config, &port, palette));
        TEST_ASSERT_EQUAL(turns % 2 == 0 ? 128 : height, config.width);
        TEST_ASSERT_EQUAL(turns % 2 == 0 ? height : 128, config.height);
        TEST_ASSERT_EQUAL(0, config.left | config.top);
        TEST_ASSERT_EQUAL_HEX8(accesses[turns], settings[0xA0]);
        TEST_ASSERT_EQUAL(height - 1u, settings[0xCA]);
        TEST_ASSERT_TRUE(settings[0xA6] == 0xA6 && settings[0xA7] == 0 && settings[0xA2] == 0);
        for (uint32_t line = 0; line < height; line++) {
            const bool is_mirrored = (settings[0xA0] & 0x10u) != 0;
            const uint32_t com = is_mirrored ? settings[0xCA] - line : line;
            const uint32_t row = (line + settings[0xA1]) & 127u;
            TEST_ASSERT_EQUAL(is_mirrored ? height - 1u - com : com, row);
        }
    }
}

void test_a_module_with_inverted_colours_is_told_so(void)
{
    fxl_display_config config = fxl_display_config_default(&fxl_ssd1351, 0);
    config.is_inverted = true;
    memset(settings, 0, sizeof settings);
    TEST_ASSERT_EQUAL(FXL_OK, fxl_display_open(&display, &config, &port, palette));
    TEST_ASSERT_TRUE(settings[0xA7] == 0xA7 && settings[0xA6] == 0);
}

/* What it is told before its first pixels, at turn 0. */
void test_the_order_of_its_commands(void)
{
    static const uint16_t first[] = {0x1FD, 0x12, 0x1FD, 0xB1, 0x1AE},
                          last[] = {0x1A0, 0x74, 0x1A2, 0, 0x1A1, 0, 0x1CA, 127, 0x1A6, 0x115};
    const fxl_display_config config = fxl_display_config_default(&fxl_ssd1351, 0);
    for (refused = 0;; refused++) {
        sends = logged = 0;
        TEST_ASSERT_EQUAL(FXL_E_DISPLAY, fxl_display_open(&display, &config, &port, palette));
        TEST_ASSERT_EQUAL(refused + 1u, sends);
        if (log_of[(logged - 1u) % 512u] == 0x115) {
            break;
        }
    }
    TEST_ASSERT_EQUAL_HEX16_ARRAY(first, log_of, 5);
    TEST_ASSERT_EQUAL_HEX16_ARRAY(last, &log_of[logged - 10u], 10);
}

/* Each of the last sends fails: of the black glass, and the command that turns it on. */
void test_wires_that_fail_among_pixels(void)
{
    const fxl_display_config config = fxl_display_config_default(&fxl_ssd1351, 0);
    TEST_ASSERT_EQUAL(FXL_OK, fxl_display_open(&display, &config, &port, palette));
    const uint32_t all = sends;
    for (uint32_t n = 1; n <= 12; n++) {
        setUp();
        refused = all - n;
        TEST_ASSERT_EQUAL(FXL_E_DISPLAY, fxl_display_open(&display, &config, &port, palette));
        TEST_ASSERT_EQUAL(refused + 1u, sends);
    }
}

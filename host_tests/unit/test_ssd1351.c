/* SPDX-License-Identifier: MIT */
/* The driver of the SSD1351: the order of its bytes, at each turn, and wires that fail. */
#include "fixel/driver.h"
#include "fixel/modules.h"
#include "unit.h"

/* The last bytes that came, in order: arguments and pixels as they are, commands above 255. */
static uint16_t log_of[512];
static uint32_t sends, refused, logged;
static uint8_t command, settings[256]; /* the last command; of each the last argument or itself */
static fxl_display display;
static const uint8_t palette[768];

static bool send(void *user, bool is_data, const uint8_t *bytes, size_t size)
{
    (void)user;
    if (sends++ == refused) {
        return false;
    }
    TEST_ASSERT_TRUE(is_data || size == 1);
    for (size_t i = 0; i < size; i++) {
        log_of[logged++ % 512u] = (uint16_t)(bytes[i] + (is_data ? 0u : 256u));
        command = is_data ? command : bytes[i];
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
}

static void open_at(uint32_t turns)
{
    const fxl_display_config config = fxl_display_config_turned(&fxl_module_ssd1351_128x128, turns);
    TEST_ASSERT_EQUAL(FXL_OK, fxl_display_open(&display, &config, &port, palette));
    TEST_ASSERT_EQUAL_HEX16(0x1AF, log_of[(logged - 1u) % 512u]); /* on, last of all */
}

void test_a_window_at_each_turn(void)
{
    static const uint8_t accesses[4] = {0x74, 0x67 | 0x10, 0x66, 0x65}, bytes[4] = {1, 2, 3, 4};
    for (uint32_t turns = 0; turns < 4; turns++) {
        const uint16_t columns[] = {0x115, 63, 64}, rows[] = {0x175, 62, 62};
        const uint16_t pixels[] = {0x15C, 1, 2, 3, 4};
        setUp();
        open_at(turns);
        TEST_ASSERT_EQUAL_HEX8(accesses[turns], display.access);
        TEST_ASSERT_EQUAL(FXL_OK, fxl_display_place(&display, 2, 4));
        setUp();
        TEST_ASSERT_TRUE(display.sink.start(display.sink.user, 0, 1, bytes, sizeof bytes));
        TEST_ASSERT_EQUAL(11, logged);
        TEST_ASSERT_EQUAL_HEX16(turns % 2 == 0 ? columns[0] : rows[0], log_of[0]);
        TEST_ASSERT_EQUAL_HEX16_ARRAY(&columns[1], &log_of[1], 2);
        TEST_ASSERT_EQUAL_HEX16(turns % 2 == 0 ? rows[0] : columns[0], log_of[3]);
        TEST_ASSERT_EQUAL_HEX16_ARRAY(&rows[1], &log_of[4], 2);
        TEST_ASSERT_EQUAL_HEX16_ARRAY(pixels, &log_of[6], 5);
    }
}

/* By the data sheet line i of the scan shows the row of the memory that lies i behind the start
 * line. It drives COM i, or, in a scan that is mirrored, the COM that lies i before the last one of
 * the multiplex ratio. Whoever holds the module so that the picture is upright has COM 0 below if the
 * scan is mirrored, else above. */
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
                          last[] = {0x1CA, 127, 0x1A0, 0x74, 0x1A1, 0, 0x1A6, 0x115};
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
    TEST_ASSERT_EQUAL_HEX16_ARRAY(last, &log_of[logged - 8u], 8);
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

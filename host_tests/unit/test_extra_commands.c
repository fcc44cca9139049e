/* SPDX-License-Identifier: MIT */
/* Where a caller's own commands go over the wires, for each driver of the library: after the
 * driver's own, before the first pixel, and before the glass is turned on. */
#include "controller.h"
#include "fixel/driver.h"
#include "unit.h"

enum {
    MESSAGES = 192 /* the memory of a small board holds no more */
};

static const fxl_display_driver *const drivers[] = EVERY_DRIVER;

/* Of each message: its size, whether it is data, and its first three bytes. */
typedef struct {
    uint16_t size;
    bool is_data;
    uint8_t bytes[3];
} message;

static message messages[MESSAGES], before[MESSAGES];
static uint32_t sent;
static fxl_display display;
static const uint8_t palette[768];

static bool send(void *user, bool is_data, const uint8_t *bytes, size_t size)
{
    message *one = &messages[sent++ % MESSAGES];
    (void)user;
    memset(one, 0, sizeof *one);
    one->size = (uint16_t)size;
    one->is_data = is_data;
    memcpy(one->bytes, bytes, size < 3 ? size : 3);
    return true;
}

static void pause(void *user, uint32_t milliseconds)
{
    (void)user;
    (void)milliseconds;
}

static const fxl_display_port port = {NULL, send, NULL, NULL, pause};

/* A small glass, so that all is logged. Returns how many messages were sent. */
static uint32_t open_with(const fxl_display_driver *driver, const uint8_t *commands)
{
    fxl_display_config config = fxl_display_config_default(driver, 0);
    config.width = config.height = 16;
    config.extra_commands = commands;
    sent = 0;
    memset(messages, 0, sizeof messages);
    TEST_ASSERT_EQUAL(FXL_OK, fxl_display_open(&display, &config, &port, palette));
    TEST_ASSERT_LESS_THAN(MESSAGES, sent);
    return sent;
}

/* How a family sends a command: its arguments as data, all as a command, or all as data. And the
 * first byte of the message that begins the pixels. */
typedef struct {
    const fxl_display_family *family;
    uint8_t code;
    bool is_whole, is_data;
} manner;

static const manner manners[] = {
    {&fxl_display_colour, 0x2A, false, false},  {&fxl_display_colour_18, 0x2A, false, false},
    {&fxl_display_ssd1351, 0x15, false, false}, {&fxl_display_ssd1322, 0x15, false, false},
    {&fxl_display_ssd1331, 0x15, true, false},  {&fxl_display_ssd1327, 0x15, true, false},
    {&fxl_display_pages, 0xB0, true, false},    {&fxl_display_sh1107, 0xB0, true, false},
    {&fxl_display_st7565, 0xB0, true, false},   {&fxl_display_pcd8544, 0x40, true, false},
    {&fxl_display_memory_lcd, 0x80, true, true}};

static const manner *manner_of(const fxl_display_driver *driver)
{
    uint32_t i = 0;
    while (i < sizeof manners / sizeof manners[0] && manners[i].family != driver->family) {
        i++;
    }
    TEST_ASSERT_LESS_THAN(sizeof manners / sizeof manners[0], i);
    return &manners[i];
}

/* The first message of pixels or of their window: all before it sets the display up. */
static uint32_t first_window(const manner *of)
{
    uint32_t at = 0;
    while (at < sent &&
           (messages[at].is_data != of->is_data || messages[at].bytes[0] != of->code)) {
        at++;
    }
    TEST_ASSERT_LESS_THAN(sent, at);
    return at;
}

void test_extra_commands_of_every_driver_on_the_wires(void)
{
    static const uint8_t commands[] = {3, 0xE5, 0x11, 0x22, 1, 0xE6, 0};
    static const message apart[] = {
        {1, false, {0xE5, 0, 0}}, {2, true, {0x11, 0x22, 0}}, {1, false, {0xE6, 0, 0}}};
    static const message whole[] = {{3, false, {0xE5, 0x11, 0x22}}, {1, false, {0xE6, 0, 0}}};
    static const message data[] = {{3, true, {0xE5, 0x11, 0x22}}, {1, true, {0xE6, 0, 0}}};
    FXL_STATIC_ASSERT(sizeof drivers / sizeof drivers[0] == CONTROLLERS, "each controller");
    for (uint32_t i = 0; i < sizeof drivers / sizeof drivers[0]; i++) {
        const manner *of = manner_of(drivers[i]);
        const message *expected = of->is_data ? data : of->is_whole ? whole : apart;
        const uint32_t count = of->is_whole ? 2 : 3, plain = open_with(drivers[i], NULL);
        const uint32_t place = first_window(of);
        if (!of->is_data) { /* else a pin turns it on */
            TEST_ASSERT_EQUAL_HEX8(drivers[i]->family->turn_on[1], messages[plain - 1u].bytes[0]);
        }
        memcpy(before, messages, sizeof before);
        TEST_ASSERT_EQUAL(plain + count, open_with(drivers[i], commands));
        TEST_ASSERT_EQUAL_MEMORY(before, messages, place * sizeof messages[0]);
        TEST_ASSERT_EQUAL_MEMORY(expected, &messages[place], count * sizeof messages[0]);
        TEST_ASSERT_EQUAL_MEMORY(&before[place], &messages[place + count],
                                 (plain - place) * sizeof messages[0]);
    }
}

/* A driver of the caller's own with commands of its record, and with none. */
void test_commands_of_a_record(void)
{
    static const uint8_t listed[] = {2, 0xB1, 0x77, 0}, bare[] = {0x99, 0x98};
    fxl_display_driver own = fxl_st7789;
    const uint32_t plain = open_with(&own, NULL);
    own.commands = listed;
    TEST_ASSERT_EQUAL(plain + 2u, open_with(&own, NULL));
    own = fxl_sh1106;
    own.commands = bare;
    own.commands_size = sizeof bare;
    const uint32_t with = open_with(&own, NULL);
    own.commands = NULL;
    TEST_ASSERT_EQUAL(with - 1u, open_with(&own, NULL));
}

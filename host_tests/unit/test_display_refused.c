/* SPDX-License-Identifier: MIT */
/* Configurations and modules that are refused: turns that a controller can't show, and a glass that
 * is not in its memory. Nothing is sent then. */
#include "controller.h"
#include "unit.h"

static controller model;
static fxl_display display;
static const uint8_t palette[768];
static const fxl_display_port plain = {&model, controller_send, NULL, NULL, controller_pause};

/* Of a module that there is not. */
static void expect_none(fxl_display_config config)
{
    TEST_ASSERT_NULL(config.driver);
    TEST_ASSERT_EQUAL(0, config.width | config.height | config.left | config.top | config.access);
    TEST_ASSERT_FALSE(config.is_inverted);
    TEST_ASSERT_EQUAL(FXL_E_RANGE, fxl_display_open(&display, &config, &plain, palette));
}

/* The glass of a configuration is within the controller's memory: the first send fails. */
static void expect_within(const fxl_display_config *config, bool is_within)
{
    controller_start(&model, CONTROLLER_SSD1306, 0, 0, 8, 8);
    model.refused = 0;
    TEST_ASSERT_EQUAL(is_within ? FXL_E_DISPLAY : FXL_E_RANGE,
                      fxl_display_open(&display, config, &plain, palette));
    TEST_ASSERT_EQUAL(is_within, model.sends);
}

/* A glass at the end of a memory that is seen as columns x rows, and one that begins or ends a
 * column, or a page of rows, farther. */
static void assert_memory(fxl_display_config config, uint32_t columns, uint32_t rows, uint32_t page)
{
    const struct {
        uint32_t width, height, left, top;
        bool is_within;
    } glasses[] = {{8, 8, columns - 8, rows - 8, true},
                   {8, 8, columns - 7, rows - 8, false},
                   {8, 8, 65535, rows - 8, false},
                   {8, 8, columns - 8, rows - 8 + page, false},
                   {8, 8, columns - 8, 65528, false},
                   {32, 32, columns - 32, rows - 32, true},
                   {32, 32, columns - 31, rows - 32, false},
                   {32, 32, 65535, rows - 32, false},
                   {32, 32, columns - 32, rows - 32 + page, false},
                   {32, 32, columns - 32, 65528, false},
                   {columns, rows, 0, 0, true},
                   {columns + 1, rows, 0, 0, false},
                   {columns, rows + page, 0, 0, false},
                   {columns, 4 * rows, 0, 0, false}};
    for (uint32_t i = 0; i < sizeof glasses / sizeof glasses[0]; i++) {
        config.width = (uint16_t)glasses[i].width;
        config.height = (uint16_t)glasses[i].height;
        config.left = (uint16_t)glasses[i].left;
        config.top = (uint16_t)glasses[i].top;
        expect_within(&config, glasses[i].is_within);
    }
}

void test_a_glass_beyond_the_memory_is_refused(void)
{
    for (uint32_t i = 0; i < CONTROLLERS; i++) {
        const uint16_t columns = controllers[i].columns, rows = controllers[i].rows;
        for (uint32_t turns = 0; turns < 4; turns++) {
            fxl_display_config config = fxl_display_config_default(controllers[i].driver, turns);
            if (config.driver == NULL) {
                continue;
            }
            expect_within(&config, true);
            assert_memory(config, turns % 2 == 0 ? columns : rows, turns % 2 == 0 ? rows : columns,
                          controllers[i].page);
        }
    }
    /* Only the colour controllers exchange rows and columns by this bit. */
    fxl_display_config config = fxl_display_config_default(&fxl_ssd1306, 0);
    config.access |= 0x20;
    expect_within(&config, true);
    config.left = 1024; /* its upper half would be another command */
    expect_within(&config, false);
}

/* A window of greys begins and ends with an address, of which the glass has whole ones. */
void test_a_glass_of_greys_within_an_address_is_refused(void)
{
    for (uint32_t i = 0; i < CONTROLLERS; i++) {
        const uint32_t address = controllers[i].address;
        for (uint16_t beyond = 1; beyond <= 4 && address > 1; beyond++) {
            fxl_display_config config = fxl_display_config_default(controllers[i].driver, 0);
            config.width = (uint16_t)(config.width - 16u);
            config.left = (uint16_t)(config.left + beyond);
            expect_within(&config, beyond % address == 0);
            config.left = (uint16_t)(config.left - beyond);
            config.width = (uint16_t)(config.width + beyond);
            expect_within(&config, beyond % address == 0);
        }
    }
}

/* Of the half turn a PCD8544 and a memory LCD have no command either. */
void test_turns_that_a_controller_can_not_show(void)
{
    static const fxl_display_driver *const upright[] = {&fxl_pcd8544, &fxl_ls013b7dh03};
    for (uint32_t i = 0; i < 2; i++) {
        TEST_ASSERT_NOT_NULL(fxl_display_config_default(upright[i], 0).driver);
        for (uint32_t turns = 1; turns < 4; turns++) {
            expect_none(fxl_display_config_default(upright[i], turns));
        }
    }
}

void test_what_is_refused_sends_nothing(void)
{
    const fxl_display_port no_send = {&model, NULL, NULL, NULL, controller_pause};
    const fxl_display_port no_pause = {&model, controller_send, NULL, NULL, NULL};
    const fxl_display_port no_wait = {&model, controller_send, controller_begin, NULL,
                                      controller_pause};
    static const struct {
        uint16_t width, height, left, top;
    } wrong[] = {{0, 64, 0, 0},
                 {FXL_SCREEN_MAX + 1, 64, 0, 0},
                 {128, 0, 0, 0},
                 {128, FXL_SCREEN_MAX + 8, 0, 0},
                 {128, 63, 0, 0}, /* no whole page */
                 {128, 64, 0, 4},
                 {128, 64, 0, FXL_SCREEN_MAX + 8},
                 {128, 64, FXL_SCREEN_MAX + 1, 0}};
    fxl_display_config config = fxl_display_config_default(&fxl_ssd1306, 0);
    controller_start(&model, CONTROLLER_SSD1306, 0, 0, 8, 8);
    memset(&display, 0x5A, sizeof display);
    TEST_ASSERT_EQUAL(FXL_E_ARGUMENT, fxl_display_open(NULL, &config, &plain, palette));
    TEST_ASSERT_EQUAL(FXL_E_ARGUMENT, fxl_display_open(&display, NULL, &plain, palette));
    TEST_ASSERT_EQUAL(FXL_E_ARGUMENT, fxl_display_open(&display, &config, NULL, palette));
    TEST_ASSERT_EQUAL(FXL_E_ARGUMENT, fxl_display_open(&display, &config, &plain, NULL));
    TEST_ASSERT_EQUAL(FXL_E_ARGUMENT, fxl_display_open(&display, &config, &no_send, palette));
    TEST_ASSERT_EQUAL(FXL_E_ARGUMENT, fxl_display_open(&display, &config, &no_pause, palette));
    TEST_ASSERT_EQUAL(FXL_E_ARGUMENT, fxl_display_open(&display, &config, &no_wait, palette));
    expect_none(fxl_display_config_default(&fxl_ssd1306, 1)); /* it has no quarter turns */
    expect_none(fxl_display_config_default(&fxl_st7789, 4));
    expect_none(fxl_display_config_default(NULL, 0));
    for (uint32_t i = 0; i < sizeof wrong / sizeof wrong[0]; i++) {
        fxl_display_config other = config;
        other.width = wrong[i].width;
        other.height = wrong[i].height;
        other.left = wrong[i].left;
        other.top = wrong[i].top;
        TEST_ASSERT_EQUAL(FXL_E_RANGE, fxl_display_open(&display, &other, &plain, palette));
    }
    TEST_ASSERT_EACH_EQUAL_HEX8(0x5A, &display, sizeof display);
    TEST_ASSERT_EQUAL(0, model.sends);
    TEST_ASSERT_EQUAL(FXL_E_ARGUMENT, fxl_display_place(NULL, 1, 1));
    TEST_ASSERT_EQUAL(FXL_OK, fxl_display_open(&display, &config, &plain, palette));
    TEST_ASSERT_EQUAL(FXL_E_RANGE, fxl_display_place(&display, 0, 8));
    TEST_ASSERT_EQUAL(FXL_E_RANGE, fxl_display_place(&display, 8, 0));
    TEST_ASSERT_EQUAL(FXL_E_RANGE, fxl_display_place(&display, 129, 8));
    TEST_ASSERT_EQUAL(0, display.left);
}

static void expect_no_turn(fxl_display_module module, uint32_t turns)
{
    TEST_ASSERT_NULL(fxl_display_config_turned(&module, turns).driver);
}

void test_modules_that_there_cannot_be(void)
{
    const fxl_display_module whole = fxl_module_st7789_240x240;
    fxl_display_module wrong = whole;
    TEST_ASSERT_NOT_NULL(fxl_display_config_turned(&whole, 3).driver);
    TEST_ASSERT_NULL(fxl_display_config_turned(NULL, 0).driver);
    expect_no_turn(whole, 4);
    wrong.driver = NULL;
    expect_no_turn(wrong, 0);
    wrong = whole;
    wrong.width = 0;
    expect_no_turn(wrong, 0);
    wrong = whole;
    wrong.height = 0;
    expect_no_turn(wrong, 0);
    wrong = whole;
    wrong.left = 1;
    expect_no_turn(wrong, 0);
    wrong = whole;
    wrong.top = 81;
    expect_no_turn(wrong, 0);
    wrong.top = 65535;
    expect_no_turn(wrong, 0);
    wrong = whole;
    wrong.columns = 241; /* more than the controller has */
    expect_no_turn(wrong, 0);
    wrong = whole;
    wrong.rows = 321;
    expect_no_turn(wrong, 0);
    wrong = whole;
    wrong.access = 0x20; /* its columns are rows */
    expect_no_turn(wrong, 0);
    expect_no_turn(wrong, 1);
}

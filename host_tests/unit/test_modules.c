/* SPDX-License-Identifier: MIT */
/* Modules as they are sold, at each turn: the corners of the picture are at the corners of the
 * glass, in the right colours, and nothing is written outside it. The table is written from the
 * facts that public libraries agree on, and not from the library's records. */
#include "controller.h"
#include "fixel/driver.h"
#include "unit.h"

enum {
    WINDOW = 12, /* pixels around a corner that the model keeps: half of them on the glass */
    WIDEST = 480
};

static controller model;
static fxl_display display;
static const uint8_t palette[768];
static const fxl_display_port port = {&model, controller_send, NULL, NULL, controller_pause};

/* Offsets are those of the glass in the memory as the driver of turn 0 counts it. */
typedef struct {
    const fxl_display_module *module;
    int kind;
    uint16_t width, height, left, top, columns, rows;
    bool columns_mirrored, rows_mirrored, is_blue_first, is_inverted;
} facts;

/* place driver: facts of its modules; windows and rows: test_oled.c, test_memory_lcd.c */
static const facts colours[] = {
    {&fxl_module_ili9341_240x320, CONTROLLER_ILI9341, 240, 320, 0, 0, 240, 320, true, false, true,
     false},
    {&fxl_module_st7789_240x320, CONTROLLER_ST7789, 240, 320, 0, 0, 240, 320, false, false, false,
     true},
    {&fxl_module_st7789_240x240, CONTROLLER_ST7789, 240, 240, 0, 0, 240, 320, false, false, false,
     true},
    {&fxl_module_st7789_135x240, CONTROLLER_ST7789, 135, 240, 52, 40, 240, 320, false, false, false,
     true},
    {&fxl_module_st7789_172x320, CONTROLLER_ST7789, 172, 320, 34, 0, 240, 320, false, false, false,
     true},
    {&fxl_module_st7789_170x320, CONTROLLER_ST7789, 170, 320, 35, 0, 240, 320, false, false, false,
     true},
    {&fxl_module_st7789_240x280, CONTROLLER_ST7789, 240, 280, 0, 20, 240, 320, false, false, false,
     true},
    {&fxl_module_st7735_128x160, CONTROLLER_ST7735, 128, 160, 0, 0, 128, 160, true, true, false,
     false},
    {&fxl_module_st7735_128x160_green, CONTROLLER_ST7735, 128, 160, 2, 1, 132, 162, true, true,
     true, false},
    {&fxl_module_st7735_128x128, CONTROLLER_ST7735, 128, 128, 2, 3, 132, 132, true, true, true,
     false},
    {&fxl_module_st7735_128x128_row_32, CONTROLLER_ST7735, 128, 128, 0, 32, 128, 160, true, true,
     true, false},
    {&fxl_module_st7735_80x160_column_24, CONTROLLER_ST7735, 80, 160, 24, 0, 128, 160, true, true,
     false, false},
    {&fxl_module_ili9488_320x480, CONTROLLER_ILI9488, 320, 480, 0, 0, 320, 480, true, false, true,
     false},
    {&fxl_module_st7735_80x160, CONTROLLER_ST7735, 80, 160, 26, 1, 132, 162, true, true, true,
     true},
    {&fxl_module_st7796_320x480, CONTROLLER_ST7796, 320, 480, 0, 0, 320, 480, true, false, true,
     false},
    {&fxl_module_st7796_222x480, CONTROLLER_ST7796, 222, 480, 49, 0, 320, 480, true, false, true,
     true},
    {&fxl_module_gc9a01_240x240, CONTROLLER_GC9A01, 240, 240, 0, 0, 240, 240, true, false, true,
     true},
    {&fxl_module_gc9107_128x128, CONTROLLER_GC9107, 128, 128, 0, 32, 128, 160, false, false, true,
     false},
};

/* Colours of the picture's corners, as they are sent: upper left, upper right, lower left, lower
 * right. All else is black. */
static const uint16_t corner_colours[4] = {0xF800, 0x07E0, 0x001F, 0xFFFF};

/* The picture's corner (0 left or up, 1 right or down) that lies at a corner of the glass, if the
 * picture is turned clockwise. Its upper left corner, for example, goes to the upper right one. */
static uint32_t corner_at(uint32_t right, uint32_t down, uint32_t turns)
{
    uint32_t x = right, y = down;
    for (uint32_t i = 0; i < turns; i++) {
        const uint32_t was_x = x;
        x = y;
        y = 1u - was_x;
    }
    return 2u * y + x;
}

/* The bytes of a pixel, whose channels are none or whole. */
static void put_colour(uint8_t *bytes, uint16_t colour)
{
    if (display.pixels.format->bits == 24) {
        bytes[0] = (uint8_t)((colour >> 11) * 255u / 31u);
        bytes[1] = (uint8_t)((colour >> 5 & 63u) * 255u / 63u);
        bytes[2] = (uint8_t)((colour & 31u) * 255u / 31u);
    } else {
        bytes[0] = (uint8_t)(colour >> 8);
        bytes[1] = (uint8_t)colour;
    }
}

static void send_corners(uint16_t width, uint16_t height)
{
    static uint8_t bytes[3 * WIDEST];
    for (uint32_t down = 0; down < 2; down++) {
        const uint16_t left = corner_colours[2 * down], right = corner_colours[2 * down + 1];
        const uint32_t each = display.pixels.format->bits / 8u;
        memset(bytes, 0, sizeof bytes);
        put_colour(bytes, left);
        put_colour(bytes + each * (width - 1u), right);
        TEST_ASSERT_TRUE(display.sink.start(
            display.sink.user, (uint16_t)(down == 0 ? 0 : height - 1), 1, bytes, each * width));
    }
}

/* A column or row of the memory itself, of one that turn 0 counts. */
static uint32_t place_of(uint32_t first, uint32_t at, uint32_t size, bool is_mirrored)
{
    return is_mirrored ? size - 1u - first - at : first + at;
}

/* One corner of the glass, as seen at turn 0, at a turn of the picture. */
static void assert_corner(const facts *of, uint32_t turns, uint32_t right, uint32_t down)
{
    const fxl_display_config config = fxl_display_config_turned(of->module, turns);
    const uint32_t column =
        place_of(of->left, right * (of->width - 1u), of->columns, of->columns_mirrored);
    const uint32_t row = place_of(of->top, down * (of->height - 1u), of->rows, of->rows_mirrored);
    const uint32_t first_column = column < WINDOW / 2 ? 0 : column - WINDOW / 2;
    const uint32_t first_row = row < WINDOW / 2 ? 0 : row - WINDOW / 2;
    controller_start(&model, of->kind, (uint16_t)first_column, (uint16_t)first_row, WINDOW, WINDOW);
    controller_strap(&model, of->columns, of->rows);
    TEST_ASSERT_EQUAL(turns % 2 == 0 ? of->width : of->height, config.width);
    TEST_ASSERT_EQUAL(turns % 2 == 0 ? of->height : of->width, config.height);
    TEST_ASSERT_EQUAL(FXL_OK, fxl_display_open(&display, &config, &port, palette));
    send_corners(config.width, config.height);
    TEST_ASSERT_TRUE(model.is_on && model.is_inverted == of->is_inverted);
    TEST_ASSERT_EQUAL(of->is_blue_first, (model.access & 8u) != 0);
    for (uint32_t y = 0; y < WINDOW && first_row + y < of->rows; y++) {
        for (uint32_t x = 0; x < WINDOW && first_column + x < of->columns; x++) {
            const uint32_t glass_x =
                place_of(0, first_column + x, of->columns, of->columns_mirrored) - of->left;
            const uint32_t glass_y =
                place_of(0, first_row + y, of->rows, of->rows_mirrored) - of->top;
            const bool is_glass = glass_x < of->width && glass_y < of->height;
            const bool is_corner = first_column + x == column && first_row + y == row;
            TEST_ASSERT_EQUAL_HEX16(
                is_corner  ? corner_colours[corner_at(right, down, turns)]
                : is_glass ? 0
                           : 0xA5A5,
                controller_pixel(&model, (uint16_t)(first_column + x), (uint16_t)(first_row + y)));
        }
    }
}

void test_corners_and_colours_of_each_module_at_each_turn(void)
{
    for (uint32_t i = 0; i < sizeof colours / sizeof colours[0]; i++) {
        for (uint32_t each = 0; each < 16; each++) {
            assert_corner(&colours[i], each / 4, each & 1u, each >> 1 & 1u);
        }
    }
}

/* Columns and sizes of modules of pages. Where the controller counts columns from the other side,
 * the glass lies in the middle, so its first column stays. */
void test_modules_of_pages_at_each_turn(void)
{
    static const struct {
        const fxl_display_module *module;
        int kind;
        uint16_t width, height, left;
        uint8_t wires, reference, offsets[2]; /* of turns 0 and 2 */
    } pages[] = {
        {&fxl_module_ssd1306_128x64, CONTROLLER_SSD1306, 128, 64, 0, 0x12, 0, {0, 0}},
        {&fxl_module_ssd1306_128x32, CONTROLLER_SSD1306, 128, 32, 0, 0x02, 0, {0, 0}},
        {&fxl_module_ssd1306_64x48, CONTROLLER_SSD1306, 64, 48, 32, 0x12, 0, {0, 0}},
        {&fxl_module_ssd1306_64x32, CONTROLLER_SSD1306, 64, 32, 32, 0x12, 0, {0, 0}},
        {&fxl_module_ssd1306_72x40, CONTROLLER_SSD1306, 72, 40, 28, 0x12, 0x30, {0, 0}},
        {&fxl_module_ssd1309_128x64, CONTROLLER_SSD1309, 128, 64, 0, 0x12, 0, {0, 0}},
        {&fxl_module_ssd1306_128x64_com_02, CONTROLLER_SSD1306, 128, 64, 0, 0x02, 0, {0, 0}},
        {&fxl_module_ssd1309_128x64_column_2, CONTROLLER_SSD1309_132, 128, 64, 2, 0x12, 0, {0, 0}},
        {&fxl_module_sh1107_128x128_column_96, CONTROLLER_SH1107, 128, 128, 0, 0, 0, {0x20, 0x60}},
        {&fxl_module_sh1106_128x64, CONTROLLER_SH1106, 128, 64, 2, 0x12, 0, {0, 0}},
        {&fxl_module_sh1106_72x40, CONTROLLER_SH1106, 72, 40, 30, 0x12, 0, {0x0C, 0x34}},
        {&fxl_module_sh1107_128x128, CONTROLLER_SH1107, 128, 128, 0, 0, 0, {0, 0}},
        {&fxl_module_sh1107_64x128, CONTROLLER_SH1107, 64, 128, 0, 0, 0, {0x60, 0x20}},
        {&fxl_module_sh1107_80x128, CONTROLLER_SH1107, 80, 128, 0, 0, 0, {0x68, 0x18}}};
    for (uint32_t i = 0; i < sizeof pages / sizeof pages[0]; i++) {
        for (uint32_t turns = 0; turns < 4; turns++) {
            const fxl_display_config config = fxl_display_config_turned(pages[i].module, turns);
            if (turns % 2 == 1) {
                TEST_ASSERT_NULL(config.driver);
                continue;
            }
            const bool is_sh1107 = pages[i].kind == CONTROLLER_SH1107;
            controller_start(&model, pages[i].kind, 0, 0, 128, 128);
            TEST_ASSERT_EQUAL(FXL_OK, fxl_display_open(&display, &config, &port, palette));
            TEST_ASSERT_EQUAL((is_sh1107 ? pages[i].width : pages[i].height) - 1, model.multiplex);
            TEST_ASSERT_EQUAL_HEX8(pages[i].offsets[turns / 2], model.offset);
            TEST_ASSERT_EQUAL_HEX8(pages[i].wires, model.wires);
            TEST_ASSERT_EQUAL_HEX8(pages[i].reference, model.reference);
            TEST_ASSERT_TRUE(model.is_charged && model.is_on && !model.is_inverted);
            TEST_ASSERT_EQUAL_HEX8((turns == 0) != is_sh1107 ? 9 : 0, model.access);
            for (uint16_t x = 0; x < 128; x++) {
                const bool is_glass = (uint16_t)(x - pages[i].left) < pages[i].width;
                TEST_ASSERT_EQUAL(is_glass ? 0 : 1, controller_pixel(&model, x, 0));
            }
            TEST_ASSERT_EQUAL(0, controller_pixel(&model, pages[i].left, pages[i].height - 1));
        }
    }
}

/* An LCD's glass and what is beside it, at the turns that it has: the first column of each. */
void test_modules_of_lcds_of_pages(void)
{
    static const struct {
        const fxl_display_module *module;
        int kind;
        uint16_t width, height, turn, left;
    } lcds[] = {{&fxl_module_st7565_128x64, CONTROLLER_ST7565, 128, 64, 0, 0},
                {&fxl_module_st7565_128x64, CONTROLLER_ST7565, 128, 64, 2, 4},
                {&fxl_module_pcd8544_84x48, CONTROLLER_PCD8544, 84, 48, 0, 0}};
    for (uint32_t i = 0; i < sizeof lcds / sizeof lcds[0]; i++) {
        const fxl_display_config config = fxl_display_config_turned(lcds[i].module, lcds[i].turn);
        const uint16_t columns = controllers[lcds[i].kind].columns;
        controller_start(&model, lcds[i].kind, 0, 0, columns, lcds[i].height);
        TEST_ASSERT_EQUAL(FXL_OK, fxl_display_open(&display, &config, &port, palette));
        TEST_ASSERT_TRUE(model.is_on && model.is_charged && model.is_inverted);
        for (uint16_t x = 0; x < columns; x++) {
            const bool is_glass = (uint16_t)(x - lcds[i].left) < lcds[i].width;
            TEST_ASSERT_EQUAL(is_glass ? 0 : 1, controller_pixel(&model, x, lcds[i].height - 1));
        }
    }
}

/* A glass at one side of the memory begins elsewhere at a half turn: 128 - 48 - 8 columns. */
void test_a_glass_of_pages_at_one_side(void)
{
    const fxl_display_module module = {&fxl_ssd1306, 48,   16,   8,    8,   128, 64, 0,
                                       false,        0x22, 0x0C, 0x10, NULL};
    TEST_ASSERT_EQUAL(8, fxl_display_config_turned(&module, 0).left);
    TEST_ASSERT_EQUAL(72, fxl_display_config_turned(&module, 2).left);
    TEST_ASSERT_EQUAL(8, fxl_display_config_turned(&module, 2).top);
    TEST_ASSERT_EQUAL_HEX8(9, fxl_display_config_turned(&module, 2).access);
    TEST_ASSERT_EQUAL_HEX8(0x34, fxl_display_config_turned(&module, 2).display_offset);
    const fxl_display_config config = fxl_display_config_turned(&module, 0);
    controller_start(&model, CONTROLLER_SSD1306, 0, 0, 128, 64);
    TEST_ASSERT_EQUAL(FXL_OK, fxl_display_open(&display, &config, &port, palette));
    TEST_ASSERT_TRUE(model.wires == 0x22 && model.offset == 0x0C && model.reference == 0x10);
}

/* Its converter is switched by the command that sets the reference of an SSD1306. */
void test_an_sh1106_with_a_converter_outside(void)
{
    fxl_display_module module = fxl_module_sh1106_128x64;
    module.com_pins = 0x02;
    module.display_offset = 0x10;
    module.current_reference = 0x8A;
    const fxl_display_config config = fxl_display_config_turned(&module, 2);
    controller_start(&model, CONTROLLER_SH1106, 0, 0, 128, 64);
    TEST_ASSERT_EQUAL(FXL_OK, fxl_display_open(&display, &config, &port, palette));
    TEST_ASSERT_TRUE(!model.is_charged && model.wires == 0x02 && model.offset == 0x30);
}

/* A driver's own module is a module: its glass lies in the middle of the columns, in all rows. */
void test_the_default_is_a_module_too(void)
{
    fxl_display_driver narrow = fxl_st7735;
    narrow.left = 6;
    narrow.width = 120;
    narrow.height = 162;
    const fxl_display_driver *const drivers[] = {
        &fxl_st7789,  &fxl_st7735,  &fxl_ssd1351,     &fxl_sh1106,      &fxl_ssd1306, &fxl_st7565,
        &fxl_ssd1331, &fxl_ssd1327, &fxl_ls013b7dh03, &fxl_ls027b7dh01, &fxl_ssd1322, &narrow};
    for (uint32_t i = 0; i < sizeof drivers / sizeof drivers[0]; i++) {
        const fxl_display_driver *driver = drivers[i];
        fxl_display_module module = {.driver = driver,
                                     .width = driver->width,
                                     .height = driver->height,
                                     .left = driver->left};
        module.columns = driver->family->exchanges != 0
                             ? (uint16_t)(driver->width + 2 * driver->left)
                             : driver->memory_columns;
        module.rows = driver->height;
        module.access = driver->access;
        module.is_inverted = driver->is_inverted;
        for (uint32_t turns = 0; turns < 5; turns++) {
            const fxl_display_config left = fxl_display_config_default(driver, turns),
                                     right = fxl_display_config_turned(&module, turns);
            TEST_ASSERT_EQUAL_PTR(right.driver, left.driver);
            TEST_ASSERT_EQUAL(right.width, left.width);
            TEST_ASSERT_EQUAL(right.height, left.height);
            TEST_ASSERT_EQUAL(right.left, left.left);
            TEST_ASSERT_EQUAL(right.top, left.top);
            TEST_ASSERT_EQUAL_HEX8(right.access, left.access);
            TEST_ASSERT_EQUAL(right.is_inverted, left.is_inverted);
        }
    }
}

void test_the_default_of_a_memory_of_132_columns(void)
{
    TEST_ASSERT_EQUAL(2, fxl_display_config_default(&fxl_ssd1309_132, 0).left);
    TEST_ASSERT_EQUAL(2, fxl_display_config_default(&fxl_ssd1309_132, 2).left);
    TEST_ASSERT_EQUAL(0, fxl_display_config_default(&fxl_st7565, 0).left);
    TEST_ASSERT_EQUAL(4, fxl_display_config_default(&fxl_st7565, 2).left);
}

/* The scanned columns of an SH1107 stay; the rows, which its memory mirrors, do not. */
void test_a_glass_of_scanned_columns_at_one_side(void)
{
    const fxl_display_module module = {&fxl_sh1107, 64,    96, 8, 16, 128, 128,
                                       0,           false, 0,  8, 0,  NULL};
    TEST_ASSERT_EQUAL(8, fxl_display_config_turned(&module, 2).left);
    TEST_ASSERT_EQUAL(16, fxl_display_config_turned(&module, 0).top);
    TEST_ASSERT_EQUAL(128 - 96 - 16, fxl_display_config_turned(&module, 2).top);
    TEST_ASSERT_EQUAL(120, fxl_display_config_turned(&module, 2).display_offset);
}

/* What a caller adds comes after the driver's own, and before the glass is turned on. */
void test_extra_commands(void)
{
    static const uint8_t pages[] = {2, 0x81, 0xCF, 1, 0xA7, 0},
                         colour[] = {2, 0x36, 0xC8, 1, 0x20, 0};
    fxl_display_module module = fxl_module_ssd1306_128x32;
    module.extra_commands = pages;
    fxl_display_config config = fxl_display_config_turned(&module, 0);
    controller_start(&model, CONTROLLER_SSD1306, 0, 0, 128, 64);
    TEST_ASSERT_EQUAL(FXL_OK, fxl_display_open(&display, &config, &port, palette));
    TEST_ASSERT_TRUE(model.is_on && model.is_inverted && model.contrast == 0xCF);
    config = fxl_display_config_turned(&fxl_module_st7789_240x320, 0);
    config.extra_commands = colour;
    controller_start(&model, CONTROLLER_ST7789, 0, 0, WINDOW, WINDOW);
    TEST_ASSERT_EQUAL(FXL_OK, fxl_display_open(&display, &config, &port, palette));
    TEST_ASSERT_TRUE(model.is_on && !model.is_inverted && model.access == 0xC8);
    const uint32_t sends = model.sends;
    controller_start(&model, CONTROLLER_ST7789, 0, 0, WINDOW, WINDOW);
    config.extra_commands = NULL;
    TEST_ASSERT_EQUAL(FXL_OK, fxl_display_open(&display, &config, &port, palette));
    TEST_ASSERT_EQUAL(sends - 3u, model.sends);
    config.extra_commands = colour;
    for (uint32_t n = 0; n < sends; n += n < 20 ? 1u : sends / 3u) {
        controller_start(&model, CONTROLLER_ST7789, 0, 0, WINDOW, WINDOW);
        model.refused = n;
        TEST_ASSERT_EQUAL(FXL_E_DISPLAY, fxl_display_open(&display, &config, &port, palette));
        TEST_ASSERT_EQUAL(n + 1u, model.sends);
    }
}

/* SPDX-License-Identifier: MIT */
/* The drivers of displays against controllers that rebuild the picture from the wires. */
#include "controller.h"
#include "unit.h"

enum {
    WIDTH = 48, /* of a frame in the middle of a glass of colours */
    HEIGHT = 40,
    BORDER = 2, /* around it, which must stay black */
    OLED_WIDTH = 128,
    OLED_HEIGHT = 64
};

static controller model;
static fxl_display display;
static fxl_pump pump;
static uint8_t palette[768], frame[OLED_HEIGHT * OLED_WIDTH];
static uint64_t memory[FXL_PUMP_MEMORY(OLED_WIDTH, 16, 1) + FXL_PUMP_MEMORY(WIDTH, 8, 24)];

static const fxl_display_port by_dma = {&model, controller_send, controller_begin, controller_wait,
                                        controller_pause};
static const fxl_display_port plain = {&model, controller_send, NULL, NULL, controller_pause};

void setUp(void)
{
    for (uint32_t i = 0; i < sizeof palette; i++) {
        palette[i] = (uint8_t)(unit_random() >> 9);
    }
    for (uint32_t i = 0; i < sizeof frame; i++) {
        frame[i] = (uint8_t)(unit_random() >> 9);
    }
}

void tearDown(void)
{
    transfer_wait(&model.wire);
}

/* Sends the frame in bands, each of which is drawn over as soon as it is the caller's again. */
static fxl_status show(uint16_t width, uint16_t height, uint16_t rows)
{
    static uint8_t lent[OLED_WIDTH * 16];
    const fxl_pump_config config = {&display.pixels, width, height, rows, NULL};
    fxl_status status = fxl_pump_init(&pump, &config, &display.sink, memory, sizeof memory);
    for (uint32_t y = 0; status == FXL_OK && y < height; y += rows) {
        const uint16_t count = (uint16_t)(rows < height - y ? rows : height - y);
        const fxl_band band = UNIT_BAND(lent, width, (uint16_t)y, count);
        memcpy(lent, frame + y * width, (size_t)count * width);
        status = fxl_pump_send_rows(&pump, &band);
        memset(lent, 0xEE, sizeof lent);
    }
    return status == FXL_OK ? fxl_pump_wait(&pump) : status;
}

/* The pixel of the glass, as seen before the module is turned, at which the viewer of the turned
 * module sees column x and row y. */
static void untwist(uint32_t turns, uint32_t glass_width, uint32_t glass_height, uint32_t *x,
                    uint32_t *y)
{
    const uint32_t column = *x, row = *y;
    switch (turns) {
    case 1:
        *x = glass_width - 1u - row;
        *y = column;
        break;
    case 2:
        *x = glass_width - 1u - column;
        *y = glass_height - 1u - row;
        break;
    case 3:
        *x = row;
        *y = glass_height - 1u - column;
        break;
    default:
        break;
    }
}

static uint32_t rgb565(uint8_t index)
{
    const uint8_t *colour = &palette[3u * index];
    return (uint32_t)(colour[0] / 8u * 2048u + colour[1] / 4u * 32u + colour[2] / 8u);
}

/* The common module of a controller of colours, with a frame in its middle. */
static void assert_colours(int kind, uint32_t turns, const fxl_display_port *port)
{
    const controller_facts *of = &controllers[kind];
    const uint32_t width = of->width, height = of->height;
    const fxl_display_config config = fxl_display_config_default(of->driver, turns);
    const uint32_t columns = turns % 2u == 0 ? WIDTH : HEIGHT, rows = WIDTH + HEIGHT - columns;
    const uint32_t left = (width - columns) / 2u - BORDER, top = (height - rows) / 2u - BORDER;
    controller_start(&model, kind, (uint16_t)left, (uint16_t)top, (uint16_t)(columns + 2u * BORDER),
                     (uint16_t)(rows + 2u * BORDER));
    TEST_ASSERT_EQUAL(turns % 2u == 0 ? width : height, config.width);
    TEST_ASSERT_EQUAL(turns % 2u == 0 ? height : width, config.height);
    TEST_ASSERT_EQUAL(FXL_OK, fxl_display_open(&display, &config, port, palette));
    TEST_ASSERT_EQUAL(FXL_OK, fxl_display_place(&display, WIDTH, HEIGHT));
    TEST_ASSERT_EQUAL(FXL_OK, show(WIDTH, HEIGHT, 7));
    TEST_ASSERT_TRUE(model.is_on);
    TEST_ASSERT_EQUAL((of->joined & INVERTED) != 0, model.is_inverted);
    TEST_ASSERT_EQUAL((of->joined & BLUE_FIRST) != 0, (model.access & 8u) != 0);
    const uint32_t frame_left = (config.width - WIDTH) / 2u,
                   frame_top = (config.height - HEIGHT) / 2u;
    for (uint32_t y = frame_top - BORDER; y < frame_top + HEIGHT + BORDER; y++) {
        for (uint32_t x = frame_left - BORDER; x < frame_left + WIDTH + BORDER; x++) {
            uint32_t column = x, row = y;
            const uint32_t in_x = x - frame_left, in_y = y - frame_top;
            const bool is_inside = in_x < WIDTH && in_y < HEIGHT;
            untwist(turns, width, height, &column, &row);
            column = (of->joined & MIRRORS_X) != 0 ? width - 1u - column : column;
            row = (of->joined & MIRRORS_Y) != 0 ? height - 1u - row : row;
            TEST_ASSERT_EQUAL_HEX16(is_inside ? rgb565(frame[in_y * WIDTH + in_x]) : 0,
                                    controller_pixel(&model, (uint16_t)column, (uint16_t)row));
        }
    }
}

void test_colours_stand_upright_in_each_turn(void)
{
    for (int kind = 0; kind < CONTROLLERS; kind++) {
        for (uint32_t turns = 0; controllers[kind].plays == PLAYS_MIPI && turns < 4; turns++) {
            assert_colours(kind, turns, turns % 2u == 0 ? &by_dma : &plain);
        }
    }
}

/* A glass of 240 x 240 at the end of the controller's 320 rows. */
static void open_square(const fxl_display_port *port)
{
    fxl_display_config config = fxl_display_config_default(&fxl_st7789, 0);
    config.width = WIDTH;
    config.height = HEIGHT;
    config.left = 3;
    config.top = 320 - HEIGHT;
    controller_start(&model, CONTROLLER_ST7789, 0, 320 - HEIGHT - BORDER, WIDTH + 5,
                     HEIGHT + BORDER);
    TEST_ASSERT_EQUAL(FXL_OK, fxl_display_open(&display, &config, port, palette));
}

void test_a_glass_that_begins_elsewhere(void)
{
    open_square(&by_dma);
    TEST_ASSERT_EQUAL_HEX16(0, controller_pixel(&model, 3, 320 - HEIGHT));
    TEST_ASSERT_EQUAL(FXL_OK, show(WIDTH, HEIGHT, 8));
    for (uint16_t y = 320 - HEIGHT - BORDER; y < 320; y++) {
        for (uint16_t x = 0; x < WIDTH + 5; x++) {
            const uint32_t in_x = x - 3u, in_y = y - (320u - HEIGHT);
            const bool is_inside = in_x < WIDTH && in_y < HEIGHT;
            TEST_ASSERT_EQUAL_HEX16(is_inside ? rgb565(frame[in_y * WIDTH + in_x]) : 0xA5A5,
                                    controller_pixel(&model, x, y));
        }
    }
}

/* --- pages -------------------------------------------------------------------------------- */

static void assert_pages(uint16_t left, uint16_t above, uint16_t width, uint16_t height)
{
    uint16_t table[256];
    fxl_grey_table(table, palette, 1);
    for (uint16_t y = 0; y < model.kept_rows; y++) {
        for (uint16_t x = 0; x < model.kept_columns; x++) {
            const uint32_t in_x = (uint32_t)x - left, in_y = (uint32_t)y - above;
            const bool is_inside = in_x < width && in_y < height;
            const uint32_t level =
                is_inside ? fxl_grey_level(table[frame[in_y * width + in_x]], in_x, in_y) : 0;
            TEST_ASSERT_EQUAL(level,
                              controller_pixel(&model, (uint16_t)(model.first_column + x), y));
        }
    }
}

/* The common module of a controller of pages: its glass, and nothing beside it, is in the model. */
static void open_pages(int kind, uint32_t turns, const fxl_display_port *port)
{
    const controller_facts *of = &controllers[kind];
    const fxl_display_config config = fxl_display_config_default(of->driver, turns);
    const uint16_t left = turns == 0 ? of->left : (uint16_t)(of->columns - of->width - of->left);
    controller_start(&model, kind, left, 0, of->width, of->height);
    TEST_ASSERT_EQUAL(FXL_OK, fxl_display_open(&display, &config, port, palette));
}

/* A frame that fills the glass, in bands of one page and of two. */
static void assert_full_pages(int kind, uint32_t turns)
{
    const uint16_t width = controllers[kind].width, height = controllers[kind].height;
    open_pages(kind, turns, turns == 0 ? &by_dma : &plain);
    assert_pages(0, 0, 0, 0); /* all black */
    TEST_ASSERT_EQUAL(FXL_OK, show(width, height, turns == 0 ? 8 : 16));
    assert_pages(0, 0, width, height);
    TEST_ASSERT_TRUE(model.is_on && model.is_charged && !model.is_all_on);
}

void test_pages_in_bands_of_one_and_two(void)
{
    static const int oleds[] = {CONTROLLER_SSD1306, CONTROLLER_SH1106, CONTROLLER_SSD1309,
                                CONTROLLER_SSD1309_132};
    for (uint32_t i = 0; i < sizeof oleds / sizeof oleds[0]; i++) {
        for (uint32_t turns = 0; turns < 4; turns += 2) {
            assert_full_pages(oleds[i], turns);
            /* The controller mirrors as it shows, which only a glass that is mounted so undoes. */
            TEST_ASSERT_EQUAL_HEX8(turns == 0 ? 9 : 0, model.access);
            TEST_ASSERT_FALSE(model.is_inverted);
            TEST_ASSERT_EQUAL(2u * (oleds[i] != CONTROLLER_SH1106), model.mode);
            TEST_ASSERT_EQUAL(63, model.multiplex);
            TEST_ASSERT_EQUAL_HEX8(0x12, model.wires);
            /* Row 0 of the memory is at the top, and what it has is shown. */
            TEST_ASSERT_TRUE(model.offset == 0 && model.start_row == 0);
            TEST_ASSERT_TRUE(model.clock == 0x80 && model.contrast == 0x80);
        }
    }
}

/* An LCD is dark where a bit is set, so it is inverted. The columns of an ST7565 are counted from
 * the last segment, and its rows from the first, as its glass is mounted. At a half turn the glass
 * begins behind four columns that it has not. */
void test_pages_of_an_st7565(void)
{
    for (uint32_t turns = 0; turns < 4; turns += 2) {
        assert_full_pages(CONTROLLER_ST7565, turns);
        TEST_ASSERT_EQUAL(turns == 0 ? 0 : 4, model.first_column);
        TEST_ASSERT_EQUAL_HEX8(turns == 0 ? 1 : 8, model.access);
        TEST_ASSERT_TRUE(model.has_reset && model.is_inverted && model.start_row == 0);
        TEST_ASSERT_EQUAL_HEX8(0x18, model.contrast);
    }
}

/* Pixels go along rows in the set of commands of every day: function 0. It can't be turned. */
void test_pages_of_a_pcd8544(void)
{
    assert_full_pages(CONTROLLER_PCD8544, 0);
    TEST_ASSERT_TRUE(model.function == 0 && model.is_inverted);
    for (uint32_t turns = 1; turns < 4; turns++) {
        TEST_ASSERT_NULL(fxl_display_config_default(&fxl_pcd8544, turns).driver);
    }
    open_pages(CONTROLLER_PCD8544, 0, &plain);
    TEST_ASSERT_EQUAL(FXL_OK, fxl_display_place(&display, 61, 39));
    TEST_ASSERT_EQUAL(FXL_OK, show(61, 39, 8));
    assert_pages(11, 0, 61, 39); /* 4 rows above are half a page */
}

/* Sixteen pages, of which the columns are scanned: the frame fills the glass in two halves. */
void test_pages_whose_columns_are_scanned(void)
{
    for (uint32_t turns = 0; turns < 4; turns += 2) {
        const fxl_display_config config = fxl_display_config_default(&fxl_sh1107, turns);
        controller_start(&model, CONTROLLER_SH1107, 0, 0, 128, 128);
        TEST_ASSERT_EQUAL(FXL_OK, fxl_display_open(&display, &config, &by_dma, palette));
        TEST_ASSERT_TRUE(model.is_on && model.is_charged && !model.is_inverted);
        TEST_ASSERT_TRUE(model.mode == 2 && model.multiplex == 127 && model.clock == 0x50);
        TEST_ASSERT_TRUE(model.offset == 0 && model.start_row == 0 && !model.is_all_on);
        TEST_ASSERT_EQUAL_HEX8(turns == 0 ? 0 : 9, model.access);
        TEST_ASSERT_EQUAL(FXL_OK, fxl_display_place(&display, OLED_WIDTH, OLED_HEIGHT));
        TEST_ASSERT_EQUAL(FXL_OK, show(OLED_WIDTH, OLED_HEIGHT, 16));
        assert_pages(0, 32, OLED_WIDTH, OLED_HEIGHT);
    }
}

void test_a_small_frame_on_pages(void)
{
    open_pages(CONTROLLER_SH1106, 0, &by_dma);
    TEST_ASSERT_EQUAL(FXL_OK, fxl_display_place(&display, 61, 39));
    TEST_ASSERT_EQUAL(FXL_OK, show(61, 39, 16));
    assert_pages(33, 8, 61, 39); /* 12 rows above are one page and a half */
}

void test_a_glass_of_32_rows(void)
{
    fxl_display_config config = fxl_display_config_default(&fxl_ssd1306, 2);
    config.height = 32;
    config.is_inverted = true;
    controller_start(&model, CONTROLLER_SSD1306, 0, 0, OLED_WIDTH, OLED_HEIGHT);
    TEST_ASSERT_EQUAL(FXL_OK, fxl_display_open(&display, &config, &plain, palette));
    TEST_ASSERT_EQUAL(31, model.multiplex);
    TEST_ASSERT_EQUAL_HEX8(0x02, model.wires);
    TEST_ASSERT_TRUE(model.is_inverted);
    TEST_ASSERT_EQUAL(0, controller_pixel(&model, 0, 31));
    TEST_ASSERT_EQUAL(1, controller_pixel(&model, 0, 32)); /* noise: no part of the glass */
    TEST_ASSERT_EQUAL(FXL_E_RANGE, fxl_display_place(&display, OLED_WIDTH, 33));
}

/* --- pumps of another shape --------------------------------------------------------------- */

/* Rows handed to the sink itself, as bytes of another frame may be. */
static bool start_rows(uint16_t first_row, uint16_t rows, uint16_t width)
{
    const uint8_t *bytes = (const uint8_t *)memory;
    const size_t size = fxl_pixels_size(display.pixels.format, width, rows);
    const uint32_t sends = model.sends;
    const bool is_sent = display.sink.start(display.sink.user, first_row, rows, bytes, size) &&
                         display.sink.wait(display.sink.user);
    TEST_ASSERT_EQUAL_MESSAGE(is_sent, model.sends > sends, "what is refused sends nothing");
    return is_sent;
}

/* Its block is exactly what the rows take: the driver must not read on. */
void test_a_pump_narrower_than_the_pages(void)
{
    static uint64_t block[FXL_PUMP_MEMORY(64, 8, 1)];
    static uint8_t bytes[64];
    const fxl_pump_config narrow = {&display.pixels, 64, OLED_HEIGHT, 8, NULL};
    const fxl_band band = {.pixels = frame, .width = 64, .stride = 64, .first_row = 0, .rows = 8};
    open_pages(CONTROLLER_SSD1306, 0, &plain);
    const uint32_t sends = model.sends;
    TEST_ASSERT_EQUAL(FXL_OK, fxl_pump_init(&pump, &narrow, &display.sink, block, sizeof block));
    TEST_ASSERT_EQUAL(sizeof bytes, fxl_pixels_size(display.pixels.format, 64, 8));
    TEST_ASSERT_FALSE(display.sink.start(display.sink.user, 0, 8, bytes, sizeof bytes));
    TEST_ASSERT_EQUAL(FXL_E_DISPLAY, fxl_pump_send_rows(&pump, &band));
    TEST_ASSERT_EQUAL(sends, model.sends);
    assert_pages(0, 0, 0, 0); /* all black */
    TEST_ASSERT_EQUAL(FXL_OK, fxl_display_place(&display, 64, OLED_HEIGHT));
    TEST_ASSERT_EQUAL(FXL_OK, fxl_pump_send_rows(&pump, &band));
}

void test_rows_that_are_not_the_frames(void)
{
    open_pages(CONTROLLER_SSD1306, 0, &plain);
    TEST_ASSERT_EQUAL(FXL_OK, fxl_display_place(&display, 61, 39));
    TEST_ASSERT_TRUE(start_rows(0, 8, 61));
    TEST_ASSERT_TRUE(start_rows(32, 7, 61)); /* a page that the frame does not fill */
    TEST_ASSERT_FALSE(start_rows(32, 8, 61));
    TEST_ASSERT_FALSE(start_rows(40, 8, 61));
    TEST_ASSERT_FALSE(start_rows(65528, 8, 61));
    TEST_ASSERT_FALSE(start_rows(0, 0, 61));
    TEST_ASSERT_FALSE(start_rows(4, 8, 61)); /* in two pages, with the bytes of one */
    TEST_ASSERT_FALSE(start_rows(0, 8, 60));
    TEST_ASSERT_FALSE(start_rows(0, 8, 62));
    controller_start(&model, CONTROLLER_ILI9341, 0, 0, 8, 8);
    fxl_display_config config = fxl_display_config_default(&fxl_ili9341, 0);
    config.width = WIDTH; /* soon black */
    config.height = HEIGHT;
    TEST_ASSERT_EQUAL(FXL_OK, fxl_display_open(&display, &config, &plain, palette));
    TEST_ASSERT_EQUAL(FXL_E_DISPLAY, show(WIDTH / 2, HEIGHT, 8));
    TEST_ASSERT_EQUAL(FXL_E_DISPLAY, show(WIDTH, 2 * HEIGHT, 8));
    TEST_ASSERT_TRUE(start_rows(HEIGHT - 1, 1, WIDTH));
    TEST_ASSERT_FALSE(start_rows(HEIGHT - 1, 2, WIDTH));
    TEST_ASSERT_FALSE(start_rows(0, 8, WIDTH + 1));
    TEST_ASSERT_EQUAL(FXL_OK, show(WIDTH, HEIGHT, 8));
}

/* --- failures ----------------------------------------------------------------------------- */

static fxl_status open_and_show(int kind, uint32_t refused)
{
    fxl_display_config config = fxl_display_config_default(controllers[kind].driver, 0);
    config.width = 40; /* a small glass, which is soon black */
    config.height = 24;
    controller_start(&model, kind, 0, 0, 48, 24);
    model.refused = refused;
    const fxl_status status = fxl_display_open(&display, &config, &by_dma, palette);
    return status == FXL_OK ? show(40, 24, 16) : status;
}

static void assert_failures(int kind)
{
    TEST_ASSERT_EQUAL(FXL_OK, open_and_show(kind, UINT32_MAX));
    const uint32_t sends = model.sends;
    TEST_ASSERT_GREATER_THAN(10, sends);
    for (uint32_t n = 0; n < sends; n++) {
        TEST_ASSERT_EQUAL(FXL_E_DISPLAY, open_and_show(kind, n));
        TEST_ASSERT_EQUAL_MESSAGE(n + 1u, model.sends, "it went on after a failure");
        transfer_wait(&model.wire);
    }
}

void test_wires_that_fail_at_any_time(void)
{
    assert_failures(CONTROLLER_ST7789);
    assert_failures(CONTROLLER_GC9A01); /* has commands of its own */
    assert_failures(CONTROLLER_SSD1306);
    assert_failures(CONTROLLER_ST7565);
    assert_failures(CONTROLLER_PCD8544);
}

static bool never_done(void *user)
{
    transfer_wait(&((controller *)user)->wire);
    return false;
}

void test_a_transfer_that_never_ends(void)
{
    fxl_display_config config = fxl_display_config_default(&fxl_ili9341, 0);
    fxl_display_port port = by_dma;
    port.wait = never_done;
    config.width = 40;
    config.height = 24;
    controller_start(&model, CONTROLLER_ILI9341, 0, 0, 48, 24);
    TEST_ASSERT_EQUAL(FXL_E_DISPLAY, fxl_display_open(&display, &config, &port, palette));
}

/* SPDX-License-Identifier: MIT */
/* SSD1351: an OLED of colours. Commands and arguments go as those of MIPI do, but they are others.
 */
#include "fixel/driver.h"

enum {
    SET_COLUMNS = 0x15, /* first, last */
    SET_ROWS = 0x75,
    WRITE_PIXELS = 0x5C,
    SET_ACCESS = 0xA0, /* which way rows and columns run, the order and size of the colours */
    SET_START_LINE = 0xA1,
    INVERT_OFF = 0xA6,
    INVERT = 0xA7,
    DISPLAY_ON = 0xAF,
    SET_MULTIPLEX = 0xCA
};

#define EXCHANGES       0x01u
#define MIRRORS_COLUMNS 0x02u
#define MIRRORS_ROWS    0x10u

static const uint8_t start_commands[] = {
    2, 0xFD, 0x12,             /* unlock */
    2, 0xFD, 0xB1,             /* unlock the commands below */
    1, 0xAE,                   /* off */
    2, 0xB3, 0xF1,             /* clock: the fastest, divided by 2 */
    2, 0xA2, 0x00,             /* no offset */
    2, 0xB5, 0x00,             /* pins are not used */
    2, 0xAB, 0x01,             /* its own voltage regulator on */
    2, 0xB1, 0x32,             /* lengths of discharge and precharge */
    2, 0xBE, 0x05,             /* voltage of a row at rest */
    4, 0xC1, 0xC8, 0x80, 0xC8, /* contrast of each colour */
    2, 0xC7, 0x0F,             /* and of all: the highest */
    4, 0xB4, 0xA0, 0xB5, 0x55, /* low voltage from outside */
    2, 0xB6, 0x01,             /* second precharge */
    0,
};

static bool send_command(const fxl_display *display, const uint8_t *command, size_t size)
{
    return fxl_display_command(display, command[0], command + 1, size - 1u);
}

/* As many lines are scanned as the glass has. A mirrored scan begins with the last of them, and the
 * first line that is scanned shows the row of the start line: so that is row 0 at every turn. */
static bool set_up(const fxl_display *display, const fxl_display_config *config)
{
    static const uint8_t first_row = 0;
    const uint32_t rows = (config->access & EXCHANGES) != 0 ? config->width : config->height;
    const uint8_t multiplex = (uint8_t)(rows - 1u);
    return fxl_display_send_commands(display, start_commands) &&
           fxl_display_command(display, SET_MULTIPLEX, &multiplex, 1) &&
           fxl_display_command(display, SET_ACCESS, &config->access, 1) &&
           fxl_display_command(display, SET_START_LINE, &first_row, 1) &&
           fxl_display_command(display, config->is_inverted ? INVERT : INVERT_OFF, NULL, 0);
}

/* The memory has 128 columns and rows. */
static bool set_range(const fxl_display *display, uint8_t code, uint32_t first, uint32_t count)
{
    const uint8_t range[2] = {(uint8_t)first, (uint8_t)(first + count - 1u)};
    return fxl_display_command(display, code, range, sizeof range);
}

/* The commands count columns and rows of the memory, even where pixels fill its columns first. */
static bool send_rows(const fxl_display *display, uint16_t left, uint16_t top, uint16_t width,
                      uint16_t rows, const uint8_t *bytes, size_t size)
{
    const bool is_exchanged = (display->access & EXCHANGES) != 0;
    return set_range(display, is_exchanged ? SET_ROWS : SET_COLUMNS, left, width) &&
           set_range(display, is_exchanged ? SET_COLUMNS : SET_ROWS, top, rows) &&
           fxl_display_command(display, WRITE_PIXELS, NULL, 0) &&
           fxl_display_start_data(display, bytes, size);
}

static const uint8_t turn_on[] = {1, DISPLAY_ON, 0};

const fxl_display_family fxl_display_ssd1351 = {&fxl_pixels_rgb565, set_up,      send_rows,
                                                send_command,       turn_on,     EXCHANGES,
                                                MIRRORS_COLUMNS,    MIRRORS_ROWS};

/* Bits 6, 5 and 2: 16 bits a pixel, odd and even rows on two sides, red in the upper bits. */
const fxl_display_driver fxl_ssd1351 = {
    &fxl_display_ssd1351, NULL, 0, 128, 128, 128, 128, 0, 0x74, false, false};

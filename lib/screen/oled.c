/* SPDX-License-Identifier: MIT */
/* SSD1351 and SSD1331 of colours, SSD1327 and SSD1322 of 16 greys: OLEDs that fill windows, and
 * whose commands are not those of MIPI. An SSD1351 and an SSD1322 take arguments as data, and
 * pixels behind a command. The two others take arguments as commands, and all data are pixels. */
#include "fixel/driver.h"

enum {
    SET_COLUMNS = 0x15, /* first, last; in addresses, which have one, two or four pixels */
    SET_ROWS = 0x75,
    WRITE_PIXELS = 0x5C,
    SET_ACCESS = 0xA0, /* which way rows and columns run, the order and size of the colours */
    SET_START_LINE = 0xA1,
    SET_OFFSET = 0xA2,
    SHOW_MEMORY = 0xA4, /* where arguments are commands; else 0xA6 */
    SHOW_MEMORY_OF_DATA = 0xA6,
    INVERT = 0xA7,
    SET_MULTIPLEX = 0xA8, /* where arguments are commands; else 0xCA */
    SET_MULTIPLEX_OF_DATA = 0xCA,
    DISPLAY_ON = 0xAF
};

/* Second argument of an SSD1322's access: both sides scan a half. */
#define DUAL_COM 0x11u

static bool send_apart(const fxl_display *display, const uint8_t *command, size_t size)
{
    return fxl_display_command(display, command[0], command + 1, size - 1u);
}

static bool send_whole(const fxl_display *display, const uint8_t *command, size_t size)
{
    return display->port->send(display->port->user, false, command, size);
}

static bool takes_data(const fxl_display *display)
{
    return display->driver->family->send_command == send_apart;
}

/* As many lines are scanned as the glass has. A mirrored scan begins with the last of them, and the
 * first line that is scanned shows the row of the start line: so that is row 0 at every turn. The
 * four columns that an address has tell an SSD1322, whose access has a second argument. */
FXL_COLD static bool set_up(const fxl_display *display, const fxl_display_config *config)
{
    const fxl_display_family *family = display->driver->family;
    const bool is_exchanged = (config->access & family->exchanges) != 0;
    const uint32_t rows = is_exchanged ? config->width : config->height;
    const uint8_t access[] = {SET_ACCESS, config->access, DUAL_COM};
    uint8_t settings[] = {2, SET_OFFSET,    config->display_offset, 2, SET_START_LINE, 0,
                          2, SET_MULTIPLEX, (uint8_t)(rows - 1u),   1, SHOW_MEMORY,    0};
    if (takes_data(display)) {
        settings[7] = SET_MULTIPLEX_OF_DATA;
        settings[10] = SHOW_MEMORY_OF_DATA;
    }
    if (config->is_inverted) {
        settings[10] = INVERT;
    }
    return fxl_display_send_commands(display, display->driver->commands) &&
           family->send_command(display, access, family->columns_less_1 == 3 ? 3 : 2) &&
           fxl_display_send_commands(display, settings);
}

/* Columns in addresses; the memory has at most 128 of them, and of rows. The commands count columns
 * and rows of the memory, even where pixels fill its columns first. */
static bool set_window(const fxl_display *display, uint32_t left, uint32_t top, uint32_t width,
                       uint32_t rows)
{
    const bool is_exchanged = (display->access & display->driver->family->exchanges) != 0;
    const uint8_t commands[] = {3,
                                (uint8_t)(is_exchanged ? SET_ROWS : SET_COLUMNS),
                                (uint8_t)left,
                                (uint8_t)(left + width - 1u),
                                3,
                                (uint8_t)(is_exchanged ? SET_COLUMNS : SET_ROWS),
                                (uint8_t)top,
                                (uint8_t)(top + rows - 1u),
                                (uint8_t)(takes_data(display) ? 1 : 0), /* else the end */
                                WRITE_PIXELS,
                                0};
    return fxl_display_send_commands(display, commands);
}

static bool send_rows(const fxl_display *display, uint16_t left, uint16_t top, uint16_t width,
                      uint16_t rows, const uint8_t *bytes, size_t size)
{
    return set_window(display, left, top, width, rows) &&
           fxl_display_start_data(display, bytes, size);
}

/* Rows of `each` bytes that end within an address are filled up with black: of four greys, the third
 * and fourth. */
static bool send_filled(const fxl_display *display, uint32_t rows, const uint8_t *bytes,
                        uint32_t each)
{
    static const uint8_t black = 0;
    const fxl_display_port *port = display->port;
    for (; rows > 0; rows--, bytes += each) {
        if (!port->send(port->user, true, bytes, each) ||
            !port->send(port->user, true, &black, 1)) {
            return false;
        }
    }
    return true;
}

/* Two greys have a byte, and two or four of them an address: a row may have half of one. */
static bool send_greys(const fxl_display *display, uint16_t left, uint16_t top, uint16_t width,
                       uint16_t rows, const uint8_t *bytes, size_t size)
{
    const uint32_t mask = display->driver->family->columns_less_1, shift = (mask + 1u) / 2u;
    const uint32_t each = (width + 1u) / 2u;
    return set_window(display, (uint32_t)left >> shift, top, (width + mask) >> shift, rows) &&
           (mask == 1 || each % 2u == 0 ? fxl_display_start_data(display, bytes, size)
                                        : send_filled(display, rows, bytes, each));
}

static const uint8_t turn_on[] = {1, DISPLAY_ON, 0};

/* Bits of their access. With greys the two pixels of a byte are mirrored apart from the addresses:
 * bit 1 of an SSD1327, which bit 0 goes with. An SSD1322 mirrors both by bit 1. */
const fxl_display_family fxl_display_ssd1351 = {
    &fxl_pixels_rgb565, set_up, send_rows, send_apart, turn_on, 0x01, 0x02, 0x10, 0, false};
const fxl_display_family fxl_display_ssd1331 = {
    &fxl_pixels_rgb565, set_up, send_rows, send_whole, turn_on, 0x01, 0x02, 0x10, 0, false};
const fxl_display_family fxl_display_ssd1327 = {
    &fxl_pixels_grey4, set_up, send_greys, send_whole, turn_on, 0, 0x03, 0x10, 1, false};
const fxl_display_family fxl_display_ssd1322 = {
    &fxl_pixels_grey4, set_up, send_greys, send_apart, turn_on, 0, 0x02, 0x10, 3, false};

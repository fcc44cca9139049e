/* SPDX-License-Identifier: MIT */
/* SSD1306, SSD1309, SH1106 and SH1107: controllers of pages of eight rows, in the page addressing
 * mode. Every byte of a command, its arguments too, is sent as a command. */
#include "fixel/driver.h"

enum {
    SET_PAGE = 0xB0,        /* and the number of the page */
    SET_COLUMN_LOW = 0x00,  /* and the lower four bits of the column */
    SET_COLUMN_HIGH = 0x10, /* and the upper ones */
    MIRROR_COLUMNS = 0xA0,  /* and 0 or 1 */
    INVERT = 0xA6,          /* and 0 or 1 */
    SET_REFERENCE = 0xAD,   /* and whether an SSD1306 makes its reference current itself */
    MIRROR_ROWS = 0xC0,     /* and 0 or 8 */
    DISPLAY_ON = 0xAF
};

#define WIRES_IN_ORDER \
    0x02u /* how the rows are joined to the glass: of 32 rows or fewer one after */
#define WIRES_IN_TURNS 0x12u /* the other, of more by turns */

static bool send_commands(const fxl_display *display, const uint8_t *commands, size_t size)
{
    return display->port->send(display->port->user, false, commands, size);
}

/* What all of them know: off, how the glass is scanned, and that it shows what the memory has.
 * lines: the rows that are scanned, columns of an SH1107. */
static bool set_scan(const fxl_display *display, const fxl_display_config *config, uint32_t lines)
{
    const uint8_t commands[] = {
        0xAE, /* display off */
        0xD5,
        0x80, /* clock: as an SSD1306 has it after reset */
        0xA8,
        (uint8_t)(lines - 1u), /* that the glass has */
        0xD3,
        config->display_offset, /* 0: the first line of memory is the first one of the glass */
        0x81,
        0x80, /* contrast: the middle */
        0xA4, /* memory is shown as it is */
        (uint8_t)(MIRROR_COLUMNS | (config->access & 1u)),
        (uint8_t)(MIRROR_ROWS | (config->access & 8u)),
        (uint8_t)(INVERT | (config->is_inverted ? 1u : 0u)),
    };
    const fxl_display_driver *driver = config->driver;
    return send_commands(display, commands, sizeof commands) &&
           (driver->commands == NULL ||
            send_commands(display, driver->commands, driver->commands_size));
}

static bool set_up(const fxl_display *display, const fxl_display_config *config)
{
    const uint8_t com_pins = config->com_pins != 0 ? config->com_pins
                             : config->height > 32 ? WIRES_IN_TURNS
                                                   : WIRES_IN_ORDER;
    const uint8_t commands[] = {
        0x40, /* not scrolled */
        0xDA, com_pins, SET_REFERENCE, config->current_reference,
    };
    return set_scan(display, config, config->height) &&
           send_commands(display, commands, config->current_reference != 0 ? 5 : 3);
}

/* An SH1107 has its columns on the lines that it scans, and knows no command for COM pins. */
static bool set_up_columns(const fxl_display *display, const fxl_display_config *config)
{
    return set_scan(display, config, config->width);
}

/* A page at a time: the controller does not go on to the next one by itself. All but the last one
 * are sent when this returns. */
static bool send_rows(const fxl_display *display, uint16_t left, uint16_t top, uint16_t width,
                      uint16_t rows, const uint8_t *bytes, size_t size)
{
    const uint32_t last = (top + rows - 1u) / 8u;
    (void)size;
    for (uint32_t page = top / 8u; page <= last; page++, bytes += width) {
        const uint8_t place[] = {(uint8_t)(SET_PAGE | page),
                                 (uint8_t)(SET_COLUMN_LOW | (left & 15u)),
                                 (uint8_t)(SET_COLUMN_HIGH | left >> 4)};
        if (!send_commands(display, place, sizeof place) ||
            !(page < last ? display->port->send(display->port->user, true, bytes, width)
                          : fxl_display_start_data(display, bytes, width))) {
            return false;
        }
    }
    return true;
}

static const uint8_t turn_on[] = {1, DISPLAY_ON, 0};

const fxl_display_family fxl_display_pages = {
    &fxl_pixels_mono_pages, set_up, send_rows, send_commands, turn_on, 0, 1, 8};
const fxl_display_family fxl_display_sh1107 = {
    &fxl_pixels_mono_pages, set_up_columns, send_rows, send_commands, turn_on, 0, 8, 1};

/* A controller of 64 rows with a glass of 128 x 64, that turns by 0 and 2 quarters: its own
 * commands, the columns of its memory, and the column where the glass begins. */
#define OF_64_ROWS(commands, columns, left) \
    { \
        &fxl_display_pages, commands, sizeof(commands), columns, 64, 128, 64, left, 0x09, false, \
            false \
    }

/* place driver: the record of a driver of pages */
static const uint8_t sh1106_commands[] = {
    0xAD, 0x8B, /* its own voltage converter on */
    0xD9, 0x22, /* lengths of precharge and discharge: as after reset */
    0xDB, 0x35, /* voltage of a row at rest: as after reset */
};

static const uint8_t sh1107_commands[] = {
    0x20,       /* page addressing */
    0xDC, 0x00, /* not scrolled */
    0xD5, 0x50, /* clock: as after reset */
    0xAD, 0x8A, /* its own voltage converter off: modules have another */
    0xD9, 0x22, /* lengths of precharge and discharge: as after reset */
    0xDB, 0x35, /* voltage of a column at rest: as after reset */
};

static const uint8_t ssd1306_commands[] = {
    0x20, 0x02, /* page addressing */
    0x8D, 0x14, /* its own charge pump on */
    0xD9, 0xF1, /* lengths of precharge and discharge, for the charge pump */
    0xDB, 0x40, /* voltage of a row at rest */
};

static const uint8_t ssd1309_commands[] = {
    0xFD, 0x12, /* unlock */
    0x20, 0x02, /* page addressing */
    0xD9, 0x22, /* lengths of precharge and discharge: as after reset */
    0xDB, 0x34, /* voltage of a row at rest: as after reset */
};

/* The glass is joined to the middle 128 of 132 columns. */
const fxl_display_driver fxl_sh1106 = OF_64_ROWS(sh1106_commands, 132, 2);
const fxl_display_driver fxl_ssd1306 = OF_64_ROWS(ssd1306_commands, 128, 0);
const fxl_display_driver fxl_ssd1309 = OF_64_ROWS(ssd1309_commands, 128, 0);
const fxl_display_driver fxl_ssd1309_132 = OF_64_ROWS(ssd1309_commands, 132, 2);

const fxl_display_driver fxl_sh1107 = {&fxl_display_sh1107,
                                       sh1107_commands,
                                       sizeof sh1107_commands,
                                       128,
                                       128,
                                       128,
                                       128,
                                       0,
                                       0x00,
                                       false,
                                       true};

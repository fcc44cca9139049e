/* SPDX-License-Identifier: MIT */
/* SSD1306 and SH1106: controllers of pages of eight rows. Both know the page addressing mode; the
 * SH1106 knows no other. Every byte of a command, its arguments too, is sent as a command. */
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

static bool set_up(const fxl_display *display, const fxl_display_config *config)
{
    const uint8_t reference[] = {SET_REFERENCE, config->current_reference};
    const uint8_t com_pins = config->com_pins != 0 ? config->com_pins
                             : config->height > 32 ? WIRES_IN_TURNS
                                                   : WIRES_IN_ORDER;
    const uint8_t commands[] = {
        0xAE, /* display off */
        0xD5,
        0x80, /* clock: as after reset */
        0xA8,
        (uint8_t)(config->height - 1u), /* rows that the glass has */
        0xD3,
        config->display_offset, /* 0: the first row of memory is the first one of the glass */
        0x40,                   /* not scrolled */
        0xDA,
        com_pins,
        0x81,
        0x80, /* contrast: the middle */
        0xA4, /* memory is shown as it is */
        (uint8_t)(MIRROR_COLUMNS | (config->access & 1u)),
        (uint8_t)(MIRROR_ROWS | (config->access & 8u)),
        (uint8_t)(INVERT | (config->is_inverted ? 1u : 0u)),
    };
    return send_commands(display, commands, sizeof commands) &&
           send_commands(display, config->driver->commands, config->driver->commands_size) &&
           (config->current_reference == 0 || send_commands(display, reference, sizeof reference));
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

const fxl_display_family fxl_display_pages = {
    &fxl_pixels_mono_pages, set_up, send_rows, send_commands, DISPLAY_ON, 0, 1, 8};

/* A controller of 64 rows with a glass of 128 x 64, that turns by 0 and 2 quarters: its own
 * commands, the columns of its memory, and the column where the glass begins. */
#define OF_64_ROWS(commands, columns, left) \
    { \
        &fxl_display_pages, commands, sizeof(commands), columns, 64, 128, 64, left, 0x09, false \
    }

static const uint8_t sh1106_commands[] = {
    0xAD, 0x8B, /* its own voltage converter on */
    0xD9, 0x22, /* lengths of precharge and discharge: as after reset */
    0xDB, 0x35, /* voltage of a row at rest: as after reset */
};

static const uint8_t ssd1306_commands[] = {
    0x20, 0x02, /* page addressing */
    0x8D, 0x14, /* its own charge pump on */
    0xD9, 0xF1, /* lengths of precharge and discharge, for the charge pump */
    0xDB, 0x40, /* voltage of a row at rest */
};

/* The glass is joined to the middle 128 of 132 columns. */
const fxl_display_driver fxl_sh1106 = OF_64_ROWS(sh1106_commands, 132, 2);
const fxl_display_driver fxl_ssd1306 = OF_64_ROWS(ssd1306_commands, 128, 0);

/* SPDX-License-Identifier: MIT */
/* Families of controllers of pages of eight rows: OLEDs of the commands of an SSD1306, in the page
 * addressing mode, and LCDs. Every byte of a command, its arguments too, is sent as a command. */
#include "fixel/driver.h"

enum {
    SET_PAGE = 0xB0,        /* and the number of the page */
    SET_COLUMN_LOW = 0x00,  /* and the lower four bits of the column */
    SET_COLUMN_HIGH = 0x10, /* and the upper ones */
    MIRROR_COLUMNS = 0xA0,  /* and 0 or 1 */
    INVERT = 0xA6,          /* and 0 or 1 */
    SET_REFERENCE = 0xAD,   /* and whether an SSD1306 makes its reference current itself */
    MIRROR_ROWS = 0xC0,     /* and 0 or 8 */
    DISPLAY_ON = 0xAF,
    SET_BANK = 0x40,   /* of a PCD8544: and the number of the page */
    SET_COLUMN = 0x80, /* of a PCD8544: and the column */
    POWER_ON = 0x20    /* of a PCD8544 */
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

/* An LCD scans all its lines, and makes its voltage as its record says. */
static bool set_up_st7565(const fxl_display *display, const fxl_display_config *config)
{
    const fxl_display_driver *driver = config->driver;
    const uint8_t commands[] = {
        0xE2, /* reset */
        0xAE, /* display off */
        0x40, /* not scrolled */
        0xA4, /* memory is shown as it is */
        (uint8_t)(MIRROR_COLUMNS | (config->access & 1u)),
        (uint8_t)(MIRROR_ROWS | (config->access & 8u)),
        (uint8_t)(INVERT | (config->is_inverted ? 1u : 0u)),
    };
    return send_commands(display, commands, sizeof commands) &&
           send_commands(display, driver->commands, driver->commands_size);
}

/* Before it is turned on it is powered down, but for the commands that set it up, and takes
 * commands and pixels. */
static bool set_up_pcd8544(const fxl_display *display, const fxl_display_config *config)
{
    const fxl_display_driver *driver = config->driver;
    const uint8_t commands[] = {
        0x24, /* powered down; pixels go along rows; the commands of every day */
        (uint8_t)(0x0Cu | (config->is_inverted ? 1u : 0u)), /* memory is shown */
    };
    return send_commands(display, driver->commands, driver->commands_size) &&
           send_commands(display, commands, sizeof commands);
}

/* The pixels of a page. All but those of the last one are sent when this returns. */
static bool send_page(const fxl_display *display, bool is_last, const uint8_t *bytes,
                      uint16_t width)
{
    return is_last ? fxl_display_start_data(display, bytes, width)
                   : display->port->send(display->port->user, true, bytes, width);
}

/* A page at a time: the controller does not go on to the next one by itself. */
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
            !send_page(display, page == last, bytes, width)) {
            return false;
        }
    }
    return true;
}

/* The same with the commands of a PCD8544. */
static bool send_rows_pcd8544(const fxl_display *display, uint16_t left, uint16_t top,
                              uint16_t width, uint16_t rows, const uint8_t *bytes, size_t size)
{
    const uint32_t last = (top + rows - 1u) / 8u;
    (void)size;
    for (uint32_t page = top / 8u; page <= last; page++, bytes += width) {
        const uint8_t place[] = {(uint8_t)(SET_BANK | page), (uint8_t)(SET_COLUMN | left)};
        if (!send_commands(display, place, sizeof place) ||
            !send_page(display, page == last, bytes, width)) {
            return false;
        }
    }
    return true;
}

static const uint8_t turn_on[] = {1, DISPLAY_ON, 0};

const fxl_display_family fxl_display_pages = {
    &fxl_pixels_mono_pages, set_up, send_rows, send_commands, turn_on, 0, 1, 8, 0, false};
const fxl_display_family fxl_display_sh1107 = {
    &fxl_pixels_mono_pages, set_up_columns, send_rows, send_commands, turn_on, 0, 8, 1, 0, false};
const fxl_display_family fxl_display_st7565 = {
    &fxl_pixels_mono_pages, set_up_st7565, send_rows, send_commands, turn_on, 0, 1, 8, 0, false};

static const uint8_t power_on[] = {1, POWER_ON, 0};

const fxl_display_family fxl_display_pcd8544 = {
    &fxl_pixels_mono_pages, set_up_pcd8544, send_rows_pcd8544, send_commands, power_on, 0, 0, 0, 0,
    false};

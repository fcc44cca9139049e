/* SPDX-License-Identifier: MIT */
/* ST7789, ILI9341, ILI9488, ST7735, ST7796, GC9A01: controllers with the commands of MIPI's Display
 * Command Set. All else that they can be told keeps the value that it has after reset. */
#include "fixel/driver.h"

enum {
    SOFTWARE_RESET = 0x01,
    SLEEP_OUT = 0x11,
    INVERT_OFF = 0x20,
    INVERT = 0x21,
    DISPLAY_ON = 0x29,
    SET_COLUMNS = 0x2A, /* first, last: two bytes each, the high one first */
    SET_ROWS = 0x2B,
    WRITE_PIXELS = 0x2C,
    SET_ACCESS = 0x36, /* which way rows and columns run, the order of the colours */
    SET_FORMAT = 0x3A
};

#define SIXTEEN_BITS  0x55u
#define EIGHTEEN_BITS 0x66u /* three bytes a pixel */
#define RESET_TIME    150u  /* ms: the longest of the three, from the sleep that a reset ends in */
#define WAKE_UP_TIME  120u

static bool set_up(const fxl_display *display, const fxl_display_config *config)
{
    const fxl_display_port *port = display->port;
    const uint8_t settings[] = {
        2,
        SET_FORMAT,
        (uint8_t)(display->pixels.format->bits == 16 ? SIXTEEN_BITS : EIGHTEEN_BITS),
        2,
        SET_ACCESS,
        config->access,
        1,
        (uint8_t)(config->is_inverted ? INVERT : INVERT_OFF),
        0};
    if (!fxl_display_command(display, SOFTWARE_RESET, NULL, 0)) {
        return false;
    }
    port->pause(port->user, RESET_TIME);
    if (!fxl_display_command(display, SLEEP_OUT, NULL, 0)) {
        return false;
    }
    port->pause(port->user, WAKE_UP_TIME);
    return fxl_display_send_commands(display, config->driver->commands) &&
           fxl_display_send_commands(display, settings);
}

static bool set_range(const fxl_display *display, uint8_t code, uint32_t first, uint32_t count)
{
    const uint32_t last = first + count - 1u;
    const uint8_t range[4] = {(uint8_t)(first >> 8), (uint8_t)first, (uint8_t)(last >> 8),
                              (uint8_t)last};
    return fxl_display_command(display, code, range, sizeof range);
}

static bool send_rows(const fxl_display *display, uint16_t left, uint16_t top, uint16_t width,
                      uint16_t rows, const uint8_t *bytes, size_t size)
{
    return set_range(display, SET_COLUMNS, left, width) &&
           set_range(display, SET_ROWS, top, rows) &&
           fxl_display_command(display, WRITE_PIXELS, NULL, 0) &&
           fxl_display_start_data(display, bytes, size);
}

static bool send_command(const fxl_display *display, const uint8_t *command, size_t size)
{
    return fxl_display_command(display, command[0], command + 1, size - 1u);
}

/* The bits of MIPI's command 0x36. Bit 3 makes the order of the colours blue, green, red. */
#define EXCHANGES       0x20u
#define MIRRORS_COLUMNS 0x40u
#define MIRRORS_ROWS    0x80u

static const uint8_t turn_on[] = {1, DISPLAY_ON, 0};

const fxl_display_family fxl_display_colour = {&fxl_pixels_rgb565, set_up,      send_rows,
                                               send_command,       turn_on,     EXCHANGES,
                                               MIRRORS_COLUMNS,    MIRRORS_ROWS};
const fxl_display_family fxl_display_colour_18 = {&fxl_pixels_rgb666, set_up,      send_rows,
                                                  send_command,       turn_on,     EXCHANGES,
                                                  MIRRORS_COLUMNS,    MIRRORS_ROWS};

/* A controller whose common glass fills its memory. */
#define OF_COLOURS(columns, rows, width, height, access, is_inverted) \
    { \
        &fxl_display_colour, NULL, 0, columns, rows, width, height, 0, access, is_inverted, false \
    }

/* Its glass is blue, green, red, and its columns run from right to left. */
const fxl_display_driver fxl_ili9341 = OF_COLOURS(240, 320, 240, 320, 0x48, false);

/* place driver: the record of a driver of colours */
/* The glass is mounted with its first row at the bottom, and its first column at the right. */
const fxl_display_driver fxl_st7735 = OF_COLOURS(132, 162, 128, 160, 0xC0, false);

const fxl_display_driver fxl_st7789 = OF_COLOURS(240, 320, 240, 320, 0x00, true);
const fxl_display_driver fxl_st7796 = OF_COLOURS(320, 480, 320, 480, 0x48, false);

/* It takes no pixels of 16 bits on SPI. */
const fxl_display_driver fxl_ili9488 = {
    &fxl_display_colour_18, NULL, 0, 320, 480, 320, 480, 0, 0x48, false, false};

/* Which way its columns are joined to the glass is a setting too, and the access is right for one
 * of them alone. */
static const uint8_t gc9a01_commands[] = {
    1, 0xFE,             /* unlock those below: first half */
    1, 0xEF,             /* second half */
    3, 0xB6, 0x00, 0x00, /* columns and rows are scanned from the first one on */
    /* Two registers that its data sheet does not describe. Without them there is no picture, as the
     * author of micropython-nano-gui found; all public drivers set them so. */
    11, 0x66, 0x3C, 0x00, 0xCD, 0x67, 0x45, 0x45, 0x10, 0x00, 0x00, 0x00,
    11, 0x67, 0x00, 0x3C, 0x00, 0x00, 0x00, 0x01, 0x54, 0x10, 0x32, 0x98,
    0,
};
const fxl_display_driver fxl_gc9a01 = {&fxl_display_colour,
                                       gc9a01_commands,
                                       sizeof gc9a01_commands,
                                       240,
                                       240,
                                       240,
                                       240,
                                       0,
                                       0x48,
                                       true,
                                       false};

/* SPDX-License-Identifier: MIT */
/* The family of controllers with the commands of MIPI's Display Command Set; modules.c has their
 * records. What neither this file nor a record sets keeps the value that it has after reset. */
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
#define RESET_TIME    150u  /* ms: the longest of all, from the sleep that a reset ends in */
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

const fxl_display_family fxl_display_colour = {
    &fxl_pixels_rgb565, set_up,       send_rows, send_command, turn_on, EXCHANGES,
    MIRRORS_COLUMNS,    MIRRORS_ROWS, 0,         false};
const fxl_display_family fxl_display_colour_18 = {
    &fxl_pixels_rgb666, set_up,       send_rows, send_command, turn_on, EXCHANGES,
    MIRRORS_COLUMNS,    MIRRORS_ROWS, 0,         false};

/* SPDX-License-Identifier: MIT */
/* Sharp's memory LCDs, which keep whole rows of one bit a pixel. They have no line for commands:
 * each message is a mode, the number of a row, its pixels, and two bytes that end it. Their chip
 * select is high during a message. Numbers come with their lowest bit first, so bytes that are sent
 * with the highest bit first have them reversed. */
#include "fixel/driver.h"

#include "../math/memory.h"

#define WRITE       0x80u
#define ALTERNATION 0x40u /* of the voltage of the glass, which must change once a second */
#define CLEAR       0x20u
#define LONGEST     64u  /* bytes of a row */
#define ROWS_MAX    255u /* whose number is one byte */

static uint8_t reversed(uint32_t byte)
{
    uint32_t bits = 0;
    for (uint32_t i = 0; i < 8; i++) {
        bits = bits << 1 | (byte >> i & 1u);
    }
    return (uint8_t)bits;
}

static uint32_t alternation(const fxl_display *display)
{
    return (display->frame & 1u) != 0 ? ALTERNATION : 0;
}

static bool send_message(const fxl_display *display, const uint8_t *message, size_t size)
{
    return display->port->send(display->port->user, true, message, size);
}

/* Refuses what it can't be: inverted, or a record of the caller's with a memory that a message has no
 * room for. */
static bool set_up(const fxl_display *display, const fxl_display_config *config)
{
    static const uint8_t clear[] = {CLEAR, 0};
    const fxl_display_driver *driver = config->driver;
    return !config->is_inverted && driver->memory_columns % 8u == 0 &&
           driver->memory_columns <= 8u * LONGEST && driver->memory_rows <= ROWS_MAX &&
           send_message(display, clear, sizeof clear);
}

/* Puts a row of pixels into one of zeros, from a column on: what is around them stays black. The
 * last byte reaches into the one behind, by bits that are 0: left / 8 + size <= columns / 8 of the
 * memory. */
static void put_row(uint8_t *row, uint32_t left, const uint8_t *bytes, uint32_t size)
{
    const uint32_t shift = left % 8u;
    row += left / 8u;
    for (uint32_t i = 0; i < size; i++) {
        const uint32_t pair = (uint32_t)bytes[i] << (8u - shift);
        row[i] = (uint8_t)(row[i] | pair >> 8);
        row[i + 1u] = (uint8_t)(row[i + 1u] | pair);
    }
}

/* A row is numbered from 1 on. Bits behind the pixels of `bytes` are 0. */
static bool send_row(const fxl_display *display, uint32_t left, uint32_t row, const uint8_t *bytes,
                     uint32_t size)
{
    const uint32_t length = display->driver->memory_columns / 8u;
    uint8_t message[2u + LONGEST + 2u] = {0};
    message[0] = (uint8_t)(WRITE | alternation(display));
    message[1] = reversed(row + 1u);
    put_row(&message[2], left, bytes, size);
    return send_message(display, message, 2u + length + 2u);
}

static bool send_rows(const fxl_display *display, uint16_t left, uint16_t top, uint16_t width,
                      uint16_t rows, const uint8_t *bytes, size_t size)
{
    const uint32_t each = (width + 7u) / 8u;
    (void)size;
    for (uint32_t i = 0; i < rows; i++, bytes += each) {
        if (!send_row(display, left, top + i, bytes, each)) {
            return false;
        }
    }
    return true;
}

/* A message without rows. */
/* changed 4.4 */
fxl_status fxl_display_alternate(fxl_display *display)
{
    if (display == NULL) {
        return FXL_E_ARGUMENT;
    }
    if (display->driver == NULL || display->driver->family != &fxl_display_memory_lcd) {
        return FXL_E_RANGE;
    }
    display->frame++;
    const uint8_t message[] = {(uint8_t)alternation(display), 0};
    return display->sink.wait(display) && send_message(display, message, sizeof message)
               ? FXL_OK
               : FXL_E_DISPLAY;
}

/* Nothing turns it on but a pin. */
const fxl_display_family fxl_display_memory_lcd = {
    &fxl_pixels_mono_rows, set_up, send_rows, send_message, NULL, 0, 0, 0, 0, true};

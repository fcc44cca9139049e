/* SPDX-License-Identifier: MIT */
/* A page is eight rows; a byte is eight pixels of a column, the topmost in the lowest bit. The
 * window of a frame is collected here, in two pages, and sent when the frame ends. */
#include "parts/ssd0303.h"

#include "fixel/pixels.h"

#define PAGES        (SSD0303_HEIGHT / 8u)
#define FIRST_COLUMN 36u /* of the controller's 132 columns: the first one of the module */

/* The first byte of a message gives the kind of the next. */
#define CONTROL_COMMAND 0x80u
#define CONTROL_DATA    0x40u

static uint16_t greys[256]; /* of the palette's entries: fxl_grey_table */
static bool is_rgb565;      /* the frame's pixels are no entries of the palette */
static uint32_t left, top;  /* the window's first column and row in the frame */
static uint8_t message[PAGES][1u + SSD0303_WIDTH];

/* A message for each command: after a command's argument the emulator does not expect another
 * command. */
static bool send_commands(const uint8_t *commands, size_t count)
{
    size_t i;
    bool good = true;

    for (i = 0; i < count && good; i++) {
        const uint8_t one[] = {CONTROL_COMMAND, commands[i]};

        good = ssd0303_send(one, sizeof one);
    }
    return good;
}

/* For the OSRAM Pictiva module of 96 x 16: its connections, and its maker's values for currents
 * and voltages. The emulator uses only on, off, addresses and inversion. */
static bool configure(void)
{
    static const uint8_t commands[] = {
        0x81, 0x2B, /* contrast */
        0xA1,       /* columns from right to left, as the module is wired */
        0x40,       /* first row of memory on top */
        0xD3, 0x00, /* and on the controller's first row */
        0xA8, 0x0F, /* 16 rows */
        0xA4,       /* memory is shown as it is, */
        0xA6,       /* a 1 light */
        0xC8,       /* rows from bottom to top */
        0xD5, 0x72, /* clock */
        0xD8, 0x00, /* one colour */
        0xD9, 0x22, /* lengths of discharge and precharge */
        0xDA, 0x12, /* how the rows are connected */
        0xDB, 0x0F, /* voltage of a row at rest */
        0xAD, 0x8B, /* its own voltage converter on */
    };

    return send_commands(commands, sizeof commands);
}

static bool send_page(uint32_t page)
{
    const uint8_t place[] = {(uint8_t)(0xB0u + page), FIRST_COLUMN & 15u,
                             (uint8_t)(0x10u + (FIRST_COLUMN >> 4))};

    message[page][0] = CONTROL_DATA;
    return send_commands(place, sizeof place) && ssd0303_send(message[page], sizeof message[page]);
}

static bool send_pages(void)
{
    uint32_t page;
    bool good = true;

    for (page = 0; page < PAGES && good; page++) {
        good = send_page(page);
    }
    return good;
}

static panel_answer open(const panel_format *format)
{
    static const uint8_t off[] = {0xAE}, on[] = {0xAF};

    if (format->width < SSD0303_WIDTH || format->height < SSD0303_HEIGHT) {
        return PANEL_UNSUITABLE;
    }
    if (!send_commands(off, sizeof off)) {
        return PANEL_UNSUITABLE; /* the display is absent */
    }
    left = (format->width - SSD0303_WIDTH) / 2u;
    top = (format->height - SSD0303_HEIGHT) / 2u;
    is_rgb565 = format->pixel_bits == 16;
    fxl_grey_table(greys, format->palette, 1);
    if (!configure() || !send_pages() || !send_commands(on, sizeof on)) {
        return PANEL_FAILED;
    }
    return PANEL_READY;
}

static uint16_t grey_of(const void *pixels, uint32_t x)
{
    return is_rgb565 ? fxl_grey_of_rgb565(((const uint16_t *)pixels)[x], 1)
                     : greys[((const uint8_t *)pixels)[x]];
}

/* Copies the part of a row of the frame that lies in the window. */
static void gather(uint32_t y, const void *pixels)
{
    const uint32_t row = y - top;
    const uint8_t bit = (uint8_t)(1u << (row % 8u));
    uint8_t *bytes = &message[row / 8u][1];
    uint32_t i;

    for (i = 0; i < SSD0303_WIDTH; i++) {
        if (fxl_grey_level(grey_of(pixels, left + i), left + i, y) != 0) {
            bytes[i] |= bit;
        } else {
            bytes[i] &= (uint8_t)~bit;
        }
    }
}

static bool flush(uint16_t x, uint16_t y, uint16_t width, uint16_t height, const void *pixels)
{
    const uint8_t *bytes = pixels;
    const uint32_t row_bytes = is_rgb565 ? 2u * width : width;
    uint32_t row;

    (void)x; /* whole rows come */
    for (row = y; row < (uint32_t)y + height; row++) {
        if (row - top < SSD0303_HEIGHT) { /* a row above the top is far below it, unsigned */
            gather(row, bytes + (row - y) * row_bytes);
        }
    }
    return true;
}

static bool end(const fxl_counters *counters, uint32_t clamped, uint64_t instructions)
{
    (void)counters;
    (void)clamped;
    (void)instructions;
    return send_pages();
}

/* The last frame stays on the screen. */
static bool close(bool whole)
{
    (void)whole;
    return true;
}

const panel ssd0303_panel = {open, NULL, flush, end, close};

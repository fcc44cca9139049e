/* SPDX-License-Identifier: MIT */
/* A byte is two pixels, the left one in the high half; a row is 64 bytes. A window of rows is
 * set for each rectangle, and the controller advances through it. */
#include "parts/ssd0323.h"

#include "fixel/pixels.h"

#define ROW_BYTES (SSD0323_WIDTH / 2u)

enum {
    SET_COLUMNS = 0x15, /* first, last, in bytes */
    SET_ROWS = 0x75     /* first, last */
};

static fxl_pixels greys;    /* of the palette's entries */
static uint8_t pixel_bytes; /* 1 or 2 */

/* For the OSRAM Pictiva module of 128 x 64: its connections (remap, offset, rows) and its
 * maker's values for currents and voltages. The emulator uses only the windows and bit 2 of the
 * remap. */
static bool configure(void)
{
    static const uint8_t commands[] = {
        0xAE,                  /* display off */
        SET_COLUMNS, 0,    63, /* all of the module's columns, */
        SET_ROWS,    0,    63, /* and rows */
        0x81,        50,       /* contrast, of 127 */
        0x85,                  /* half of the full current */
        0xA0,        0x52,     /* COM split and reversed; high half of a byte is left; by rows */
        0xA1,        0,        /* first row of memory on top */
        0xA2,        0x4C,     /* which row of the controller the module's first is */
        0xA4,                  /* memory is shown as it is */
        0xA8,        63,       /* 64 rows */
        0xB1,        0x22,     /* lengths of discharge and precharge */
        0xB2,        70,       /* length of a row */
        0xB3,        0xF1,     /* clock: highest, divided by 2 */
        0xBF,        0x0D,     /* voltage of a dark segment */
        0xBE,        0x02,     /* voltage of a row at rest */
        0xBC,        0x10,     /* precharge voltage */
        0xB8,        0x01,     /* widths of the greys' pulses: even steps */
        0x11,        0x22, 0x32, 0x43, 0x54,
        0x65,        0x76, 0xAD, 0x03, /* its own voltage converter on */
    };

    return ssd0323_send(SSD0323_COMMAND, commands, sizeof commands);
}

static bool set_rows(uint32_t first, uint32_t last)
{
    const uint8_t commands[] = {SET_COLUMNS,  0, ROW_BYTES - 1u, SET_ROWS, (uint8_t)first,
                                (uint8_t)last};

    return ssd0323_send(SSD0323_COMMAND, commands, sizeof commands);
}

/* Its memory holds noise when power comes. */
static bool clear(void)
{
    static const uint8_t dark[ROW_BYTES];
    uint32_t row;
    bool good = set_rows(0, SSD0323_HEIGHT - 1u);

    for (row = 0; row < SSD0323_HEIGHT && good; row++) {
        good = ssd0323_send(SSD0323_DATA, dark, sizeof dark);
    }
    return good;
}

static panel_answer open(const panel_format *format)
{
    static const uint8_t on[] = {0xAF};

    if (format->width != SSD0323_WIDTH || format->height != SSD0323_HEIGHT) {
        return PANEL_UNSUITABLE;
    }
    pixel_bytes = format->pixel_bits / 8u;
    (void)fxl_pixels_init(&greys, &fxl_pixels_grey4, format->palette);
    if (!ssd0323_wires_open() || !configure() || !clear() ||
        !ssd0323_send(SSD0323_COMMAND, on, sizeof on)) {
        return PANEL_FAILED;
    }
    return PANEL_READY;
}

/* Sends row by row, each through a buffer of its own. When it returns, no transfer is in
 * progress: the pixels are the caller's again. */
static bool flush(uint16_t x, uint16_t y, uint16_t width, uint16_t height, const void *pixels)
{
    uint32_t packed[ROW_BYTES / 4u];
    uint32_t row;
    bool good = set_rows(y, y + height - 1u);

    (void)x; /* whole rows come */
    for (row = 0; row < height && good; row++) {
        /* It only reads the pixels. */
        const fxl_band one = {.pixels = (uint8_t *)(uintptr_t)pixels + row * width * pixel_bytes,
                              .width = width,
                              .stride = width,
                              .first_row = (uint16_t)(y + row),
                              .rows = 1,
                              /* Which colours is not asked: a pixel of RGB565 has its own. */
                              .palette = pixel_bytes == 2 ? greys.entries : NULL};

        good = fxl_pixels_convert(&greys, &one, packed, sizeof packed) == FXL_OK &&
               ssd0323_send(SSD0323_DATA, (const uint8_t *)packed, sizeof packed);
    }
    return good;
}

/* The last frame stays on the screen. */
static bool close(bool whole)
{
    (void)whole;
    return true;
}

const panel ssd0323_panel = {open, NULL, flush, NULL, close};

/* SPDX-License-Identifier: MIT */
/* A panel that sends the frames by a pump through a driver of the library, as a real display would
 * get them, and records its wires (make run DRIVER=ili9341). It stands beside the board's own
 * panels: the linker hands their list to it first (firmware/firmware.mk).
 *
 * DRIVER_NAME: a driver of fixel/display.h, or with DRIVER_IS_MODULE a module of fixel/modules.h.
 * DRIVER_BITS: of its pixels. DRIVER_ROWS: the rows of a transfer. DRIVER_WIDEST: the pixels of its
 * longest row, if more than usual. */
#include <stddef.h>

#include "contract/panel.h"
#include "fixel/display.h"
#include "fixel/modules.h"
#include "parts/wires.h"

#if DRIVER_BITS == 1
#define WIDEST        128u
#define ROWS          8u /* a page */
#define QUARTER_TURNS 0u
#else
#ifdef DRIVER_WIDEST
#define WIDEST DRIVER_WIDEST
#else
#define WIDEST 320u
#endif
#define ROWS          DRIVER_ROWS
#define QUARTER_TURNS 1u /* the long side is the upper one */
#endif
#ifdef DRIVER_IS_MODULE
#define CONFIG_OF fxl_display_config_turned
#else
#define CONFIG_OF fxl_display_config_default
#endif
#define PANELS_MAX 24u

/* The kinds of docs/formats.md, section 5. */
enum {
    COMMAND = 'C',
    DATA = 'D',
    PAUSE = 'P',
    FRAME_END = 'F'
};

static fxl_display display;
static fxl_pump pump;
static uint64_t memory[FXL_PUMP_MEMORY(WIDEST, ROWS, DRIVER_BITS)];
static uint32_t frames; /* ended */
static uint16_t frame_height;
static uint8_t pixel_bytes; /* 1 or 2 */
static struct {
    const uint8_t *bytes; /* null: nothing is being sent */
    size_t size;
} transfer;

static void put_u32(uint8_t to[4], uint32_t value)
{
    to[0] = (uint8_t)value;
    to[1] = (uint8_t)(value >> 8);
    to[2] = (uint8_t)(value >> 16);
    to[3] = (uint8_t)(value >> 24);
}

static bool put(uint8_t kind, const uint8_t *bytes, size_t size)
{
    uint8_t head[5] = {kind, 0, 0, 0, 0};

    put_u32(head + 1, (uint32_t)size);
    return record_write(head, sizeof head) && record_write(bytes, size);
}

static bool put_number(uint8_t kind, uint32_t number)
{
    uint8_t bytes[4];

    put_u32(bytes, number);
    return put(kind, bytes, sizeof bytes);
}

/* --- the wires ----------------------------------------------------------------------------- */

static bool send(void *user, bool is_data, const uint8_t *bytes, size_t size)
{
    (void)user;
    return transfer.bytes == NULL && put(is_data ? DATA : COMMAND, bytes, size);
}

/* As unkind as DMA may be: it reads every byte at the last moment, in wait. */
static bool start(void *user, const uint8_t *bytes, size_t size)
{
    const bool is_free = transfer.bytes == NULL;

    (void)user;
    transfer.bytes = bytes;
    transfer.size = size;
    return is_free;
}

static bool wait(void *user)
{
    const uint8_t *bytes = transfer.bytes;

    (void)user;
    transfer.bytes = NULL;
    return bytes == NULL || put(DATA, bytes, transfer.size);
}

static bool pause_is_noted;

static void pause(void *user, uint32_t milliseconds)
{
    (void)user;
    pause_is_noted = put_number(PAUSE, milliseconds) && pause_is_noted;
}

static const fxl_display_port wires = {NULL, send, start, wait, pause};

/* --- the panel ----------------------------------------------------------------------------- */

static fxl_status open_display(const panel_format *format)
{
    const bool is_upright = format->height > format->width;
    const fxl_display_config config =
        CONFIG_OF(&DRIVER_NAME, is_upright ? 0u : QUARTER_TURNS);
    const uint16_t rows = format->height < ROWS ? format->height : (uint16_t)ROWS;
    const fxl_pump_config bands = {&display.pixels, format->width, format->height, rows, NULL};
    fxl_status status = fxl_display_open(&display, &config, &wires, format->palette);

    if (status == FXL_OK) {
        status = fxl_display_place(&display, format->width, format->height);
    }
    return status == FXL_OK ? fxl_pump_init(&pump, &bands, &display.sink, memory, sizeof memory)
                            : status;
}

static panel_answer open(const panel_format *format)
{
    if (!record_open()) {
        return PANEL_FAILED;
    }
    pixel_bytes = format->pixel_bits / 8u;
    frames = 0;
    frame_height = format->height;
    transfer.bytes = NULL;
    pause_is_noted = true;
    if (open_display(format) != FXL_OK || !pause_is_noted) {
        (void)record_close();
        return PANEL_FAILED;
    }
    return PANEL_READY;
}

/* Sends what is there in pieces of the pump's rows. Where a piece of a page is left over, the walk
 * was given bands that do not fit the display: ROWS= is then to be a multiple of 8. */
static bool flush(uint16_t x, uint16_t y, uint16_t width, uint16_t height, const void *pixels)
{
    uint16_t row;

    (void)x; /* whole rows come */
    for (row = 0; row < height; row = (uint16_t)(row + ROWS)) {
        const uint16_t left = (uint16_t)(height - row);
        const fxl_band band = {.pixels = (uint8_t *)(uintptr_t)pixels + (size_t)row * width * pixel_bytes,
                               .width = width, .stride = width, .first_row = (uint16_t)(y + row),
                               .rows = left < ROWS ? left : (uint16_t)ROWS,
                               /* Which colours is not asked: a pixel of RGB565 has its own. */
                               .palette = pixel_bytes == 2 ? display.pixels.entries : NULL};

        if (fxl_pump_send_rows(&pump, &band) != FXL_OK) {
            return false;
        }
    }
    return true;
}

static bool end(const fxl_counters *counters, uint32_t clamped, uint64_t instructions)
{
    (void)counters;
    (void)clamped;
    (void)instructions;
    return fxl_pump_wait(&pump) == FXL_OK && put_number(FRAME_END, frames++);
}

static bool close(bool whole)
{
    const bool is_sent = !whole || fxl_pump_wait(&pump) == FXL_OK;

    return record_close() && is_sent;
}

static const panel driver_panel = {open, NULL, flush, end, close};

/* --- beside the board's own panels --------------------------------------------------------- */

const panel *const *__real_board_panels(void);
const panel *const *__wrap_board_panels(void);

const panel *const *__wrap_board_panels(void)
{
    static const panel *panels[PANELS_MAX + 1u];
    const panel *const *list = __real_board_panels();
    uint32_t i;

    for (i = 0; i < PANELS_MAX - 1u && list[i] != NULL; i++) {
        panels[i] = list[i];
    }
    panels[i] = &driver_panel;
    panels[i + 1u] = NULL;
    return panels;
}

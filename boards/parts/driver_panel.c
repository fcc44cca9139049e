/* SPDX-License-Identifier: MIT */
/* A panel that sends the frames by a pump through a driver of the library, as a real display would
 * get them (make run DRIVER=ili9341). Where no display hangs on the board, its wires are recorded.
 * It stands beside the board's own panels: the linker hands their list to it first
 * (firmware/firmware.mk).
 *
 * DRIVER_NAME: a driver of fixel/display.h, or with DRIVER_IS_MODULE a module.
 * DRIVER_ALONE: the board's own panels are left out. DRIVER_BITS: of its pixels. DRIVER_ROWS: the
 * rows of a transfer; of one bit a pixel they are 8. DRIVER_SIDE: the longer side of its glass. */
#include <stddef.h>

#include "contract/panel.h"
#include "fixel/display.h"
#include "parts/wires.h"

#if DRIVER_BITS == 1
#define ROWS 8u /* a page */
#else
#define ROWS DRIVER_ROWS
#endif
#define TURNS_BY_QUARTERS (DRIVER_BITS >= 16) /* colours */
#ifdef DRIVER_IS_MODULE
#define CONFIG_OF fxl_display_config_turned
#else
#define CONFIG_OF fxl_display_config_default
#endif
#define PANELS_MAX 24u

static fxl_display display;
static fxl_pump pump;
static uint64_t memory[FXL_PUMP_MEMORY(DRIVER_SIDE, ROWS, DRIVER_BITS)];
static uint32_t frames;     /* ended */
static uint8_t pixel_bytes; /* 1 or 2 */

/* --- the panel ----------------------------------------------------------------------------- */

/* Of colours the long side of the glass is where that of the frame is. A square frame lies on an upright glass. */
static fxl_display_config config_for(const panel_format *format)
{
    const bool is_upright = format->height > format->width;
    const fxl_display_config config = CONFIG_OF(&DRIVER_NAME, 0);
    const bool is_glass_upright = config.height >= config.width;

    return !TURNS_BY_QUARTERS || is_upright == is_glass_upright ? config
                                                                : CONFIG_OF(&DRIVER_NAME, 1);
}

static fxl_status open_display(const panel_format *format)
{
    const fxl_display_config config = config_for(format);
    const uint16_t rows = format->height < ROWS ? format->height : (uint16_t)ROWS;
    const fxl_pump_config bands = {&display.pixels, format->width, format->height, rows, NULL};
    fxl_status status = fxl_display_open(&display, &config, &wires_port, format->palette);

    if (status == FXL_OK) {
        status = fxl_display_place(&display, format->width, format->height);
    }
    return status == FXL_OK ? fxl_pump_init(&pump, &bands, &display.sink, memory, sizeof memory)
                            : status;
}

static panel_answer open(const panel_format *format)
{
    if (!wires_open()) {
        return PANEL_FAILED;
    }
    pixel_bytes = format->pixel_bits / 8u;
    frames = 0;
    if (open_display(format) != FXL_OK) {
        (void)wires_close();
        return PANEL_FAILED;
    }
    return PANEL_READY;
}

/* Sends what is there in pieces of the pump's rows: whole rows, or those of a box (firmware/own/own.c).
 * Where a piece of a page is left over, the walk was given bands that do not fit the display: ROWS= is
 * then to be a multiple of 8. */
static bool flush(uint16_t x, uint16_t y, uint16_t width, uint16_t height, const void *pixels)
{
    uint16_t row;

    for (row = 0; row < height; row = (uint16_t)(row + ROWS)) {
        const uint16_t left = (uint16_t)(height - row);
        const fxl_band band = {.pixels =
                                   (uint8_t *)(uintptr_t)pixels + (size_t)row * width * pixel_bytes,
                               .width = pump.config.width,
                               .first_column = x,
                               .columns = width,
                               .stride = width,
                               .first_row = (uint16_t)(y + row),
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
    return fxl_pump_wait(&pump) == FXL_OK && wires_end_frame(frames++);
}

static bool close(bool whole)
{
    const bool is_sent = !whole || fxl_pump_wait(&pump) == FXL_OK;

    return wires_close() && is_sent;
}

extern const panel driver_panel; /* firmware/own/own.c */
const panel driver_panel = {open, NULL, flush, end, close};

/* --- beside the board's own panels --------------------------------------------------------- */

const panel *const *__real_board_panels(void);
const panel *const *__wrap_board_panels(void);

/* With DRIVER_ALONE in their place: they need a debugger. */
const panel *const *__wrap_board_panels(void)
{
#if defined DRIVER_ALONE
    static const panel *const panels[] = {&driver_panel, NULL};
#else
    static const panel *panels[PANELS_MAX + 1u];
    const panel *const *list = __real_board_panels();
    uint32_t i;

    for (i = 0; i < PANELS_MAX - 1u && list[i] != NULL; i++) {
        panels[i] = list[i];
    }
    panels[i] = &driver_panel;
    panels[i + 1u] = NULL;
#endif
    return panels;
}

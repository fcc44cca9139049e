/* SPDX-License-Identifier: MIT */
#include "parts.h"

#include <string.h>

#include "../unit/controller.h"
#include "../unit/pixel_formats.h"
#include "answers.h"
#include "fixel/driver.h"

enum {
    WIDTH = 24,
    HEIGHT = 16,
    WIDEST = 80,
    ROWS = 17,
    LARGEST = WIDEST * ROWS * 3 / 4 + 2, /* words of a band of three bytes a pixel, and guards */
    GUARD = 0x5A
};

static const fxl_pixel_format *const formats[] = EVERY_FORMAT;
#define FORMATS ((uint32_t)(sizeof formats / sizeof formats[0]))
static const fxl_display_driver *const drivers[] = EVERY_DRIVER;
#define DRIVERS (sizeof drivers / sizeof drivers[0])
static uint8_t palette[3 * FXL_PALETTE_COLOURS];

/* Wires that fail at one call, and never before. */
typedef struct {
    uint32_t calls, fails_at;
    const uint8_t *sent; /* under way */
    uint8_t first_byte;
} fuzz_wires;

static bool count_call(fuzz_wires *wires)
{
    DEMAND(wires->calls <= wires->fails_at);
    return wires->calls++ != wires->fails_at;
}

static bool send(void *user, bool is_data, const uint8_t *bytes, size_t size)
{
    fuzz_wires *wires = (fuzz_wires *)user;
    record_number(is_data);
    record_bytes(bytes, size);
    DEMAND(wires->sent == NULL && bytes != NULL && size > 0 && (is_data || size < 64));
    return count_call(wires);
}

static bool begin(void *user, const uint8_t *bytes, size_t size)
{
    fuzz_wires *wires = (fuzz_wires *)user;
    DEMAND(wires->sent == NULL && size > 0);
    wires->sent = bytes;
    record_bytes(bytes, size);
    wires->first_byte = bytes[0];
    return count_call(wires);
}

static bool start(void *user, uint16_t first_row, uint16_t rows, const uint8_t *bytes, size_t size)
{
    DEMAND(rows > 0 && first_row + rows <= HEIGHT);
    return begin(user, bytes, size);
}

static bool wait(void *user)
{
    fuzz_wires *wires = (fuzz_wires *)user;
    DEMAND(wires->sent == NULL || wires->sent[0] == wires->first_byte);
    wires->sent = NULL;
    return true;
}

static void pause(void *user, uint32_t milliseconds)
{
    (void)user;
    DEMAND(milliseconds < 1000);
}

/* A band of RGB565, or some columns of it, of the same shape: the same status, and no byte behind
 * the result. */
static void demand_565(const fxl_pixels *pixels, const fxl_band *band, fxl_status status)
{
    static uint16_t frame[WIDEST * ROWS];
    static uint32_t out[LARGEST];
    static const uint16_t colours[256];
    for (uint32_t i = 0; i < WIDEST * ROWS; i++) {
        frame[i] = (uint16_t)(i * 40503u);
    }
    for (uint16_t columns = 0; columns <= band->width; columns = (uint16_t)(columns + 3)) {
        fxl_band wide = *band;
        wide.pixels = (uint8_t *)frame;
        wide.palette = colours;
        wide.columns = columns;
        wide.first_column = (uint16_t)(columns == 0 ? 0 : (band->width - columns) / 2);
        const size_t size = fxl_pixels_size(pixels->format,
                                            columns == 0 ? band->width : columns, band->rows);
        DEMAND(size < sizeof out);
        memset(out, GUARD, sizeof out);
        const fxl_status answer = fxl_pixels_convert(pixels, &wide, out, size);
        DEMAND(answer == status || (columns != 0 && status == FXL_E_RANGE));
        for (size_t at = answer == FXL_OK ? size : 0; at < sizeof out; at++) {
            DEMAND(((const uint8_t *)out)[at] == GUARD);
        }
        wide.pixels++;
        DEMAND(answer == FXL_E_ARGUMENT ||
               fxl_pixels_convert(pixels, &wide, out, size) == FXL_E_ALIGNMENT);
    }
}

/* Bands of any shape in each format: a status, and no byte behind the result. */
static void fuzz_formats(fuzz_input *in)
{
    static uint8_t frame[WIDEST * ROWS];
    static uint32_t out[LARGEST];
    static fxl_pixels pixels;
    const uint32_t run = 1u + fuzz_below(in, 64), noise = fuzz_below(in, 2);
    fxl_band band = {.pixels = frame, .width = 0, .stride = 0, .first_row = 0, .rows = 0};
    band.width = (uint16_t)fuzz_below(in, 68);
    band.stride = (uint16_t)fuzz_below(in, WIDEST + 1);
    band.first_row = (uint16_t)fuzz_below(in, 32);
    band.rows = (uint16_t)fuzz_below(in, ROWS + 1);
    for (uint32_t i = 0; i < sizeof frame; i++) {
        frame[i] = (uint8_t)(noise != 0 ? fuzz_bits(in, 1) : i / run);
    }
    for (uint32_t i = 0; i < sizeof formats / sizeof formats[0]; i++) {
        DEMAND(fxl_pixels_init(&pixels, formats[i], palette) == FXL_OK);
        const size_t size = fxl_pixels_size(formats[i], band.width, band.rows);
        DEMAND(size < sizeof out);
        memset(out, GUARD, sizeof out);
        fxl_status status = fxl_pixels_convert(&pixels, &band, out, size);
        const bool is_empty = band.width == 0 || band.rows == 0;
        const bool is_wrong = band.stride < band.width || band.first_row % formats[i]->rows != 0;
        DEMAND(status == (is_empty ? FXL_E_ARGUMENT : is_wrong ? FXL_E_RANGE : FXL_OK));
        demand_565(&pixels, &band, status);
        const uint8_t *bytes = (const uint8_t *)out;
        for (size_t at = status == FXL_OK ? size : 0; at < sizeof out; at++) {
            DEMAND(bytes[at] == GUARD);
        }
        if (status == FXL_OK) {
            record_bytes(out, size);
            DEMAND(fxl_pixels_convert(&pixels, &band, out, size - 1) == FXL_E_CAPACITY);
            DEMAND(fxl_pixels_convert(&pixels, &band, (uint8_t *)out + 1, size) == FXL_E_ALIGNMENT);
        }
    }
    DEMAND(fxl_pixels_init(&pixels, NULL, palette) == FXL_E_ARGUMENT);
    DEMAND(fxl_pixels_convert(&pixels, &band, NULL, 0) == FXL_E_ARGUMENT);
}

/* The parts of a format of the caller's own: each stays in its range, and writes nothing else. */
static void fuzz_parts(fuzz_input in)
{
    uint16_t table[FXL_PALETTE_COLOURS], colours[FXL_PALETTE_COLOURS], row[WIDEST + 2];
    uint8_t pixels[WIDEST + 3];
    const uint32_t highest = 1u + fuzz_below(&in, 255), from = fuzz_below(&in, 4),
                   to = fuzz_below(&in, 2), count = fuzz_below(&in, WIDEST),
                   run = 1u + fuzz_below(&in, 9);
    for (uint32_t i = 0; i < FXL_PALETTE_COLOURS; i++) {
        colours[i] = (uint16_t)(i * 257u + run);
    }
    for (uint32_t i = 0; i < sizeof pixels; i++) {
        pixels[i] = (uint8_t)(i % run == 0 ? fuzz_bits(&in, 1) : pixels[i - 1]);
    }
    memset(row, GUARD, sizeof row);
    fxl_row_to_16(pixels + from, count, colours, row + to);
    for (uint32_t i = 0; i < WIDEST + 2; i++) {
        const bool is_inside = i >= to && i < to + count;
        DEMAND(row[i] == (is_inside ? colours[pixels[from + i - to]] : GUARD * 257u));
    }
    fxl_grey_table(table, palette, highest);
    for (uint32_t i = 0; i < FXL_PALETTE_COLOURS; i++) {
        const uint32_t luma = fxl_luma(palette + 3u * i), x = (uint32_t)fuzz_any(&in);
        const uint32_t level = fxl_grey_level(table[i], x, (uint32_t)fuzz_any(&in));
        record_number(level);
        DEMAND(level == highest * luma / 255u || level == highest * luma / 255u + 1u);
        DEMAND(level <= highest);
    }
}

static fxl_status send_elsewhere(fuzz_input *in, fxl_pump *pump, uint8_t *lent)
{
    fxl_band rows = {.pixels = lent, .width = 0, .stride = 0, .first_row = 0, .rows = 0};
    rows.width = (uint16_t)(WIDTH + (fuzz_below(in, 16) == 1));
    rows.stride = (uint16_t)(WIDTH + fuzz_below(in, 3) - 1u);
    rows.first_row = (uint16_t)fuzz_below(in, HEIGHT + 1);
    rows.rows = (uint16_t)fuzz_below(in, 10);
    DEMAND(fxl_pump_send_rows(pump, NULL) == FXL_E_ARGUMENT);
    return fxl_pump_send_rows(pump, &rows);
}

/* Frames through a pump, with wires that fail sooner or later. */
static void fuzz_pump(fuzz_input *in, fxl_renderer *renderer, const fxl_pose *eye)
{
    static uint64_t memory[FXL_PUMP_MEMORY(WIDTH, HEIGHT, 24)];
    static uint8_t lent[10 * (WIDTH + 2)];
    static const uint16_t colours[256];
    static fxl_pixels pixels;
    static fxl_pump pump;
    const uint32_t format = fuzz_below(in, FORMATS + 1);
    fuzz_wires wires = {0, fuzz_below(in, 2) ? UINT32_MAX - 1u : fuzz_below(in, 20), NULL, 0};
    const fxl_pump_sink sink = {.user = &wires, .start = start, .wait = wait},
                        no_sink = {.user = &wires, .wait = wait};
    fxl_pump_config config = {NULL, WIDTH, HEIGHT, (uint16_t)fuzz_below(in, HEIGHT + 2), NULL};
    if (format < FORMATS) {
        DEMAND(fxl_pixels_init(&pixels, formats[format], palette) == FXL_OK);
        config.pixels = &pixels;
    }
    const size_t size = fxl_pump_memory_size(&config);
    fxl_status status = fxl_pump_init(&pump, &config, &sink, memory, size);
    DEMAND(status == (size == 0 ? FXL_E_RANGE : FXL_OK));
    DEMAND(fxl_pump_init(&pump, &config, &no_sink, memory, size) == FXL_E_ARGUMENT);
    if (status != FXL_OK) {
        return;
    }
    DEMAND(fxl_pump_init(&pump, &config, &sink, memory, size - 1) == FXL_E_CAPACITY);
    DEMAND(fxl_pump_init(&pump, &config, &sink, (uint8_t *)memory + 4, size) == FXL_E_ALIGNMENT);
    DEMAND(fxl_pump_send(&pump) == FXL_E_ORDER && fxl_pump_band(&pump) == NULL);
    pump.config.palette = colours;
    DEMAND(fxl_pump_frame(&pump, renderer, eye) == FXL_E_COMBINATION);
    if (config.pixels == NULL && config.rows > 0) {
        const fxl_band rows = {.pixels = lent, .width = WIDTH, .stride = WIDTH, .rows = 1};
        DEMAND(fxl_pump_send_rows(&pump, &rows) == FXL_E_COMBINATION);
    }
    pump.config.palette = NULL;
    status = fxl_pump_frame(&pump, renderer, eye);
    DEMAND(status == FXL_OK || (status == FXL_E_DISPLAY && fxl_pump_band(&pump) == NULL));
    if (status == FXL_OK) {
        DEMAND(fxl_pump_begin(&pump) == FXL_OK && fxl_pump_band(&pump)->first_row == 0);
        status = send_elsewhere(in, &pump, lent);
        DEMAND(status != FXL_E_DISPLAY || wires.calls > wires.fails_at);
    }
    DEMAND(fxl_pump_wait(&pump) == FXL_OK && wires.sent == NULL);
    DEMAND(fxl_pump_frame(NULL, renderer, eye) == FXL_E_ARGUMENT);
    pump.config.height -= 1;
    DEMAND(fxl_pump_frame(&pump, renderer, eye) == FXL_E_RANGE);
}

/* --- boxes of a frame: nothing is recorded ------------------------------------------------------ */

/* Sends, where the number of calls before is not that of the failure. */
typedef struct {
    uint32_t calls, fails_at;
} box_wires;

static bool start_box(void *user, const fxl_screen_box *box, const uint8_t *bytes, size_t size)
{
    box_wires *wires = (box_wires *)user;
    DEMAND(box->columns > 0 && box->first_column + box->columns <= WIDTH && box->rows > 0 &&
           box->first_row + box->rows <= HEIGHT && bytes != NULL && size > 0);
    return wires->calls++ != wires->fails_at;
}

static bool start_rows(void *user, uint16_t first_row, uint16_t rows, const uint8_t *bytes,
                       size_t size)
{
    const fxl_screen_box box = {0, WIDTH, first_row, rows};
    return start_box(user, &box, bytes, size);
}

static bool wait_box(void *user)
{
    return user != NULL;
}

/* Boxes that are sent, or refused. */
static void demand_box(fxl_pump *pump, fxl_renderer *renderer, fuzz_input *in)
{
    const fxl_screen_box box = {(uint16_t)fuzz_below(in, WIDTH + 1), (uint16_t)fuzz_below(in, 26),
                                (uint16_t)fuzz_below(in, HEIGHT + 1),
                                (uint16_t)fuzz_below(in, HEIGHT + 2)};
    const fxl_screen_box eight = {8, 8, 8, (uint16_t)(1 + fuzz_below(in, 8))};
    const fxl_screen_box *const boxes[] = {&box, &eight};
    for (uint32_t i = 0; i < 2; i++) {
        const fxl_status status = fxl_pump_begin_box(pump, boxes[i]);
        DEMAND(status == FXL_OK || status == FXL_E_RANGE);
        while (status == FXL_OK && fxl_pump_band(pump) != NULL) {
            fxl_frame_fill(renderer, fxl_pump_band(pump), 0);
            DEMAND(fxl_frame_draw(renderer, fxl_pump_band(pump)) == FXL_OK);
            if (fxl_pump_send(pump) != FXL_OK) {
                break;
            }
        }
    }
}

/* A pump that sends what changed, by boxes or by whole rows. */
static void demand_boxes(fuzz_input in, fxl_renderer *renderer, const fxl_pose *eye)
{
    static uint64_t memory[FXL_PUMP_MEMORY(WIDTH, HEIGHT, 24)], kept[1024];
    static fxl_pixels pixels;
    static fxl_pump pump, none;
    fxl_changed changed;
    DEMAND(fxl_changed_init(&changed, kept, sizeof kept) == FXL_OK);
    for (uint32_t i = 0; i < 5 * (FORMATS + 1); i++) {
        const uint32_t format = i / 5, columns = i % 5;
        box_wires wires = {0, fuzz_below(&in, 4) ? UINT32_MAX : fuzz_below(&in, 8)};
        const fxl_pump_sink sink = {&wires, start_rows, wait_box, columns < 4 ? start_box : NULL,
                                    (uint8_t)((1u << columns % 4) - 1u)};
        const fxl_pump_config config = {format < FORMATS ? &pixels : NULL, WIDTH, HEIGHT, 8, NULL};
        DEMAND(format == FORMATS || fxl_pixels_init(&pixels, formats[format], palette) == FXL_OK);
        DEMAND(fxl_pump_init(&pump, &config, &sink, memory, sizeof memory) == FXL_OK);
        for (uint32_t k = 0; k < 4; k++) {
            fxl_pose pose = *eye;
            pose.yaw = k > 1 ? 0 : pose.yaw;
            const fxl_status status = fxl_pump_changed(&pump, renderer, &pose, &changed);
            if (status == FXL_OK) {
                demand_box(&pump, renderer, &in);
            }
            DEMAND(status != FXL_E_DISPLAY || changed.renderer == NULL);
            (void)fxl_frame_end(renderer);
        }
    }
    const fxl_screen_box box = {0, 8, 0, 8};
    memset(&none, 0, sizeof none);
    DEMAND(fxl_pump_changed(NULL, renderer, eye, &changed) == FXL_E_ARGUMENT);
    DEMAND(fxl_pump_changed(&pump, NULL, eye, &changed) == FXL_E_ARGUMENT);
    DEMAND(fxl_pump_changed(&pump, renderer, eye, NULL) == FXL_E_ARGUMENT);
    DEMAND(fxl_pump_widen(NULL, &changed) == FXL_E_ARGUMENT);
    DEMAND(fxl_pump_widen(&pump, NULL) == FXL_E_ARGUMENT);
    DEMAND(fxl_pump_widen(&none, &changed) == FXL_E_ORDER);
    DEMAND(fxl_pump_begin(&none) == FXL_E_ORDER && fxl_pump_wait(&none) == FXL_E_ORDER);
    DEMAND(fxl_pump_begin_box(&none, &box) == FXL_E_ORDER);
    DEMAND(fxl_pump_begin_box(NULL, &box) == FXL_E_ARGUMENT);
    DEMAND(fxl_pump_begin_box(&pump, NULL) == FXL_E_ARGUMENT);
    pump.config.height -= 1;
    DEMAND(fxl_pump_changed(&pump, renderer, eye, &changed) == FXL_E_RANGE);
}

/* A display with a glass of any size, on wires that fail sooner or later. */
static void fuzz_driver(fuzz_input *in, fxl_renderer *renderer, const fxl_pose *eye)
{
    static uint64_t memory[FXL_PUMP_MEMORY(WIDTH, HEIGHT, 24)];
    static fxl_display display;
    static fxl_pump pump;
    fuzz_wires wires = {0, fuzz_below(in, 2) ? UINT32_MAX - 1u : fuzz_below(in, 100), NULL, 0};
    fxl_display_port port = {&wires, send, begin, wait, pause};
    const uint32_t which = fuzz_below(in, DRIVERS), turns = fuzz_below(in, 5);
    fxl_display_config config = fxl_display_config_default(drivers[which], turns);
    const fxl_display_family *family = drivers[which]->family;
    const bool turns_quarters = family->exchanges != 0, turns_halves = family->mirrors_rows != 0;
    DEMAND((config.driver == NULL) ==
           (turns > 3 || (!turns_quarters && turns % 2 == 1) || (!turns_halves && turns == 2)));
    if (fuzz_below(in, 2)) {
        port.start = NULL;
        port.wait = NULL;
    }
    config.width = (uint16_t)fuzz_below(in, 150);
    config.height = (uint16_t)(8u * fuzz_below(in, 6));
    config.height = (uint16_t)(config.height + (fuzz_below(in, 8) == 1));
    config.left = (uint16_t)(fuzz_below(in, 16) == 1 ? 2000 : fuzz_below(in, 4));
    config.top = (uint16_t)(8u * fuzz_below(in, 3));
    config.top = (uint16_t)(config.top + (fuzz_below(in, 8) == 1));
    config.is_inverted = fuzz_below(in, 2) != 0;
    if (config.is_inverted && family == &fxl_display_memory_lcd) {
        DEMAND(fxl_display_open(&display, &config, &port, palette) != FXL_OK && wires.calls == 0);
        config.is_inverted = false; /* it has no command for that */
    }
    fxl_status status = fxl_display_open(&display, &config, &port, palette);
    DEMAND(status == FXL_OK || status == FXL_E_RANGE || status == FXL_E_DISPLAY);
    DEMAND((status == FXL_E_DISPLAY) == (wires.calls > wires.fails_at));
    if (status != FXL_OK) {
        return;
    }
    if (fxl_display_place(&display, WIDTH, HEIGHT) != FXL_OK) {
        DEMAND(config.width < WIDTH || config.height < HEIGHT);
        return;
    }
    const fxl_pump_config pumped = {&display.pixels, WIDTH, HEIGHT, 8, NULL};
    DEMAND(fxl_pump_init(&pump, &pumped, &display.sink, memory, sizeof memory) == FXL_OK);
    status = fxl_pump_frame(&pump, renderer, eye);
    DEMAND((status == FXL_OK) == (wires.calls <= wires.fails_at));
    DEMAND(fxl_pump_wait(&pump) == FXL_OK);
    port.pause = NULL;
    DEMAND(fxl_display_open(&display, &config, &port, palette) == FXL_E_ARGUMENT);
}

/* A module of each driver in each turn: a configuration, unless the controller can't turn so or the
 * glass lies beyond the memory. */
static void demand_modules(void)
{
    for (uint32_t which = 0; which < DRIVERS; which++) {
        const fxl_display_driver *driver = drivers[which];
        const fxl_display_module sound = {.driver = driver, .width = driver->memory_columns,
                                          .height = driver->memory_rows,
                                          .columns = driver->memory_columns,
                                          .rows = driver->memory_rows, .display_offset = 8};
        fxl_display_module unsound[] = {sound, sound, sound, sound, sound, sound};
        unsound[0].width = 0;
        unsound[1].height = 0;
        unsound[2].left = 1;
        unsound[3].top = 1;
        unsound[4].columns++;
        unsound[5].rows++;
        for (uint32_t turns = 0; turns < 5; turns++) {
            const fxl_display_config config = fxl_display_config_turned(&sound, turns);
            const fxl_display_config by_default = fxl_display_config_default(driver, turns);
            DEMAND((config.driver == NULL) == (by_default.driver == NULL));
            DEMAND(config.driver == NULL || (config.left == 0 && config.top == 0));
            for (uint32_t i = 0; i < sizeof unsound / sizeof unsound[0]; i++) {
                DEMAND(fxl_display_config_turned(&unsound[i], turns).driver == NULL);
            }
        }
    }
}

/* Null pointers, and configurations out of range. */
static void demand_refusals(fuzz_input *in)
{
    static uint64_t memory[4];
    static fxl_display display;
    static fxl_pixels pixels;
    static fxl_pump pump;
    fuzz_wires wires = {0, 0, NULL, 0};
    const fxl_display_port port = {&wires, send, NULL, NULL, pause};
    const fxl_pump_sink sink = {.user = &wires, .start = start, .wait = wait},
                        no_wait = {.user = &wires, .start = start};
    const fxl_display_config config = fxl_display_config_default(&fxl_ssd1306, 0);
    fxl_pump_config shape = {NULL, 4, 4, 1, NULL};
    uint16_t *const sides[] = {&shape.width, &shape.height, &shape.rows};
    DEMAND(fxl_pixels_init(NULL, &fxl_pixels_rgb565, palette) == FXL_E_ARGUMENT);
    DEMAND(fxl_pixels_init(&pixels, &fxl_pixels_rgb565, NULL) == FXL_E_ARGUMENT);
    DEMAND(fxl_pixels_convert(NULL, NULL, NULL, 0) == FXL_E_ARGUMENT);
    DEMAND(fxl_pixels_convert(&pixels, NULL, NULL, 0) == FXL_E_ARGUMENT);
    DEMAND(fxl_display_open(NULL, &config, &port, palette) == FXL_E_ARGUMENT);
    DEMAND(fxl_display_open(&display, NULL, &port, palette) == FXL_E_ARGUMENT);
    DEMAND(fxl_display_open(&display, &config, NULL, palette) == FXL_E_ARGUMENT);
    DEMAND(fxl_display_open(&display, &config, &port, NULL) == FXL_E_ARGUMENT);
    DEMAND(fxl_display_place(NULL, 1, 1) == FXL_E_ARGUMENT);
    DEMAND(fxl_display_config_default(NULL, 0).driver == NULL);
    DEMAND(fxl_display_config_turned(NULL, 0).driver == NULL);
    demand_modules();
    DEMAND(fxl_pump_init(NULL, &shape, &sink, memory, 32) == FXL_E_ARGUMENT);
    DEMAND(fxl_pump_init(&pump, NULL, &sink, memory, 32) == FXL_E_ARGUMENT);
    DEMAND(fxl_pump_init(&pump, &shape, NULL, memory, 32) == FXL_E_ARGUMENT);
    DEMAND(fxl_pump_init(&pump, &shape, &sink, NULL, 32) == FXL_E_ARGUMENT);
    DEMAND(fxl_pump_init(&pump, &shape, &no_wait, memory, 32) == FXL_E_ARGUMENT);
    DEMAND(fxl_pump_memory_size(NULL) == 0 && fxl_pump_memory_size(&shape) == 16);
    DEMAND(fxl_pump_begin(NULL) == FXL_E_ARGUMENT && fxl_pump_send(NULL) == FXL_E_ARGUMENT);
    DEMAND(fxl_pump_wait(NULL) == FXL_E_ARGUMENT && fxl_pump_band(NULL) == NULL);
    DEMAND(fxl_pump_send_rows(NULL, NULL) == FXL_E_ARGUMENT);
    uint16_t *const side = sides[fuzz_below(in, 3)];
    *side = (uint16_t)(fuzz_below(in, 2) ? 0 : FXL_SCREEN_MAX + 1);
    DEMAND(fxl_pump_memory_size(&shape) == 0);
}

void fuzz_show(fuzz_input *in, fxl_renderer *renderer, const fxl_pose *eye)
{
    for (uint32_t i = 0; i < sizeof palette; i++) {
        palette[i] = (uint8_t)(i * 37u);
    }
    fuzz_parts(*in);
    demand_boxes(*in, renderer, eye);
    demand_refusals(in);
    fuzz_formats(in);
    fuzz_pump(in, renderer, eye);
    fuzz_driver(in, renderer, eye);
}

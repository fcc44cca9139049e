/* SPDX-License-Identifier: MIT */
#include "pump_frame.h"

#include "../math/memory.h"

static size_t align(size_t size)
{
    return (size + 7u) & ~(size_t)7u;
}

/* Bytes of a band as it is drawn. */
static size_t drawn_size(const fxl_pump_config *config, uint32_t columns, uint32_t rows)
{
    return fxl_pixel_bytes(fxl_kind_of_palette(config->palette), (size_t)columns * rows);
}

/* Bytes of a band as they are sent. */
static size_t sent_size(const fxl_pump_config *config, uint32_t columns, uint16_t rows)
{
    return config->pixels != NULL ? fxl_pixels_size(config->pixels->format, (uint16_t)columns, rows)
                                  : drawn_size(config, columns, rows);
}

static bool is_in_range(const fxl_pump_config *config)
{
    return config->width >= 1 && config->width <= FXL_SCREEN_MAX && config->height >= 1 &&
           config->height <= FXL_SCREEN_MAX && config->rows >= 1 &&
           config->rows <= config->height &&
           (config->pixels == NULL ||
            (config->pixels->format != NULL && config->rows % config->pixels->format->rows == 0));
}

/* Bytes of memory for a band apart from those that are sent. */
static size_t band_size(const fxl_pump_config *config)
{
    return config->pixels != NULL ? align(drawn_size(config, config->width, config->rows)) : 0;
}

/* pixels 2.2 */
FXL_COLD size_t fxl_pump_memory_size(const fxl_pump_config *config)
{
    if (config == NULL || !is_in_range(config)) {
        return 0;
    }
    /* < 2^21 + 2 * 2^21 */
    return band_size(config) + 2u * align(sent_size(config, config->width, config->rows));
}

FXL_COLD fxl_status fxl_pump_init(fxl_pump *pump, const fxl_pump_config *config,
                                  const fxl_pump_sink *sink, void *memory, size_t memory_size)
{
    if (pump == NULL || config == NULL || sink == NULL || memory == NULL || sink->start == NULL ||
        sink->wait == NULL) {
        return FXL_E_ARGUMENT;
    }
    if (((uintptr_t)memory & 7u) != 0 || ((uintptr_t)config->palette & 1u) != 0) {
        return FXL_E_ALIGNMENT;
    }
    const size_t needed = fxl_pump_memory_size(config);
    if (needed == 0) {
        return FXL_E_RANGE;
    }
    if (memory_size < needed) {
        return FXL_E_CAPACITY;
    }
    const size_t size = (needed - band_size(config)) / 2u;
    uint8_t *block = (uint8_t *)memory;
    pump->config = *config;
    pump->sink = *sink;
    pump->buffer_size = size;
    pump->buffers[0] = block;
    pump->buffers[1] = block + size;
    pump->free_buffer = 0;
    pump->is_begun = false;
    pump->band.pixels = config->pixels != NULL ? block + 2u * size : block;
    pump->band.width = config->width;
    pump->band.first_row = 0;
    pump->band.rows = 0;
    pump->band.palette = config->palette;
    return FXL_OK;
}

static bool is_set_up(const fxl_pump *pump)
{
    return pump->sink.wait != NULL;
}

/* Sets the band that begins with a row. */
/* pixels 2.2 */
static void set_band(fxl_pump *pump, uint32_t first_row)
{
    const uint32_t left = pump->end_row - first_row;
    pump->band.first_row = (uint16_t)first_row;
    pump->band.rows = (uint16_t)(left < pump->config.rows ? left : pump->config.rows);
    if (pump->config.pixels == NULL) {
        pump->band.pixels = pump->buffers[pump->free_buffer];
    }
}

/* Begins the bands of a box. One with all columns has whole rows. */
/* changed 4.2 */
static void begin(fxl_pump *pump, const fxl_screen_box *box)
{
    const bool is_part = box->columns < pump->config.width;
    pump->band.first_column = box->first_column;
    pump->band.columns = is_part ? box->columns : 0;
    pump->band.stride = box->columns;
    pump->end_row = (uint16_t)(box->first_row + box->rows);
    pump->is_begun = true;
    set_band(pump, box->first_row);
}

fxl_status fxl_pump_begin(fxl_pump *pump)
{
    if (pump == NULL) {
        return FXL_E_ARGUMENT;
    }
    if (!is_set_up(pump)) {
        return FXL_E_ORDER;
    }
    const fxl_screen_box all = {0, pump->config.width, 0, pump->config.height};
    begin(pump, &all);
    return FXL_OK;
}

/* changed 3.2 */
void fxl_pump_steps(const fxl_pump *pump, uint32_t *columns, uint32_t *rows)
{
    *columns = pump->sink.start_box != NULL ? pump->sink.columns_less_1 + 1u : 0;
    *rows = pump->config.pixels != NULL ? pump->config.pixels->format->rows : 1u;
}

/* Whether a pump sends columns from one to another. */
/* changed 3.2 */
static bool takes_columns(const fxl_pump *pump, uint32_t first, uint32_t columns)
{
    const uint32_t width = pump->config.width, end = first + columns;
    return columns == width ||
           (pump->sink.start_box != NULL &&
            ((first | (end != width ? end : 0)) & pump->sink.columns_less_1) == 0);
}

/* changed 4.2 */
fxl_status fxl_pump_begin_box(fxl_pump *pump, const fxl_screen_box *box)
{
    if (pump == NULL || box == NULL) {
        return FXL_E_ARGUMENT;
    }
    if (!is_set_up(pump)) {
        return FXL_E_ORDER;
    }
    const uint32_t end_row = (uint32_t)box->first_row + box->rows;
    uint32_t columns, rows;
    fxl_pump_steps(pump, &columns, &rows);
    if (box->columns == 0 || box->rows == 0 ||
        (uint32_t)box->first_column + box->columns > pump->config.width ||
        end_row > pump->config.height || box->first_row % rows != 0 ||
        (end_row % rows != 0 && end_row != pump->config.height) ||
        !takes_columns(pump, box->first_column, box->columns)) {
        return FXL_E_RANGE;
    }
    begin(pump, box);
    return FXL_OK;
}

const fxl_band *fxl_pump_band(const fxl_pump *pump)
{
    return pump != NULL && pump->is_begun && pump->band.rows > 0 ? &pump->band : NULL;
}

/* pixels 2.3 */
static fxl_status fail(fxl_pump *pump)
{
    pump->is_begun = false;
    return FXL_E_DISPLAY;
}

/* Starts to send the free buffer, and frees the other one. */
/* pixels 2.1 */
static fxl_status start(fxl_pump *pump, const fxl_band *band)
{
    const fxl_pump_sink *sink = &pump->sink;
    const fxl_screen_box box = {band->first_column, (uint16_t)fxl_band_columns(band),
                                band->first_row, band->rows};
    const uint8_t *bytes = pump->buffers[pump->free_buffer];
    const size_t size = sent_size(&pump->config, box.columns, box.rows);
    if (!sink->wait(sink->user) ||
        !(box.columns < pump->config.width
              ? sink->start_box(sink->user, &box, bytes, size)
              : sink->start(sink->user, band->first_row, band->rows, bytes, size))) {
        return fail(pump);
    }
    pump->free_buffer ^= 1u;
    return FXL_OK;
}

fxl_status fxl_pump_send(fxl_pump *pump)
{
    if (pump == NULL) {
        return FXL_E_ARGUMENT;
    }
    const fxl_band *band = fxl_pump_band(pump);
    if (band == NULL) {
        return FXL_E_ORDER;
    }
    if (pump->config.pixels != NULL) {
        const fxl_status status = fxl_pixels_convert(
            pump->config.pixels, band, pump->buffers[pump->free_buffer], pump->buffer_size);
        if (status != FXL_OK) {
            return status;
        }
    }
    const fxl_status status = start(pump, band);
    if (status == FXL_OK) {
        set_band(pump, (uint32_t)band->first_row + band->rows);
    }
    return status;
}

/* pixels 2.4 */
static void copy_rows(uint8_t *to, const fxl_band *from)
{
    const fxl_pixel_kind kind = fxl_kind_of_band(from);
    const size_t bytes = fxl_pixel_bytes(kind, fxl_band_columns(from));
    for (uint32_t row = 0; row < from->rows; row++) {
        memcpy(to + row * bytes, from->pixels + row * fxl_pixel_bytes(kind, from->stride), bytes);
    }
}

/* pixels 2.4 */
fxl_status fxl_pump_send_rows(fxl_pump *pump, const fxl_band *rows)
{
    if (pump == NULL || rows == NULL || rows->pixels == NULL || rows->rows == 0) {
        return FXL_E_ARGUMENT;
    }
    if (rows->width != pump->config.width || rows->rows > pump->config.rows ||
        !fxl_band_is_within(rows, pump->config.width, pump->config.height) ||
        !takes_columns(pump, rows->first_column, fxl_band_columns(rows))) {
        return FXL_E_RANGE;
    }
    if (pump->config.pixels == NULL &&
        fxl_kind_of_band(rows).shift != fxl_kind_of_palette(pump->config.palette).shift) {
        return FXL_E_COMBINATION;
    }
    uint8_t *bytes = pump->buffers[pump->free_buffer];
    fxl_status status = FXL_OK;
    if (pump->config.pixels == NULL) {
        copy_rows(bytes, rows);
    } else {
        status = fxl_pixels_convert(pump->config.pixels, rows, bytes, pump->buffer_size);
    }
    if (status == FXL_OK) {
        status = start(pump, rows);
    }
    if (status == FXL_OK && pump->is_begun) {
        set_band(pump, pump->band.first_row); /* in the buffer that is free now */
    }
    return status;
}

/* pixels 2.3 */
fxl_status fxl_pump_wait(fxl_pump *pump)
{
    if (pump == NULL) {
        return FXL_E_ARGUMENT;
    }
    if (!is_set_up(pump)) {
        return FXL_E_ORDER;
    }
    return pump->sink.wait(pump->sink.user) ? FXL_OK : fail(pump);
}

fxl_status fxl_pump_frame(fxl_pump *pump, fxl_renderer *renderer, const fxl_pose *eye)
{
    if (pump == NULL || renderer == NULL) {
        return FXL_E_ARGUMENT;
    }
    fxl_status status = fxl_pump_check_renderer(pump, renderer);
    if (status == FXL_OK) {
        status = fxl_frame_begin(renderer, eye);
    }
    if (status == FXL_OK) {
        (void)fxl_pump_begin(pump);
        status = fxl_pump_draw_bands(pump, renderer);
    }
    return status;
}

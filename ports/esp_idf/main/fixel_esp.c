/* SPDX-License-Identifier: MIT */
#include "fixel_esp.h"

static bool when_done(esp_lcd_panel_io_handle_t io, esp_lcd_panel_io_event_data_t *event, void *user)
{
    fixel_esp *esp = user;
    BaseType_t is_woken = pdFALSE;

    (void)io;
    (void)event;
    (void)xSemaphoreGiveFromISR(esp->is_done, &is_woken);
    return is_woken == pdTRUE;
}

/* False after twice the time that the bytes take: then they may still be read. */
static bool wait(void *user)
{
    fixel_esp *esp = user;

    if (esp->is_sending) {
        esp->is_sending = xSemaphoreTake(esp->is_done, esp->patience) != pdTRUE;
    }
    return !esp->is_sending;
}

/* draw_bitmap returns before the bytes are sent. It waits for those before them without an end, so none may be on their way. */
static bool start_box(void *user, const fxl_screen_box *box, const uint8_t *bytes, size_t size)
{
    fixel_esp *esp = user;
    const int right = box->first_column + box->columns, bottom = box->first_row + box->rows;

    if (!wait(user)) {
        return false;
    }
    /* Milliseconds of 2 x 8 bits a byte, rounded up; a tick more for the rounding, and one for the tick that has begun. */
    esp->patience = (TickType_t)pdMS_TO_TICKS((16000ull * size + esp->hz - 1u) / esp->hz) + 2u;
    esp->is_sending = esp_lcd_panel_draw_bitmap(esp->panel, box->first_column, box->first_row, right, bottom, bytes) == ESP_OK;
    return esp->is_sending;
}

static bool start(void *user, uint16_t first_row, uint16_t rows, const uint8_t *bytes, size_t size)
{
    const fxl_screen_box box = {0, ((const fixel_esp *)user)->width, first_row, rows};

    return start_box(user, &box, bytes, size);
}

bool fixel_esp_open(fixel_esp *esp, esp_lcd_panel_handle_t panel, esp_lcd_panel_io_handle_t io, uint16_t width, uint32_t hz)
{
    const esp_lcd_panel_io_callbacks_t callbacks = {.on_color_trans_done = when_done};

    esp->sink = (fxl_pump_sink){.user = esp, .start = start, .wait = wait, .start_box = start_box};
    esp->panel = panel;
    esp->width = width;
    esp->hz = hz;
    esp->is_sending = false;
    esp->is_done = xSemaphoreCreateBinary();
    return hz > 0 && esp->is_done != NULL && esp_lcd_panel_io_register_event_callbacks(io, &callbacks, esp) == ESP_OK;
}

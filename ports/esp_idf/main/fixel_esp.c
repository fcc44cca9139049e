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
static bool start(void *user, uint16_t first_row, uint16_t rows, const uint8_t *bytes, size_t size)
{
    fixel_esp *esp = user;

    if (!wait(user)) {
        return false;
    }
    /* Milliseconds of 2 x 8 bits a byte, rounded up; a tick more for the rounding, and one for the tick that has begun. */
    esp->patience = (TickType_t)pdMS_TO_TICKS((16000ull * size + esp->hz - 1u) / esp->hz) + 2u;
    esp->is_sending = esp_lcd_panel_draw_bitmap(esp->panel, 0, first_row, esp->width, first_row + rows, bytes) == ESP_OK;
    return esp->is_sending;
}

bool fixel_esp_open(fixel_esp *esp, esp_lcd_panel_handle_t panel, esp_lcd_panel_io_handle_t io, uint16_t width, uint32_t hz)
{
    const esp_lcd_panel_io_callbacks_t callbacks = {.on_color_trans_done = when_done};

    esp->sink.user = esp;
    esp->sink.start = start;
    esp->sink.wait = wait;
    esp->panel = panel;
    esp->width = width;
    esp->hz = hz;
    esp->is_sending = false;
    esp->is_done = xSemaphoreCreateBinary();
    return hz > 0 && esp->is_done != NULL && esp_lcd_panel_io_register_event_callbacks(io, &callbacks, esp) == ESP_OK;
}

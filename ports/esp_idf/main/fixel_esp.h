/* SPDX-License-Identifier: MIT */
/* A panel of ESP-IDF's esp_lcd, of any controller that it has a driver for, as the sink of a pump. */
#ifndef FIXEL_ESP_H
#define FIXEL_ESP_H

#include <fixel/pump.h>

#include "esp_lcd_panel_io.h"
#include "esp_lcd_panel_ops.h"
#include "freertos/FreeRTOS.h"
#include "freertos/semphr.h"

/* Which the caller owns. Members are for reading only. */
typedef struct {
    fxl_pump_sink sink;
    esp_lcd_panel_handle_t panel;
    uint16_t width;
    uint32_t hz;
    TickType_t patience; /* how long the bytes on their way may take */
    SemaphoreHandle_t is_done; /* given when the DMA has sent a band */
    bool is_sending;
} fixel_esp;

/* Sets a sink up for frames that are width pixels wide. io: of the panel; its on_color_trans_done becomes ours. hz: its clock, as
 * pclk_hz has it. The sink waits for twice the time that a band's bytes take by that clock, then its pump answers FXL_E_DISPLAY.
 * Returns false if ESP-IDF refused something, or hz is 0. */
bool fixel_esp_open(fixel_esp *esp, esp_lcd_panel_handle_t panel, esp_lcd_panel_io_handle_t io, uint16_t width, uint32_t hz);

#endif

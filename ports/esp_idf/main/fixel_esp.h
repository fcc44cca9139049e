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
    SemaphoreHandle_t is_done; /* given when the DMA has sent a band */
    bool is_sending;
} fixel_esp;

/* Sets a sink up for frames that are width pixels wide. io: of the panel; its on_color_trans_done becomes ours. Returns false
 * if ESP-IDF refused something. */
bool fixel_esp_open(fixel_esp *esp, esp_lcd_panel_handle_t panel, esp_lcd_panel_io_handle_t io, uint16_t width);

#endif

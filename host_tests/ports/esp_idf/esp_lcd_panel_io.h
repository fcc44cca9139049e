/* SPDX-License-Identifier: MIT */
/* Declarations of what ports/esp_idf calls, after the programming guide of ESP-IDF 5. */
#ifndef PORTS_ESP_LCD_PANEL_IO_H
#define PORTS_ESP_LCD_PANEL_IO_H
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
typedef int esp_err_t;
#define ESP_OK 0
typedef struct esp_lcd_panel_io_t *esp_lcd_panel_io_handle_t;
typedef struct esp_lcd_panel_t *esp_lcd_panel_handle_t;
typedef void *esp_lcd_spi_bus_handle_t;
typedef struct {
    int reserved;
} esp_lcd_panel_io_event_data_t;
typedef bool (*esp_lcd_panel_io_color_trans_done_cb_t)(esp_lcd_panel_io_handle_t io,
                                                       esp_lcd_panel_io_event_data_t *event,
                                                       void *user);
typedef struct {
    esp_lcd_panel_io_color_trans_done_cb_t on_color_trans_done;
} esp_lcd_panel_io_callbacks_t;
typedef struct {
    int cs_gpio_num, dc_gpio_num, spi_mode;
    unsigned int pclk_hz;
    size_t trans_queue_depth;
    int lcd_cmd_bits, lcd_param_bits;
} esp_lcd_panel_io_spi_config_t;
esp_err_t esp_lcd_new_panel_io_spi(esp_lcd_spi_bus_handle_t bus,
                                   const esp_lcd_panel_io_spi_config_t *config,
                                   esp_lcd_panel_io_handle_t *io);
esp_err_t esp_lcd_panel_io_register_event_callbacks(esp_lcd_panel_io_handle_t io,
                                                    const esp_lcd_panel_io_callbacks_t *callbacks,
                                                    void *user);
#endif

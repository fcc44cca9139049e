/* SPDX-License-Identifier: MIT */
/* A camera circles a cube, on an ST7789 of 320 x 240. A model of your own: its name instead of cube. */
#include <fixel.h>

#include "cube_scene.h" /* tools/scene.py export --c --frames 96 examples/cube/cube.obj -o cube_scene.h */
#include "driver/spi_master.h"
#include "esp_lcd_panel_vendor.h"
#include "fixel_esp.h"

#define WIDTH  320
#define HEIGHT 240
#define ROWS   20 /* of a band; two of them are sent in turn */
#define HOST   SPI2_HOST
#define HZ     40000000u

enum { CLOCK = 12, DATA_OUT = 11, SELECT = 10, DATA_COMMAND = 9, RESET = 8 };

static fxl_setup it;
static uint64_t memory[CUBE_SETUP_MEMORY(ROWS)];
static fxl_pixels colours;
static fixel_esp esp;
static fxl_pump pump;
static uint64_t pump_memory[FXL_PUMP_MEMORY_RGB565(WIDTH, ROWS, 16)]; /* internal RAM, which the DMA reaches */

/* The panel as ESP-IDF drives it. */
static bool open_panel(esp_lcd_panel_handle_t *panel, esp_lcd_panel_io_handle_t *io)
{
    const spi_bus_config_t bus = {.sclk_io_num = CLOCK, .mosi_io_num = DATA_OUT, .miso_io_num = -1, .quadwp_io_num = -1,
                                  .quadhd_io_num = -1, .max_transfer_sz = WIDTH * ROWS * 2};
    const esp_lcd_panel_io_spi_config_t wires = {.cs_gpio_num = SELECT, .dc_gpio_num = DATA_COMMAND, .spi_mode = 0,
                                                 .pclk_hz = HZ, .trans_queue_depth = 2, .lcd_cmd_bits = 8,
                                                 .lcd_param_bits = 8};
    const esp_lcd_panel_dev_config_t module = {.reset_gpio_num = RESET, .rgb_ele_order = LCD_RGB_ELEMENT_ORDER_RGB,
                                               .bits_per_pixel = 16};

    return spi_bus_initialize(HOST, &bus, SPI_DMA_CH_AUTO) == ESP_OK &&
           esp_lcd_new_panel_io_spi((esp_lcd_spi_bus_handle_t)HOST, &wires, io) == ESP_OK &&
           esp_lcd_new_panel_st7789(*io, &module, panel) == ESP_OK && esp_lcd_panel_reset(*panel) == ESP_OK &&
           esp_lcd_panel_init(*panel) == ESP_OK && esp_lcd_panel_invert_color(*panel, true) == ESP_OK &&
           esp_lcd_panel_swap_xy(*panel, true) == ESP_OK && esp_lcd_panel_mirror(*panel, true, false) == ESP_OK &&
           esp_lcd_panel_disp_on_off(*panel, true) == ESP_OK;
}

void app_main(void)
{
    const fxl_pump_config bands = {&colours, WIDTH, HEIGHT, ROWS, cube_setup.config->palette};
    esp_lcd_panel_handle_t panel = NULL;
    esp_lcd_panel_io_handle_t io = NULL;
    uint32_t frame;

    /* fxl_setup_explain has a sentence for each refusal */
    if (!open_panel(&panel, &io) || !fixel_esp_open(&esp, panel, io, WIDTH, HZ) ||
        fxl_setup_init(&it, &cube_setup, ROWS, memory, sizeof memory) != FXL_OK ||
        fxl_pixels_init(&colours, &fxl_pixels_rgb565, cube_setup.palette) != FXL_OK ||
        fxl_pump_init(&pump, &bands, &esp.sink, pump_memory, sizeof pump_memory) != FXL_OK) {
        return;
    }
    for (frame = 0;; frame++) {
        if (fxl_pump_frame(&pump, &it.renderer, fxl_setup_frame(&it, frame)) != FXL_OK) {
            return;
        }
    }
}

/* SPDX-License-Identifier: MIT */
/* What ports/esp_idf calls, as a diary. A transfer ends while somebody waits for its semaphore. */
#include <stdio.h>
#include <stdlib.h>

#include "diary.h"
#include "driver/spi_master.h"
#include "esp_lcd_panel_ops.h"
#include "esp_lcd_panel_vendor.h"
#include "freertos/semphr.h"

struct esp_lcd_panel_io_t {
    esp_lcd_panel_io_callbacks_t callbacks;
    void *user;
};
struct esp_lcd_panel_t {
    bool is_reset, is_initialised, is_on;
};
struct ports_semaphore {
    bool is_given;
};

void app_main(void);

static struct esp_lcd_panel_io_t the_io;
static struct esp_lcd_panel_t the_panel;
static struct ports_semaphore the_semaphore;
static bool has_bus;

static void require(bool holds, const char *sentence)
{
    if (!holds) {
        printf("fault %s\n", sentence);
        exit(1);
    }
}

esp_err_t spi_bus_initialize(spi_host_device_t host, const spi_bus_config_t *config,
                             spi_dma_chan_t channel)
{
    require(host == SPI2_HOST && channel == SPI_DMA_CH_AUTO &&
                config->max_transfer_sz >= 320 * 20 * 2 && config->miso_io_num == -1,
            "the bus");
    has_bus = true;
    return ESP_OK;
}

esp_err_t esp_lcd_new_panel_io_spi(esp_lcd_spi_bus_handle_t bus,
                                   const esp_lcd_panel_io_spi_config_t *config,
                                   esp_lcd_panel_io_handle_t *io)
{
    require(has_bus && (uintptr_t)bus == SPI2_HOST && config->trans_queue_depth > 0 &&
                config->lcd_cmd_bits == 8 && config->lcd_param_bits == 8,
            "the wires");
    *io = &the_io;
    return ESP_OK;
}

esp_err_t esp_lcd_new_panel_st7789(esp_lcd_panel_io_handle_t io,
                                   const esp_lcd_panel_dev_config_t *config,
                                   esp_lcd_panel_handle_t *panel)
{
    require(io == &the_io && config->bits_per_pixel == 16, "the panel");
    *panel = &the_panel;
    return ESP_OK;
}

esp_err_t esp_lcd_panel_reset(esp_lcd_panel_handle_t panel)
{
    panel->is_reset = true;
    return ESP_OK;
}

esp_err_t esp_lcd_panel_init(esp_lcd_panel_handle_t panel)
{
    require(panel->is_reset, "a panel that was not reset");
    panel->is_initialised = true;
    return ESP_OK;
}

esp_err_t esp_lcd_panel_mirror(esp_lcd_panel_handle_t panel, bool mirror_x, bool mirror_y)
{
    require(panel->is_initialised && mirror_x && !mirror_y, "the turn");
    return ESP_OK;
}

esp_err_t esp_lcd_panel_swap_xy(esp_lcd_panel_handle_t panel, bool swap_axes)
{
    require(panel->is_initialised && swap_axes, "the turn");
    return ESP_OK;
}

esp_err_t esp_lcd_panel_invert_color(esp_lcd_panel_handle_t panel, bool is_inverted)
{
    require(panel->is_initialised && is_inverted, "the colours");
    return ESP_OK;
}

esp_err_t esp_lcd_panel_disp_on_off(esp_lcd_panel_handle_t panel, bool is_on)
{
    panel->is_on = is_on;
    return ESP_OK;
}

esp_err_t esp_lcd_panel_io_register_event_callbacks(esp_lcd_panel_io_handle_t io,
                                                    const esp_lcd_panel_io_callbacks_t *callbacks,
                                                    void *user)
{
    io->callbacks = *callbacks;
    io->user = user;
    return ESP_OK;
}

esp_err_t esp_lcd_panel_draw_bitmap(esp_lcd_panel_handle_t panel, int x_start, int y_start,
                                    int x_end, int y_end, const void *colours)
{
    require(panel->is_on && the_io.callbacks.on_color_trans_done != NULL, "a panel that is off");
    if (diary_fails()) {
        return -1; /* ESP_FAIL */
    }
    printf("window %d %d %d %d\n", x_start, y_start, x_end, y_end);
    diary_start(colours, 2u * (size_t)(x_end - x_start) * (size_t)(y_end - y_start));
    return ESP_OK;
}

SemaphoreHandle_t xSemaphoreCreateBinary(void)
{
    return &the_semaphore;
}

BaseType_t xSemaphoreTake(SemaphoreHandle_t semaphore, TickType_t ticks)
{
    /* 320 x 20 pixels take 2.56 ms at 40 MHz, so twice that is less than a tick of 10 ms. */
    require(ticks >= 1 && ticks <= 3 && (diary_is_sending() || semaphore->is_given),
            "a wait of another time than the bytes take");
    if (diary_hangs()) {
        return pdFALSE;
    }
    if (diary_is_sending()) {
        diary_finish();
        require(the_io.callbacks.on_color_trans_done(&the_io, NULL, the_io.user),
                "nobody was woken");
    }
    require(semaphore->is_given, "the semaphore was not given");
    semaphore->is_given = false;
    return pdTRUE;
}

BaseType_t xSemaphoreGiveFromISR(SemaphoreHandle_t semaphore, BaseType_t *is_woken)
{
    semaphore->is_given = true;
    *is_woken = pdTRUE;
    return pdTRUE;
}

int main(void)
{
    app_main();
    return 1;
}

/* SPDX-License-Identifier: MIT */
#include "fixel_pico.h"

#include "hardware/dma.h"
#include "hardware/gpio.h"
#include "hardware/spi.h"
#include "pico/stdlib.h"

static uint channel; /* of the DMA */
static bool is_sending;
static uint32_t begun, patience; /* microseconds: when the transfer began; how long it may take */

static void select_for(bool is_data)
{
    gpio_put(FIXEL_PICO_DC, is_data);
    gpio_put(FIXEL_PICO_SELECT, false);
}

/* False after twice the time that the bytes take: then they may still be read. The time is read first, so an interrupt behind it
 * makes no transfer late that has ended. */
static bool wait(void *user)
{
    (void)user;
    if (is_sending) {
        uint32_t now = time_us_32();

        while (dma_channel_is_busy(channel) || spi_is_busy(spi0)) { /* the last bytes leave the queue */
            if (now - begun > patience) {
                return false;
            }
            now = time_us_32();
        }
        gpio_put(FIXEL_PICO_SELECT, true);
        is_sending = false;
    }
    return true;
}

static bool send(void *user, bool is_data, const uint8_t *bytes, size_t size)
{
    int sent;

    if (!wait(user)) {
        return false;
    }
    select_for(is_data);
    sent = spi_write_blocking(spi0, bytes, size);
    gpio_put(FIXEL_PICO_SELECT, true);
    return sent == (int)size;
}

static bool start(void *user, const uint8_t *bytes, size_t size)
{
    dma_channel_config config = dma_channel_get_default_config(channel);

    if (!wait(user)) {
        return false;
    }
    channel_config_set_transfer_data_size(&config, DMA_SIZE_8);
    channel_config_set_dreq(&config, spi_get_dreq(spi0, true));
    select_for(true);
    is_sending = true;
    patience = (uint32_t)(16000000ull * size / spi_get_baudrate(spi0)) + 2u; /* 2 x 8 bits a byte */
    begun = time_us_32();
    dma_channel_configure(channel, &config, &spi_get_hw(spi0)->dr, bytes, (uint)size, true);
    return true;
}

static void pause(void *user, uint32_t milliseconds)
{
    (void)user;
    sleep_ms(milliseconds);
}

const fxl_display_port fixel_pico_port = {NULL, send, start, wait, pause};

static void make_output(uint pin)
{
    gpio_init(pin);
    gpio_put(pin, true);
    gpio_set_dir(pin, GPIO_OUT);
}

void fixel_pico_open(void)
{
    make_output(FIXEL_PICO_SELECT);
    make_output(FIXEL_PICO_DC);
    make_output(FIXEL_PICO_RESET);
    (void)spi_init(spi0, FIXEL_PICO_BAUD);
    spi_set_format(spi0, 8, SPI_CPOL_0, SPI_CPHA_0, SPI_MSB_FIRST);
    gpio_set_function(FIXEL_PICO_CLOCK, GPIO_FUNC_SPI);
    gpio_set_function(FIXEL_PICO_DATA, GPIO_FUNC_SPI);
    channel = (uint)dma_claim_unused_channel(true);
    gpio_put(FIXEL_PICO_RESET, false);
    sleep_ms(1);
    gpio_put(FIXEL_PICO_RESET, true);
    sleep_ms(120);
}

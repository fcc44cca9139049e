/* SPDX-License-Identifier: MIT */
/* What ports/pico_sdk calls, as a diary. */
#include <stdio.h>

#include "diary.h"
#include "hardware/dma.h"
#include "hardware/gpio.h"
#include "hardware/spi.h"

#define CHANNEL 5
#define POLLS   4 /* how often a transfer says that it is busy, and one more */
#define DREQ    16u /* of SPI0, sending */

struct spi_inst {
    spi_hw_t hw;
    int busy; /* how often it still says so */
};
static struct spi_inst only;
static uint32_t now;
static int polls;
spi_inst_t *const ports_spi0 = &only;

static void require(bool holds, const char *sentence)
{
    if (!holds) {
        printf("fault %s\n", sentence);
    }
}

void sleep_ms(uint32_t milliseconds)
{
    diary_sleep(milliseconds);
}

void gpio_init(uint pin)
{
    (void)pin;
}

void gpio_set_dir(uint pin, bool is_output)
{
    (void)pin;
    require(is_output, "a pin is no output");
}

void gpio_put(uint pin, bool value)
{
    require(only.busy == 0, "a pin changes while bytes leave");
    diary_pin(pin, value);
}

void gpio_set_function(uint pin, gpio_function_t function)
{
    require((pin == 18 || pin == 19) && function == GPIO_FUNC_SPI, "a pin that SPI0 cannot have");
}

uint spi_init(spi_inst_t *spi, uint baudrate)
{
    require(spi == &only && baudrate == 62500000u, "the clock");
    diary_setup("spi");
    return baudrate;
}

void spi_set_format(spi_inst_t *spi, uint data_bits, spi_cpol_t cpol, spi_cpha_t cpha,
                    spi_order_t order)
{
    require(spi == &only && data_bits == 8 && cpol == SPI_CPOL_0 && cpha == SPI_CPHA_0 &&
                order == SPI_MSB_FIRST,
            "the format");
}

int spi_write_blocking(spi_inst_t *spi, const uint8_t *bytes, size_t size)
{
    require(spi == &only && !diary_is_sending(), "bytes are sent beside a transfer");
    diary_bytes(bytes, size);
    return (int)size;
}

bool spi_is_busy(const spi_inst_t *spi)
{
    require(spi == &only && !diary_is_sending(), "asked before the transfer's end");
    return only.busy > 0 && only.busy-- > 0;
}

uint spi_get_baudrate(const spi_inst_t *spi)
{
    require(spi == &only, "another SPI");
    return 62500000u;
}

uint spi_get_dreq(spi_inst_t *spi, bool is_tx)
{
    require(spi == &only && is_tx, "the wrong request");
    return DREQ;
}

spi_hw_t *spi_get_hw(spi_inst_t *spi)
{
    return &spi->hw;
}

int dma_claim_unused_channel(bool required)
{
    require(required, "no channel is no error");
    return CHANNEL;
}

dma_channel_config dma_channel_get_default_config(uint channel)
{
    const dma_channel_config config = {channel};

    return config;
}

void channel_config_set_transfer_data_size(dma_channel_config *config,
                                           enum dma_channel_transfer_size size)
{
    require(size == DMA_SIZE_8, "no bytes");
    config->ctrl |= 1u << 8;
}

void channel_config_set_dreq(dma_channel_config *config, uint dreq)
{
    config->ctrl |= dreq << 16;
}

void dma_channel_configure(uint channel, const dma_channel_config *config,
                           volatile void *write_address, const volatile void *read_address,
                           uint count, bool trigger)
{
    require(channel == CHANNEL && config->ctrl == (DREQ << 16 | 1u << 8 | CHANNEL) &&
                write_address == &only.hw.dr && trigger,
            "the channel is set up in another way");
    diary_start((const uint8_t *)(uintptr_t)read_address, count);
}

bool dma_channel_is_busy(uint channel)
{
    require(channel == CHANNEL, "another channel");
    if (diary_is_sending() && (diary_hangs() || ++polls % POLLS != 0)) {
        return true;
    }
    if (diary_is_sending()) {
        diary_finish();
        only.busy = 3;
    }
    return false;
}

/* 64 bytes take 8 microseconds. */
uint32_t time_us_32(void)
{
    return now++;
}


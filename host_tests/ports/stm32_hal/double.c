/* SPDX-License-Identifier: MIT */
/* What ports/stm32_hal calls, as a diary; and a main as CubeMX generates it. */
#include <stdio.h>

#include "diary.h"
#include "main.h"

#define POLLS 3 /* how often the SPI says that it is busy */

void fixel_run(void);

SPI_HandleTypeDef hspi1;
GPIO_TypeDef ports_gpioa;
static int polls;
static uint32_t now;

static void require(bool holds, const char *sentence)
{
    if (!holds) {
        printf("fault %s\n", sentence);
    }
}

HAL_StatusTypeDef HAL_SPI_Transmit(SPI_HandleTypeDef *spi, uint8_t *bytes, uint16_t size,
                                   uint32_t timeout)
{
    require(spi == &hspi1 && timeout > 0 && !diary_is_sending(),
            "bytes are sent beside a transfer");
    diary_bytes(bytes, size);
    return HAL_OK;
}

HAL_StatusTypeDef HAL_SPI_Transmit_DMA(SPI_HandleTypeDef *spi, uint8_t *bytes, uint16_t size)
{
    require(spi == &hspi1, "another SPI");
    diary_start(bytes, size);
    polls = POLLS;
    return HAL_OK;
}

HAL_SPI_StateTypeDef HAL_SPI_GetState(SPI_HandleTypeDef *spi)
{
    require(spi == &hspi1, "another SPI");
    if (polls > 0 || diary_hangs()) {
        polls -= polls > 0;
        return HAL_SPI_STATE_BUSY_TX;
    }
    diary_finish();
    return HAL_SPI_STATE_READY;
}

/* Of the transfer that was begun last. */
uint32_t HAL_SPI_GetError(SPI_HandleTypeDef *spi)
{
    require(spi == &hspi1 && !diary_is_sending(), "asked before the transfer's end");
    return diary_fails() ? HAL_SPI_ERROR_DMA : HAL_SPI_ERROR_NONE;
}

void HAL_GPIO_WritePin(GPIO_TypeDef *port, uint16_t pin, GPIO_PinState state)
{
    unsigned number = 0;

    require(port == &ports_gpioa && !diary_is_sending(), "a pin changes while bytes leave");
    while ((pin >> number & 1) == 0) {
        number++;
    }
    diary_pin(number, state == GPIO_PIN_SET);
}

void HAL_Delay(uint32_t milliseconds)
{
    diary_sleep(milliseconds);
}

uint32_t HAL_GetTick(void)
{
    return now++;
}

int main(void)
{
    fixel_run();
    return 1;
}

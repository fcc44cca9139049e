/* SPDX-License-Identifier: MIT */
#include "fixel_stm32.h"

#define MOST       65535u /* bytes of a call */
#define TIMEOUT_MS 1000u

extern SPI_HandleTypeDef FIXEL_STM32_SPI;

static bool is_sending;

static void select_for(bool is_data)
{
    HAL_GPIO_WritePin(LCD_DC_GPIO_Port, LCD_DC_Pin, is_data ? GPIO_PIN_SET : GPIO_PIN_RESET);
    HAL_GPIO_WritePin(LCD_CS_GPIO_Port, LCD_CS_Pin, GPIO_PIN_RESET);
}

static void deselect(void)
{
    HAL_GPIO_WritePin(LCD_CS_GPIO_Port, LCD_CS_Pin, GPIO_PIN_SET);
}

/* The HAL's interrupt makes the state ready when the last bit has left, and also when the DMA failed. */
static bool wait(void *user)
{
    const uint32_t begun = HAL_GetTick();

    (void)user;
    if (!is_sending) {
        return true;
    }
    while (HAL_SPI_GetState(&FIXEL_STM32_SPI) != HAL_SPI_STATE_READY) {
        if (HAL_GetTick() - begun > TIMEOUT_MS) {
            return false; /* the bytes may still be read */
        }
    }
    deselect();
    is_sending = false;
    return HAL_SPI_GetError(&FIXEL_STM32_SPI) == HAL_SPI_ERROR_NONE;
}

/* Older HALs take bytes that are not const. They only read them. */
static bool send(void *user, bool is_data, const uint8_t *bytes, size_t size)
{
    HAL_StatusTypeDef status;

    if (size > MOST || !wait(user)) {
        return false;
    }
    select_for(is_data);
    status = HAL_SPI_Transmit(&FIXEL_STM32_SPI, (uint8_t *)(uintptr_t)bytes, (uint16_t)size, TIMEOUT_MS);
    deselect();
    return status == HAL_OK;
}

/* A core with a data cache (STM32F7, H7) must keep these bytes out of it, or clean the cache here. */
static bool start(void *user, const uint8_t *bytes, size_t size)
{
    if (size > MOST || !wait(user)) {
        return false;
    }
    select_for(true);
    is_sending = HAL_SPI_Transmit_DMA(&FIXEL_STM32_SPI, (uint8_t *)(uintptr_t)bytes, (uint16_t)size) == HAL_OK;
    if (!is_sending) {
        deselect();
    }
    return is_sending;
}

static void pause(void *user, uint32_t milliseconds)
{
    (void)user;
    HAL_Delay(milliseconds);
}

const fxl_display_port fixel_stm32_port = {NULL, send, start, wait, pause};

void fixel_stm32_open(void)
{
    deselect();
    HAL_GPIO_WritePin(LCD_RST_GPIO_Port, LCD_RST_Pin, GPIO_PIN_RESET);
    HAL_Delay(1);
    HAL_GPIO_WritePin(LCD_RST_GPIO_Port, LCD_RST_Pin, GPIO_PIN_SET);
    HAL_Delay(120);
}

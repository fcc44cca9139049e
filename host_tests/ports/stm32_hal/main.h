/* SPDX-License-Identifier: MIT */
/* Declarations of what ports/stm32_hal calls, after the user manual of the STM32F4 HAL (UM1725),
 * and of what CubeMX generates. */
#ifndef PORTS_STM32_MAIN_H
#define PORTS_STM32_MAIN_H
#include <stdint.h>
typedef enum {
    HAL_OK,
    HAL_ERROR,
    HAL_BUSY,
    HAL_TIMEOUT
} HAL_StatusTypeDef;
typedef enum {
    HAL_SPI_STATE_READY = 1,
    HAL_SPI_STATE_BUSY_TX = 3
} HAL_SPI_StateTypeDef;
typedef enum {
    GPIO_PIN_RESET,
    GPIO_PIN_SET
} GPIO_PinState;
typedef struct {
    unsigned number;
} GPIO_TypeDef;
typedef struct {
    int state;
} SPI_HandleTypeDef;
HAL_StatusTypeDef HAL_SPI_Transmit(SPI_HandleTypeDef *spi, uint8_t *bytes, uint16_t size,
                                   uint32_t timeout);
HAL_StatusTypeDef HAL_SPI_Transmit_DMA(SPI_HandleTypeDef *spi, uint8_t *bytes, uint16_t size);
#define HAL_SPI_ERROR_NONE 0x00000000u
#define HAL_SPI_ERROR_DMA  0x00000010u
uint32_t HAL_SPI_GetError(SPI_HandleTypeDef *spi);
HAL_SPI_StateTypeDef HAL_SPI_GetState(SPI_HandleTypeDef *spi);
void HAL_GPIO_WritePin(GPIO_TypeDef *port, uint16_t pin, GPIO_PinState state);
void HAL_Delay(uint32_t milliseconds);
uint32_t HAL_GetTick(void);
extern GPIO_TypeDef ports_gpioa;
#define LCD_CS_GPIO_Port  (&ports_gpioa)
#define LCD_CS_Pin        ((uint16_t)(1u << 4))
#define LCD_DC_GPIO_Port  (&ports_gpioa)
#define LCD_DC_Pin        ((uint16_t)(1u << 3))
#define LCD_RST_GPIO_Port (&ports_gpioa)
#define LCD_RST_Pin       ((uint16_t)(1u << 2))
#endif

/* SPDX-License-Identifier: MIT */
/* A display of fixel/display.h on the SPI of an STM32, by DMA, with the HAL that STM32CubeMX generates. */
#ifndef FIXEL_STM32_H
#define FIXEL_STM32_H

#include <fixel/display.h>

#include "main.h" /* CubeMX's: the HAL, and the pins by their user labels */

/* The SPI, as CubeMX sets it up: transmit only master, 8 bits, MSB first, CPOL low, CPHA first edge, software NSS, with a DMA
 * request for its transmission, of bytes, in normal mode, and its interrupts. */
#ifndef FIXEL_STM32_SPI
#define FIXEL_STM32_SPI hspi1
#endif

extern const fxl_display_port fixel_stm32_port;

/* Resets the display. Call it once, after CubeMX's own calls and before fxl_display_open. */
void fixel_stm32_open(void);

#endif

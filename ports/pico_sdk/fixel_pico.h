/* SPDX-License-Identifier: MIT */
/* A display of fixel/display.h on SPI0 of a Raspberry Pi Pico, by DMA, with the Pico SDK. */
#ifndef FIXEL_PICO_H
#define FIXEL_PICO_H

#include <fixel/display.h>

/* GPIO numbers. Clock and data must be pins that the chip can give to SPI0. */
#ifndef FIXEL_PICO_CLOCK
#define FIXEL_PICO_CLOCK  18
#define FIXEL_PICO_DATA   19
#define FIXEL_PICO_SELECT 17
#define FIXEL_PICO_DC     20 /* data/command */
#define FIXEL_PICO_RESET  21
#endif
#ifndef FIXEL_PICO_BAUD
#define FIXEL_PICO_BAUD 62500000 /* at most half of clk_peri; lower it for long wires */
#endif

extern const fxl_display_port fixel_pico_port;

/* Sets up pins, SPI0 and a DMA channel, and resets the display. Call it once, before fxl_display_open. */
void fixel_pico_open(void);

#endif

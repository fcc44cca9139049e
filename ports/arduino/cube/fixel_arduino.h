/* SPDX-License-Identifier: MIT */
/* A display of fixel/display.h by Arduino's SPI library, on any core that has one. It sends without DMA: Arduino has no
 * common call for that. */
#ifndef FIXEL_ARDUINO_H
#define FIXEL_ARDUINO_H

#include <fixel/display.h>

/* Arduino's numbers of the pins. Clock and data are those of the SPI library. */
#ifndef FIXEL_ARDUINO_SELECT
#define FIXEL_ARDUINO_SELECT 10
#define FIXEL_ARDUINO_DC     9 /* data/command */
#define FIXEL_ARDUINO_RESET  8
#endif
#ifndef FIXEL_ARDUINO_HZ
#define FIXEL_ARDUINO_HZ 40000000 /* a core takes the highest clock below it that it has */
#endif

extern const fxl_display_port fixel_arduino_port;

/* Sets up the pins and the SPI library, and resets the display. Call it in setup, before fxl_display_open. */
void fixel_arduino_open(void);

#endif

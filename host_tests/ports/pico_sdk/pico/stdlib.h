/* SPDX-License-Identifier: MIT */
/* Declarations of what ports/pico_sdk calls, after the documentation of the Pico SDK 2.x. */
#ifndef PORTS_PICO_STDLIB_H
#define PORTS_PICO_STDLIB_H
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
typedef unsigned int uint;
void sleep_ms(uint32_t milliseconds);
uint32_t time_us_32(void);
#endif

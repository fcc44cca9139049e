/* SPDX-License-Identifier: MIT */
/* The program's stack and the handlers', painted at start-up with one word, so
 * that how deep they went can be read off. */
#ifndef BOARD_STACK_H
#define BOARD_STACK_H

#include <stdbool.h>
#include <stdint.h>

#define STACK_PAINT 0x5AFEC0DE

/* How many bytes of the program's stack were ever written. What was set aside
 * below the deepest write without being written does not show. */
uint32_t stack_deepest(void);

/* Whether the program came within 32 bytes of its stack's end, the room that
 * an interrupt takes: where nothing guards the end, an overflow. */
bool stack_is_spent(void);

/* Prints "stack: N of M bytes" and how deep the handlers' stack went. */
void stack_print(void);

#endif

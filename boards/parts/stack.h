/* SPDX-License-Identifier: MIT */
/* The program's stack and the handlers' stack. Both are painted at start-up with one word, so
 * the depth that they reached can be measured. */
#ifndef BOARD_STACK_H
#define BOARD_STACK_H

#include <stdbool.h>
#include <stdint.h>

#define STACK_PAINT 0x5AFEC0DE

/* Returns how many bytes of the program's stack were ever written. Memory that was reserved
 * below the deepest write, and not written, does not count. */
uint32_t stack_deepest(void);

/* Tells whether the program came within 32 bytes of its stack's end, the space that an interrupt
 * needs. Where nothing guards the end, that is an overflow. */
bool stack_is_spent(void);

/* Prints "stack: N of M bytes" and the depth of the handlers' stack. */
void stack_print(void);

#endif

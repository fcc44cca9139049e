/* SPDX-License-Identifier: MIT */
/* What the parts of a RISC-V core of 32 bits in machine mode pass to each other, and to its board
 * (RISC-V Privileged Architecture). */
#ifndef BOARD_RISCV_H
#define BOARD_RISCV_H

#include <stdint.h>

/* Instructions executed since reset: minstret. */
uint64_t riscv_instructions(void);

/* Lets the machine timer interrupt. */
void riscv_enable_timer(void);

/* Entry of every trap. Prints what happened and ends the program with a code of system.h. */
void riscv_trap(void);

#endif

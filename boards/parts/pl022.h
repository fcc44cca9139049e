/* SPDX-License-Identifier: MIT */
/* Arm's synchronous serial port PL022 as a master that only sends, eight bits at a time (SPI
 * mode 3: the clock is high when idle, data is sampled at its rising edge). */
#ifndef BOARD_PL022_H
#define BOARD_PL022_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/* Sets up the port at this address, whose clock must be on. divider: of the
 * port's clock, even, 2..254. */
void pl022_open(uintptr_t base, uint32_t divider);

/* Sends bytes, and returns when the last bit is out. Returns false where the port makes no
 * progress. */
bool pl022_send(uintptr_t base, const uint8_t *bytes, size_t size);

#endif

/* SPDX-License-Identifier: MIT */
/* An I2C master on Arm's SBCon: two open-drain lines that the program switches itself. */
#ifndef BOARD_SBCON_H
#define BOARD_SBCON_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/* Sends bytes to the device at a 7-bit address, through the port at base. Returns false where a
 * byte, or the address, was not acknowledged. */
bool sbcon_send(uintptr_t base, uint32_t address, const uint8_t *bytes, size_t size);

#endif

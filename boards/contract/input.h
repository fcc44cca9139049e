/* SPDX-License-Identifier: MIT */
/* Board contract: what a player holds down. */
#ifndef BOARD_INPUT_H
#define BOARD_INPUT_H

#include <stdint.h>

/* The keys held at this moment, as FXL_KEY_... bits of fixel/viewer.h and no
 * others. 0 on a board without keys. Does not wait. */
uint32_t input_keys(void);

#endif

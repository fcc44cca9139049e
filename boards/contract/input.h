/* SPDX-License-Identifier: MIT */
/* Board contract: the keys that a player holds down. */
#ifndef BOARD_INPUT_H
#define BOARD_INPUT_H

#include <stdint.h>

/* Returns the keys held at this moment, as FXL_KEY_... bits of fixel/scene.h and no others.
 * Returns 0 on a board without keys. Does not wait. */
uint32_t input_keys(void);

#endif

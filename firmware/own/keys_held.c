/* SPDX-License-Identifier: MIT */
/* keys_held of docs/hello.md, for a program that leaves it to whoever runs it. */
#include "contract/input.h"
#include "contract/system.h"

uint32_t keys_held(void);

/* Returns the keys that the player at a viewer holds, as FXL_KEY_... bits; 0 without a viewer. */
uint32_t keys_held(void)
{
    return system_live() ? input_keys() : 0;
}

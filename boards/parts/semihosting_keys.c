/* SPDX-License-Identifier: MIT */
/* input.h with a file of the host, "keys" in the directory in which the emulator was started:
 * one byte, the keys that the player holds. For boards without keys of their own. */
#include "contract/input.h"
#include "parts/semihosting.h"

#define KEYS_NAME "keys"

uint32_t input_keys(void)
{
    static enum {
        UNOPENED,
        OPEN,
        ABSENT
    } state;
    static int handle;
    uint8_t keys = 0;

    if (state == UNOPENED) {
        handle = semihosting_open(KEYS_NAME);
        state = handle >= 0 ? OPEN : ABSENT;
    }
    if (state == OPEN &&
        (semihosting_seek(handle, 0) != 0 || semihosting_read(handle, &keys, sizeof keys) != 0)) {
        keys = 0; /* no file yet */
    }
    return keys;
}

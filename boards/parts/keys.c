/* SPDX-License-Identifier: MIT */
#include "parts/keys.h"

#include <stdbool.h>

#include "fixel/player.h"

/* Tells whether the readings of one button agree for long enough. */
static bool is_settled(keys_debouncer *keys, uint32_t i, bool is_equal, uint32_t milliseconds)
{
    if (!is_equal || keys->equal[i] == 0) {
        keys->since[i] = milliseconds;
        keys->equal[i] = 1;
    } else if (keys->equal[i] < KEYS_READINGS) {
        keys->equal[i]++;
    }
    return keys->equal[i] >= KEYS_READINGS && milliseconds - keys->since[i] >= KEYS_SETTLE;
}

uint32_t keys_debounce(keys_debouncer *keys, uint32_t reading, uint32_t milliseconds)
{
    uint32_t i;

    for (i = 0; i < KEYS_COUNT; i++) {
        const uint32_t bit = 1u << i;
        const bool is_equal = ((reading ^ keys->last) & bit) == 0;

        if (is_settled(keys, i, is_equal, milliseconds)) {
            keys->trusted |= ~reading & bit;
            keys->held = (keys->held & ~bit) | (reading & keys->trusted & bit);
        }
    }
    keys->last = reading;
    return keys->held;
}

uint32_t keys_meaning(uint32_t held)
{
    static const uint32_t walk[4] = {FXL_KEY_FORWARD, FXL_KEY_BACK, FXL_KEY_LEFT, FXL_KEY_RIGHT};
    static const uint32_t look[4] = {FXL_KEY_PITCH_UP, FXL_KEY_PITCH_DOWN, FXL_KEY_ROLL_LEFT,
                                     FXL_KEY_ROLL_RIGHT};
    const uint32_t *meanings = (held & KEYS_SELECT) != 0 ? look : walk;
    uint32_t meaning = 0;
    uint32_t i;

    for (i = 0; i < 4; i++) {
        if ((held >> i & 1u) != 0) {
            meaning |= meanings[i];
        }
    }
    return meaning;
}

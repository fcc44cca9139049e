/* SPDX-License-Identifier: MIT */
/* Five buttons as the keys of a player: removes contact bounce, and gives each button a meaning.
 * Uses no hardware and no clock of its own: the board reads its pins. */
#ifndef BOARD_KEYS_H
#define BOARD_KEYS_H

#include <stdint.h>

/* Buttons, as bits; the board combines them. */
enum {
    KEYS_UP = 1u << 0,
    KEYS_DOWN = 1u << 1,
    KEYS_LEFT = 1u << 2,
    KEYS_RIGHT = 1u << 3,
    KEYS_SELECT = 1u << 4,
    KEYS_ALL = 0x1Fu
};

#define KEYS_COUNT    5u
#define KEYS_READINGS 3u /* equal readings until a button changes */
#define KEYS_SETTLE   5u /* the least time from the first of them to the last, in milliseconds */

/* The debouncer; all 0 at first. */
typedef struct {
    uint32_t held;              /* the debounced buttons */
    uint32_t trusted;           /* buttons that were read as up at least once */
    uint32_t last;              /* the reading before */
    uint32_t since[KEYS_COUNT]; /* when each button's last change was read */
    uint8_t equal[KEYS_COUNT];  /* readings since that change, at most KEYS_READINGS */
} keys_debouncer;

/* Takes a reading of the pins (KEYS_... bits that are down) at a time in milliseconds, which may
 * wrap. Returns the buttons that are held. A button changes when KEYS_READINGS readings over
 * KEYS_SETTLE milliseconds agree, so a bounce is not a press. A button that reads as down from
 * the start counts as up until it has been up once: it may be stuck, or absent. */
uint32_t keys_debounce(keys_debouncer *keys, uint32_t reading, uint32_t milliseconds);

/* Returns the keys that buttons mean, as FXL_KEY_... bits of fixel/scene.h. The arrows walk and
 * turn. With select held, up and down are pitch, left and right are roll. */
uint32_t keys_meaning(uint32_t held);

#endif

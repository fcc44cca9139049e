/* SPDX-License-Identifier: MIT */
/* A panel that is memory which a viewer on the host shares: a header and two
 * buffers. The board draws into the one that the viewer is not told of, and
 * tells of it once it is whole; so a frame is never seen half drawn. Little-endian,
 * as docs/formats.md, section 3, says.
 *
 * A viewer's side of it, in this order:
 *   1. Before power-on: write invitation. (Without it the panel stays out.)
 *   2. Wait for magic, then read format, palette and the places of the slots.
 *   3. For a frame: advance requested; wait until finished is what was asked for.
 *   4. Read finished, then front, copy that slot, read finished again: the copy
 *      is of one frame if finished has not moved. A board that is asked for
 *      many frames at once does not wait, and may draw over the slot meanwhile.
 *
 * A core with a data cache must not cache this memory; no board of ours turns
 * its data cache on. */
#ifndef BOARD_WINDOW_H
#define BOARD_WINDOW_H

#include <stdatomic.h>
#include <stdbool.h>

#include "contract/panel.h"

#define WINDOW_MAGIC      0x574C5846u /* the bytes F X L W */
#define WINDOW_VERSION    2u
#define WINDOW_INVITATION 0x57454956u /* the bytes V I E W */
#define WINDOW_SLOTS      2u
#define WINDOW_FIRST_SLOT 4096u /* bytes from the header's first */

/* What is told about a frame, at the beginning of its slot; its pixels follow,
 * rows downward without a gap. */
typedef struct {
    uint64_t instructions;
    uint32_t number; /* from 0 */
    uint32_t clamped;
    fxl_pose pose;
    fxl_counters counters;
} window_frame;

/* At the beginning of the shared memory. Words that both sides use at the same
 * time are atomic: a write of one is seen only after all that was written
 * before it. */
typedef struct {
    /* The board's. */
    _Atomic uint32_t magic; /* written last of all that open writes */
    uint32_t version;
    uint16_t width, height;
    uint32_t slots[WINDOW_SLOTS]; /* where they begin: bytes from here */
    _Atomic uint32_t finished;    /* frames so far, modulo 2^32 */
    _Atomic uint32_t front;       /* slot of the last of them */
    uint32_t pixel_bits;          /* 8: palette indices; 16: colours of RGB565 */
    /* The viewer's. */
    _Atomic uint32_t invitation;
    _Atomic uint32_t requested; /* the board waits while finished is not less, modulo 2^32 */
    _Atomic uint32_t keys;      /* keys that are held, as bits of fixel/scene.h */
    uint32_t reserved;
    /* The board's. */
    uint8_t palette[768];
} window_header;

/* The shared memory, from BOARD_MEMORY in board.mk. Of fxl_window_size the address
 * is the size in bytes. */
extern uint8_t fxl_window[], fxl_window_size[];

/* Tells whether a viewer waits. */
bool window_invited(void);

/* For input_keys: returns the keys that the player at the viewer holds; 0 where no viewer waits. */
uint32_t window_keys(void);

/* Sleeps about a millisecond; the board implements it. A request does not wake it. */
void window_nap(void);

extern const panel window_panel;

#endif

/* SPDX-License-Identifier: MIT */
/* The interface that a panel implements: it joins a display to a board. A board lists its panels;
 * parts/display.c presents them to a program as one display.
 *
 * Ownership of the pixels: a panel has them for the length of flush. Until flush returns nobody
 * else changes them, and the panel may read them in any way, also by DMA. Afterwards the caller
 * draws over them. So a panel that sends in the background copies them into a buffer of its own,
 * or waits until it has sent. It waits for its own buffer in the next flush. It never writes to
 * the pixels. The palette may be read until close returns.
 *
 * Order of calls, which parts/display.c ensures, so a panel need not check it:
 *   open, then for each frame begin, flush, ..., flush, end; then close.
 * The rectangles of a frame are whole rows (x = 0, width = the format's). They go downward
 * without a gap and end with the last row. A frame may come as one rectangle or as one for each
 * row. A dump (parts/dump.h) and a driver's panel also take frames of boxes. After a call that returned false the only call is close. close may come within a frame. */
#ifndef BOARD_PANEL_H
#define BOARD_PANEL_H

#include <stdbool.h>
#include <stdint.h>

#include "fixel/types.h"

/* place pixel-format: if a palette of 256 colours does not show the pixels: what a panel takes */
/* The format of the frames. */
typedef struct {
    const uint8_t *palette; /* 256 x red, green, blue */
    uint32_t frames;        /* how many will come, at least 1 */
    uint16_t width, height; /* pixels, 1 to 1024 */
    uint8_t pixel_bits;     /* 8: a pixel is a palette index; 16: a colour of RGB565 */
} panel_format;

typedef enum {
    PANEL_READY,      /* the panel will show the frames */
    PANEL_UNSUITABLE, /* not this size, or not present: the run goes on without it */
    PANEL_FAILED      /* the panel failed: the run ends */
} panel_answer;

typedef struct {
    /* Makes the panel ready. Only here may the panel refuse a format. If it does not return
     * PANEL_READY, no other call follows. The format record is no longer valid when open has
     * returned. */
    panel_answer (*open)(const panel_format *format);

    /* Begins frame `number`, counted from 0, with the pose of the eye. Null where a panel does
     * not need it. False: the panel failed. */
    bool (*begin)(uint32_t number, const fxl_pose *pose);

    /* Takes height rows of width pixels each, without a gap between rows: uint8_t, or uint16_t in
     * the byte order of the core. The top left is pixel (x, y). False: the panel failed. */
    bool (*flush)(uint16_t x, uint16_t y, uint16_t width, uint16_t height, const void *pixels);

    /* Ends the frame, after its last row; journal.h describes the arguments. Null where a panel
     * does not need it. False: the panel failed. */
    bool (*end)(const fxl_counters *counters, uint32_t clamped, uint64_t instructions);

    /* Closes the panel, after everything that was sent in the background has arrived. whole:
     * every announced frame came, and so far no panel failed. Returns false where something that
     * the panel took did not arrive. */
    bool (*close)(bool whole);
} panel;

/* The board's panels, at most 32, in the order in which they are called. Null ends the list. A
 * board without a display has an empty list. */
const panel *const *board_panels(void);

#endif

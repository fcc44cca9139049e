/* SPDX-License-Identifier: MIT */
/* What a display driver implements. A board lists its panels; parts/display.c
 * gives them, as one display, what a program shows.
 *
 * Who owns the pixels: a panel has them for the length of flush. Until flush
 * returns nobody else touches them, and the panel may read them in any way, by
 * DMA too; afterwards the caller draws over them. So a panel that sends in the
 * background copies into a buffer of its own, or waits until it has sent; and
 * it waits for its own buffer in the next flush. It never writes into them.
 * The palette may be read until close returns.
 *
 * Order of calls, which parts/display.c sees to, so that a panel need not:
 *   open, then for each frame begin, flush, ..., flush, end; then close.
 * The rectangles of a frame are whole rows (x = 0, width = the format's), go
 * downward without a gap and end with the last row; a frame may come as one
 * rectangle or as one for each row. After a call that answered false there is
 * only close. close may come within a frame. */
#ifndef BOARD_PANEL_H
#define BOARD_PANEL_H

#include <stdbool.h>
#include <stdint.h>

#include "fixel/types.h"

/* What will be shown. */
typedef struct {
    const uint8_t *palette; /* 256 x red, green, blue */
    uint32_t frames;        /* how many will come, at least 1 */
    uint16_t width, height; /* pixels, 1 to 1024 */
} panel_format;

typedef enum {
    PANEL_READY,      /* it will show the frames */
    PANEL_UNSUITABLE, /* not this size, or it is not there: it is left out of the run */
    PANEL_FAILED      /* it should have, and could not: the run ends */
} panel_answer;

typedef struct {
    /* Makes the panel ready. Only here may it refuse what it is to show; where
     * it does not answer PANEL_READY, no other call follows. The format itself
     * is gone when open returns. */
    panel_answer (*open)(const panel_format *format);

    /* Begins frame number, counted from 0: where the eye was. Null where a
     * panel has no use for it. False: the panel failed. */
    bool (*begin)(uint32_t number, const fxl_pose *pose);

    /* Takes height rows of width pixels each, one byte a pixel, without a gap
     * between rows, whose top left is pixel (x, y). False: the panel failed. */
    bool (*flush)(uint16_t x, uint16_t y, uint16_t width, uint16_t height, const uint8_t *pixels);

    /* Ends the frame: every row came; for the rest see journal.h. Null where a
     * panel has no use for it. False: the panel failed. */
    bool (*end)(const fxl_counters *counters, uint32_t clamped, uint64_t instructions);

    /* Ends the showing, after everything that was sent in the background has
     * arrived. whole: every frame that was announced came, and so far no panel
     * failed. False where something that was taken did not arrive. */
    bool (*close)(bool whole);
} panel;

/* The board's panels, at most 32, in the order in which they are served; null
 * ends the list. A board that shows nothing has an empty list. */
const panel *const *board_panels(void);

#endif

/* SPDX-License-Identifier: MIT */
/* display.h and journal.h for the board's panels. The order of calls is checked here, once for
 * all panels. Every failure is remembered, so no panel takes an incomplete run for a complete
 * one. */
#include <stddef.h>

#include "contract/display.h"
#include "contract/journal.h"
#include "contract/panel.h"

#define PANELS_MAX 32u /* bits of a mask */

static struct {
    uint32_t announced, frames; /* to come; begun */
    uint32_t ready;             /* a bit for each panel of the list that is in use */
    uint16_t width, height;
    uint16_t row; /* rows of this frame so far */
    bool open, in_frame, whole;
} display;

/* Returns panel i of the list if it is in use, else null. */
static const panel *taking_part(uint32_t i)
{
    return (display.ready >> i & 1u) != 0 ? board_panels()[i] : NULL;
}

static bool close_panels(void)
{
    bool closed = true;
    uint32_t i;

    for (i = 0; i < PANELS_MAX; i++) {
        const panel *one = taking_part(i);

        if (one != NULL && !one->close(display.whole)) {
            display.whole = closed = false;
        }
    }
    display.ready = 0;
    return closed;
}

static bool open_panels(const panel_format *format)
{
    const panel *const *list = board_panels();
    uint32_t i;

    for (i = 0; i < PANELS_MAX && list[i] != NULL; i++) {
        const panel_answer answer = list[i]->open(format);

        if (answer == PANEL_READY) {
            display.ready |= 1u << i;
        } else if (answer != PANEL_UNSUITABLE) {
            return false;
        }
    }
    /* A panel beyond the mask would silently stay dark. No panel shows anything where all are
     * unsuitable. */
    return (i < PANELS_MAX || list[i] == NULL) && display.ready != 0;
}

bool journal_open(uint32_t frames)
{
    if (frames == 0 || display.open) {
        return false;
    }
    display.announced = frames;
    return true;
}

bool display_open(uint16_t width, uint16_t height, uint8_t pixel_bits, const uint8_t *palette)
{
    const panel_format format = {palette, display.announced, width, height, pixel_bits};

    if (display.open || display.announced == 0 || width == 0 || height == 0 || palette == NULL ||
        (pixel_bits != 8 && pixel_bits != 16)) {
        return false;
    }
    display.ready = 0;
    display.whole = true;
    if (!open_panels(&format)) {
        display.whole = false;
        (void)close_panels();
        return false;
    }
    display.open = true;
    display.in_frame = false;
    display.frames = 0;
    display.width = width;
    display.height = height;
    return true;
}

bool journal_begin(uint32_t number, const fxl_pose *pose)
{
    uint32_t i;

    if (!display.open || display.in_frame || number != display.frames ||
        number >= display.announced) {
        display.whole = false;
    }
    for (i = 0; i < PANELS_MAX && display.whole; i++) {
        const panel *one = taking_part(i);

        if (one != NULL && one->begin != NULL) {
            display.whole = one->begin(number, pose);
        }
    }
    if (display.whole) {
        display.in_frame = true;
        display.frames++;
        display.row = 0;
    }
    return display.whole;
}

bool display_flush(uint16_t x, uint16_t y, uint16_t width, uint16_t height, const void *pixels)
{
    uint32_t i;

    if (!display.in_frame || x != 0 || width != display.width || y != display.row || height == 0 ||
        height > display.height - display.row) {
        display.whole = false;
    }
    for (i = 0; i < PANELS_MAX && display.whole; i++) {
        const panel *one = taking_part(i);

        if (one != NULL) {
            display.whole = one->flush(x, y, width, height, pixels);
        }
    }
    if (display.whole) {
        display.row = (uint16_t)(display.row + height);
    }
    return display.whole;
}

bool journal_end(const fxl_counters *counters, uint32_t clamped, uint64_t instructions)
{
    uint32_t i;

    if (!display.in_frame || display.row != display.height) {
        display.whole = false;
    }
    for (i = 0; i < PANELS_MAX && display.whole; i++) {
        const panel *one = taking_part(i);

        if (one != NULL && one->end != NULL) {
            display.whole = one->end(counters, clamped, instructions);
        }
    }
    display.in_frame = display.in_frame && !display.whole;
    return display.whole;
}

bool display_close(void)
{
    bool closed;

    if (!display.open) {
        return false;
    }
    if (display.in_frame || display.frames != display.announced) {
        display.whole = false;
    }
    closed = close_panels();
    display.open = display.in_frame = false;
    display.announced = 0;
    return closed && display.whole;
}

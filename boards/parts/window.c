/* SPDX-License-Identifier: MIT */
#include "parts/window.h"

#include <stddef.h>
#include <string.h>

#include "contract/system.h"

/* The layout of docs/formats.md, section 3. */
_Static_assert(offsetof(window_header, finished) == 20, "docs/formats.md, section 3");
_Static_assert(offsetof(window_header, invitation) == 32, "docs/formats.md, section 3");
_Static_assert(offsetof(window_header, palette) == 48, "docs/formats.md, section 3");
_Static_assert(offsetof(window_frame, pose) == 16, "docs/formats.md, section 3");
_Static_assert(offsetof(window_frame, counters) == 40, "docs/formats.md, section 3");
_Static_assert(sizeof(window_frame) == 80, "docs/formats.md, section 3");
_Static_assert(sizeof(window_header) <= WINDOW_FIRST_SLOT, "the header reaches into a slot");

/* Data written before a word is stored is visible to whoever loads the word. On the core this
 * takes a barrier before the store, and one after the load. */
#define LOAD(word)         atomic_load_explicit(&(word), memory_order_acquire)
#define STORE(word, value) atomic_store_explicit(&(word), (value), memory_order_release)

static struct {
    uint32_t announced, finished; /* frames */
    uint32_t back;                /* the slot that is being drawn */
    uint32_t slots[WINDOW_SLOTS]; /* bytes from the header; not read back from where others write */
    uint32_t row_bytes;
} window;

static window_header *header(void)
{
    return (window_header *)(void *)fxl_window;
}

static window_frame *back_frame(void)
{
    return (window_frame *)(void *)(fxl_window + window.slots[window.back]);
}

/* formats 3.3 */
bool window_invited(void)
{
    return LOAD(header()->invitation) == WINDOW_INVITATION;
}

uint32_t window_keys(void)
{
    return window_invited() ? LOAD(header()->keys) : 0;
}

/* Waits until the viewer wants more frames than are finished. The difference is taken modulo
 * 2^32: a viewer requests fewer than 2^31 frames at once. */
/* formats 3.3 */
static void await_request(void)
{
    while (LOAD(header()->requested) - window.finished - 1u >= 0x80000000u) {
        system_alive();
        window_nap();
    }
}

/* Every byte between a slot's beginning and the next one's is its own. */
/* formats 3.1 */
static bool place_slots(const panel_format *format)
{
    const uint32_t pixels = (uint32_t)format->width * format->height; /* <= 2^20 */
    const uint32_t bytes = pixels * (format->pixel_bits / 8u);
    const uint32_t size = ((uint32_t)sizeof(window_frame) + bytes + 7u) & ~7u;

    window.slots[0] = WINDOW_FIRST_SLOT;
    window.slots[1] = WINDOW_FIRST_SLOT + size;
    return window.slots[1] + size <= (uintptr_t)fxl_window_size;
}

/* formats 3.1 */
static panel_answer open(const panel_format *format)
{
    window_header *shared = header();

    if (!window_invited()) {
        return PANEL_UNSUITABLE;
    }
    if (!place_slots(format)) {
        return PANEL_FAILED;
    }
    window.announced = format->frames;
    window.finished = 0;
    window.back = 0;
    window.row_bytes = (uint32_t)format->width * (format->pixel_bits / 8u);
    shared->version = WINDOW_VERSION;
    shared->width = format->width;
    shared->height = format->height;
    shared->pixel_bits = format->pixel_bits;
    memcpy(shared->slots, window.slots, sizeof window.slots);
    memcpy(shared->palette, format->palette, sizeof shared->palette);
    STORE(shared->finished, 0);
    STORE(shared->front, 0);
    STORE(shared->magic, WINDOW_MAGIC);
    await_request();
    return PANEL_READY;
}

/* formats 3.2 */
static bool begin(uint32_t number, const fxl_pose *pose)
{
    back_frame()->number = number;
    back_frame()->pose = *pose;
    return true;
}

static bool flush(uint16_t x, uint16_t y, uint16_t width, uint16_t height, const void *pixels)
{
    uint8_t *first = (uint8_t *)(back_frame() + 1);

    (void)x; /* whole rows come, downward */
    (void)width;
    memcpy(first + y * window.row_bytes, pixels, (size_t)window.row_bytes * height);
    return true;
}

/* formats 3.2 */
static bool end(const fxl_counters *counters, uint32_t clamped, uint64_t instructions)
{
    window_header *shared = header();
    window_frame *frame = back_frame();

    frame->counters = *counters;
    frame->clamped = clamped;
    frame->instructions = instructions;
    window.finished++;
    STORE(shared->front, window.back);
    STORE(shared->finished, window.finished);
    window.back ^= 1u;
    /* The next frame overwrites what was front before this one: not before
     * whoever copies that can see that it is not the last any more. */
    atomic_thread_fence(memory_order_seq_cst);
    if (window.finished != window.announced) {
        await_request();
    }
    return true;
}

static bool close(bool whole)
{
    (void)whole;
    return true;
}

const panel window_panel = {open, begin, flush, end, close};

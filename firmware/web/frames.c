/* SPDX-License-Identifier: MIT */
/* The board of a program of examples/ in a page. firmware/own/own.c hands out its frames, as on every board; they are kept for
 * tools/templates/example.js, which has all of them drawn at once: main does not return in between. */
#include <stddef.h>

#include "contract/input.h"
#include "contract/system.h"
#include "fixel/crc.h"
#include "page.h"
#include "parts/dump.h"

#define FRAME_BYTES (2u * FXL_SCREEN_MAX * FXL_SCREEN_MAX)

int __wrap_main(int argc, char **argv);

static uint16_t picture[FRAME_BYTES / 2u]; /* of which a frame of boxes changes some */
static uint32_t most;

/* place pixel-format: bytes of a frame, its rows and its CRC */
/* The host reads it as words of 32 bits, in this order. */
static struct {
    uint32_t width, height, pixel_bits;
    uint32_t frames;       /* that are kept */
    const uint8_t *first;  /* of each its CRC, as fxl_band_crc, and its pixels without a gap; of 16 bits: RGB565, the low byte first */
    uint32_t frame_bytes;  /* from one to the next, a multiple of 4 */
} kept;

static panel_answer open_kept(const panel_format *format)
{
    kept.width = format->width;
    kept.height = format->height;
    kept.pixel_bits = format->pixel_bits;
    kept.frame_bytes = 4u + ((uint32_t)format->width * format->height * (format->pixel_bits / 8u) + 3u) / 4u * 4u; /* <= 2^21 + 4 */
    kept.first = page_heap();
    return PANEL_READY;
}

static bool flush_kept(uint16_t x, uint16_t y, uint16_t width, uint16_t height, const void *pixels)
{
    const uint32_t bytes = kept.pixel_bits / 8u;

    for (uint32_t row = 0; row < height; row++) {
        __builtin_memcpy((uint8_t *)picture + ((y + row) * kept.width + x) * bytes, (const uint8_t *)pixels + row * width * bytes, width * bytes);
    }
    return true;
}

static bool end_kept(const fxl_counters *counters, uint32_t clamped, uint64_t instructions)
{
    static const uint16_t any_palette[1];
    const fxl_band band = {.pixels = (uint8_t *)picture,
                           .width = (uint16_t)kept.width,
                           .stride = (uint16_t)kept.width,
                           .rows = (uint16_t)kept.height,
                           .palette = kept.pixel_bits == 16 ? any_palette : NULL};
    uint8_t *const frame = page_heap() + kept.frames * kept.frame_bytes;
    uint32_t crc = FXL_CRC_START;

    (void)counters;
    (void)clamped;
    (void)instructions;
    if (!page_reach(frame + kept.frame_bytes) || fxl_band_crc(&crc, &band) != FXL_OK) {
        return false;
    }
    __builtin_memcpy(frame, &crc, sizeof crc);
    __builtin_memcpy(frame + sizeof crc, picture, kept.frame_bytes - sizeof crc);
    kept.frames++;
    return true;
}

static bool close_kept(bool whole)
{
    return whole;
}

/* own.c has a dump take frames of boxes too. */
const panel dump_panel = {open_kept, NULL, flush_kept, end_kept, close_kept};

bool dump_box(const fxl_screen_box *box)
{
    (void)box;
    return true;
}

const panel *const *board_panels(void)
{
    static const panel *const panels[] = {&dump_panel, NULL};

    return panels;
}

uint32_t system_frames(void)
{
    return most;
}

bool system_live(void)
{
    return false;
}

uint32_t input_keys(void)
{
    return 0;
}

/* Runs the program for so many frames, or to its own end. It does not return: the host sees a trap, and how it ended by status. */
EXPORTED("run") void run(uint32_t frames)
{
    most = frames;
    (void)__wrap_main(0, NULL);
}

EXPORTED("kept") const void *what_is_kept(void)
{
    return &kept;
}

/* SPDX-License-Identifier: MIT */
/* The walk as a WebAssembly module, and its board. The module imports nothing: its host (tools/templates/walk.mjs) writes a scene image into
 * the module's memory, opens it, and draws a frame by a call, for as long as it likes. */
#include <stddef.h>

#include "contract/display.h"
#include "contract/input.h"
#include "contract/journal.h"
#include "contract/store.h"
#include "contract/system.h"
#include "fixel/crc.h"
#include "page.h"
#include "walk.h"

#define MEMORY_BYTES   0x80000000u
#define FRAME_BYTES    (2u * FXL_SCREEN_MAX * FXL_SCREEN_MAX)

static const uint8_t *scene;
static size_t scene_bytes;
static walk_path path;
static uint32_t keys_held;
static uint16_t pixels[FRAME_BYTES / 2u];

/* place pixel-format: bytes of a frame, its rows and its CRC */
/* The host reads it as words of 32 bits, in this order. */
static struct {
    uint32_t width, height, pixel_bits;
    const void *pixels;     /* without a gap between rows; of 16 bits: RGB565, the low byte first */
    const uint8_t *palette; /* 256 x red, green, blue */
    uint32_t path_frames;   /* of the scene's path; 0: the keys move the eye */
    uint32_t crc;           /* of the last frame, as fxl_band_crc */
    const fxl_pose *pose;   /* of the last frame */
    fxl_counters counters;  /* of the last frame */
} shown = {.pixels = pixels, .pose = &path.viewer.pose};

/* Before open: where the host writes the scene image. A scene before it is gone. Null: the memory has no room for so many bytes. */
EXPORTED("scene") uint8_t *scene_room(size_t size)
{
    uint8_t *const first = page_heap();

    scene = NULL;
    if (size > MEMORY_BYTES - (size_t)first || !page_reach(first + size)) {
        return NULL;
    }
    scene = first;
    scene_bytes = size;
    return first;
}

/* Opens the scene: the next frame is the first of its path. Returns a code of system.h. */
EXPORTED("open") int open_scene(void)
{
    int code;

    page_says_nothing();
    code = walk_open(&path);
    if (code != SYSTEM_EXIT_DONE) {
        return code;
    }
    shown.path_frames = path.frame_count;
    return walk_show(UINT32_MAX);
}

/* Draws frame `number`: along the path it is that of the frame before and 1, from 0 after open. by_keys: the keys held, of fixel/scene.h,
 * move the eye in the place of the path, and what moves is where it is in that frame. Returns a code of system.h. */
EXPORTED("draw") int draw(uint32_t number, bool by_keys, uint32_t held)
{
    page_says_nothing();
    path.live = by_keys;
    keys_held = held;
    return walk_frame(&path, number);
}

/* Puts the eye there; draw refuses what is out of range. */
EXPORTED("place") void place(int32_t x, int32_t y, int32_t z, uint32_t yaw, uint32_t pitch, uint32_t roll)
{
    path.viewer.pose = (fxl_pose){.position = {x, y, z}, .yaw = yaw, .pitch = pitch, .roll = roll};
}

EXPORTED("shown") const void *what_is_shown(void)
{
    return &shown;
}

/* --- the board ---------------------------------------------------------------------------------- */

uint32_t system_frames(void)
{
    return 0;
}

bool system_live(void)
{
    return path.live;
}

const void *store_scene(size_t *size)
{
    *size = scene != NULL ? scene_bytes : 0;
    return scene;
}

uint32_t input_keys(void)
{
    return keys_held;
}

/* --- its display: what a host asks for may come in any order ---------------------------------------- */

bool journal_open(uint32_t frames)
{
    return frames > 0;
}

bool journal_begin(uint32_t number, const fxl_pose *pose)
{
    (void)number;
    (void)pose; /* path.viewer has it */
    return true;
}

bool journal_end(const fxl_counters *counters, uint32_t clamped, uint64_t instructions)
{
    static const uint16_t any_palette[1];
    const fxl_band band = {.pixels = (uint8_t *)pixels,
                           .width = (uint16_t)shown.width,
                           .stride = (uint16_t)shown.width,
                           .rows = (uint16_t)shown.height,
                           .palette = shown.pixel_bits == 16 ? any_palette : NULL};

    (void)clamped;
    (void)instructions;
    shown.counters = *counters;
    shown.crc = FXL_CRC_START;
    return fxl_band_crc(&shown.crc, &band) == FXL_OK;
}

bool display_open(uint16_t width, uint16_t height, uint8_t pixel_bits, const uint8_t *palette)
{
    shown.width = width;
    shown.height = height;
    shown.pixel_bits = pixel_bits;
    shown.palette = palette;
    return true;
}

bool display_flush(uint16_t x, uint16_t y, uint16_t width, uint16_t height, const void *rows)
{
    const uint32_t row_bytes = width * shown.pixel_bits / 8u; /* <= 2048 */

    (void)x;
    __builtin_memcpy((uint8_t *)pixels + y * row_bytes, rows, height * row_bytes);
    return true;
}

bool display_close(void)
{
    return true;
}

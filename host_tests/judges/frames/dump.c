/* SPDX-License-Identifier: MIT */
#include "frames/dump.h"

/* IEEE 802.3, reflected, bit by bit. */
static void put(dump *to, const void *bytes, size_t size)
{
    const uint8_t *from = bytes;
    for (size_t i = 0; i < size; i++) {
        to->crc ^= from[i];
        for (int bit = 0; bit < 8; bit++) {
            to->crc = to->crc >> 1 ^ (to->crc & 1 ? 0xEDB88320u : 0);
        }
    }
    to->failed = to->failed || fwrite(bytes, 1, size, to->file) != size;
}

static void put_number(dump *to, uint64_t value, int size)
{
    uint8_t bytes[8];
    for (int i = 0; i < size; i++) {
        bytes[i] = (uint8_t)(value >> 8 * i);
    }
    put(to, bytes, (size_t)size);
}

bool dump_begin(dump *to, const char *path, const fxl_scene_image *image, uint32_t frames,
                uint8_t pixel_bits)
{
    *to = (dump){.file = fopen(path, "wb"), .crc = UINT32_MAX, .pixel_bits = pixel_bits};
    if (!to->file) {
        return false;
    }
    put(to, "FXLD", 4);
    put_number(to, 3, 2);
    put_number(to, image->lens.width, 2);
    put_number(to, image->lens.height, 2);
    put_number(to, pixel_bits, 2);
    put_number(to, frames, 4);
    put(to, image->palette, 768);
    return true;
}

void dump_frame(dump *to, const fxl_pose *pose, const void *pixels, size_t area,
                const fxl_counters *counters, uint32_t clamped)
{
    const uint32_t numbers[] = {(uint32_t)pose->position.x,
                                (uint32_t)pose->position.y,
                                (uint32_t)pose->position.z,
                                pose->yaw,
                                pose->pitch,
                                pose->roll};
    const uint32_t counted[] = {counters->in,      counters->backfacing,
                                counters->outside, counters->degenerate,
                                counters->refused, counters->drawn,
                                counters->clipped, counters->refused_calls,
                                counters->spilled, clamped};
    put(to, "FRAM", 4);
    put_number(to, to->frames++, 4);
    for (size_t i = 0; i < sizeof numbers / sizeof *numbers; i++) {
        put_number(to, numbers[i], 4);
    }
    put(to, pixels, area * (to->pixel_bits / 8u)); /* on a little-endian host */
    for (size_t i = 0; i < sizeof counted / sizeof *counted; i++) {
        put_number(to, counted[i], 4);
    }
    put_number(to, 0, 8); /* instructions, which the host does not count */
}

bool dump_end(dump *to)
{
    put(to, "FEND", 4);
    put_number(to, to->frames, 4);
    put_number(to, to->crc ^ UINT32_MAX, 4);
    return fclose(to->file) == 0 && !to->failed;
}

/* SPDX-License-Identifier: MIT */
/* display.h and journal.h as one frame dump (chapter 9 of SPEC.md), written to
 * a sink as it comes. Whatever goes wrong once is remembered: the dump then
 * never gets its tail, so nobody can take it for whole. */
#include <stddef.h>

#include "contract/display.h"
#include "contract/journal.h"
#include "parts/sink.h"

#define DUMP_VERSION   1u
#define PALETTE_BYTES  768u
#define CRC_POLYNOMIAL 0xEDB88320u /* IEEE 802.3, reflected */

static struct {
    uint32_t announced, frames; /* to come; begun */
    uint32_t crc;               /* inverted, of all bytes so far */
    uint16_t width, height;
    uint16_t row; /* rows of this frame that came */
    bool open, in_frame, whole;
} dump;

/* Four bits at a time: a table of 64 bytes instead of 1 KiB. */
static uint32_t crc_update(uint32_t crc, const uint8_t *bytes, size_t size)
{
    static const uint32_t table[16] = {0x00000000u,    0x1DB71064u, 0x3B6E20C8u, 0x26D930ACu,
                                       0x76DC4190u,    0x6B6B51F4u, 0x4DB26158u, 0x5005713Cu,
                                       CRC_POLYNOMIAL, 0xF00F9344u, 0xD6D6A3E8u, 0xCB61B38Cu,
                                       0x9B64C2B0u,    0x86D3D2D4u, 0xA00AE278u, 0xBDBDF21Cu};
    size_t i;

    for (i = 0; i < size; i++) {
        crc ^= bytes[i];
        crc = (crc >> 4) ^ table[crc & 15u];
        crc = (crc >> 4) ^ table[crc & 15u];
    }
    return crc;
}

static bool put(const uint8_t *bytes, size_t size)
{
    dump.crc = crc_update(dump.crc, bytes, size);
    dump.whole = dump.whole && sink_write(bytes, size);
    return dump.whole;
}

static uint8_t *put_u16(uint8_t *to, uint16_t value)
{
    to[0] = (uint8_t)value;
    to[1] = (uint8_t)(value >> 8);
    return to + 2;
}

static uint8_t *put_u32(uint8_t *to, uint32_t value)
{
    return put_u16(put_u16(to, (uint16_t)value), (uint16_t)(value >> 16));
}

static uint8_t *put_tag(uint8_t *to, const char *tag)
{
    int i;

    for (i = 0; i < 4; i++) {
        to[i] = (uint8_t)tag[i];
    }
    return to + 4;
}

bool journal_open(uint32_t frames)
{
    if (frames == 0 || dump.open) {
        return false;
    }
    dump.announced = frames;
    return true;
}

bool display_open(uint16_t width, uint16_t height, const uint8_t *palette)
{
    uint8_t head[16];
    uint8_t *to;

    if (dump.open || dump.announced == 0 || width == 0 || height == 0 || palette == NULL) {
        return false;
    }
    if (!sink_open()) {
        return false;
    }
    dump.open = true;
    dump.whole = true;
    dump.in_frame = false;
    dump.frames = 0;
    dump.width = width;
    dump.height = height;
    dump.crc = ~0u;
    to = put_u16(put_tag(head, "FXLD"), DUMP_VERSION);
    to = put_u16(put_u16(to, width), height);
    to = put_u16(to, 0);
    (void)put_u32(to, dump.announced);
    (void)put(head, sizeof head);
    return put(palette, PALETTE_BYTES);
}

bool journal_begin(uint32_t number, const fxl_pose *pose)
{
    uint8_t head[32];
    uint8_t *to;

    if (!dump.open || dump.in_frame || number != dump.frames || number >= dump.announced) {
        dump.whole = false;
        return false;
    }
    dump.in_frame = true;
    dump.frames++;
    dump.row = 0;
    to = put_u32(put_tag(head, "FRAM"), number);
    to = put_u32(to, (uint32_t)pose->position.x);
    to = put_u32(to, (uint32_t)pose->position.y);
    to = put_u32(to, (uint32_t)pose->position.z);
    to = put_u32(put_u32(to, pose->yaw), pose->pitch);
    (void)put_u32(to, pose->roll);
    return put(head, sizeof head);
}

bool display_flush(uint16_t x, uint16_t y, uint16_t width, uint16_t height, const uint8_t *pixels)
{
    if (!dump.in_frame || x != 0 || width != dump.width || y != dump.row || height == 0 ||
        height > dump.height - dump.row) {
        dump.whole = false;
        return false;
    }
    dump.row = (uint16_t)(dump.row + height);
    return put(pixels, (size_t)width * height); /* <= 2^20 */
}

bool journal_end(const fxl_counters *counters, uint32_t clamped, uint64_t instructions)
{
    uint8_t end[44];
    uint8_t *to;

    if (!dump.in_frame || dump.row != dump.height) {
        dump.whole = false;
        return false;
    }
    dump.in_frame = false;
    to = put_u32(put_u32(end, counters->in), counters->backfacing);
    to = put_u32(put_u32(to, counters->outside), counters->degenerate);
    to = put_u32(put_u32(to, counters->refused), counters->drawn);
    to = put_u32(put_u32(to, counters->clipped), counters->refused_calls);
    to = put_u32(to, clamped);
    to = put_u32(to, (uint32_t)instructions);
    (void)put_u32(to, (uint32_t)(instructions >> 32));
    return put(end, sizeof end);
}

bool display_close(void)
{
    uint8_t tail[12];

    if (!dump.open) {
        return false;
    }
    dump.open = false;
    if (dump.in_frame || dump.frames != dump.announced) {
        dump.whole = false;
    }
    if (dump.whole) {
        (void)put(tail, (size_t)(put_u32(put_tag(tail, "FEND"), dump.frames) - tail));
        (void)put_u32(tail + 8, ~dump.crc);
        (void)put(tail + 8, 4);
    }
    dump.announced = 0;
    return sink_close(dump.whole) && dump.whole;
}

/* SPDX-License-Identifier: MIT */
/* A panel that is a frame dump (docs/formats.md, section 2), written to a sink as the frames
 * come. The dump gets its tail only if every frame came and every byte was taken, so an
 * incomplete dump is recognised. */
#include <stddef.h>

#include "parts/dump.h"
#include "parts/sink.h"

#define DUMP_VERSION   3u
#define PALETTE_BYTES  768u
#define CRC_POLYNOMIAL 0xEDB88320u /* IEEE 802.3, reflected */

static uint32_t frames; /* ended */
static uint32_t pixel_bytes;
static uint32_t crc;    /* inverted, of all bytes so far */

/* Four bits at a time: a table of 64 bytes instead of 1 KiB. */
static uint32_t crc_update(uint32_t value, const uint8_t *bytes, size_t size)
{
    static const uint32_t table[16] = {0x00000000u,    0x1DB71064u, 0x3B6E20C8u, 0x26D930ACu,
                                       0x76DC4190u,    0x6B6B51F4u, 0x4DB26158u, 0x5005713Cu,
                                       CRC_POLYNOMIAL, 0xF00F9344u, 0xD6D6A3E8u, 0xCB61B38Cu,
                                       0x9B64C2B0u,    0x86D3D2D4u, 0xA00AE278u, 0xBDBDF21Cu};
    size_t i;

    for (i = 0; i < size; i++) {
        value ^= bytes[i];
        value = (value >> 4) ^ table[value & 15u];
        value = (value >> 4) ^ table[value & 15u];
    }
    return value;
}

static bool put(const uint8_t *bytes, size_t size)
{
    crc = crc_update(crc, bytes, size);
    return sink_write(bytes, size);
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

static panel_answer open(const panel_format *format)
{
    uint8_t head[16];
    uint8_t *to;

    if (!sink_open()) {
        return PANEL_FAILED;
    }
    frames = 0;
    pixel_bytes = format->pixel_bits / 8u;
    crc = ~0u;
    to = put_u16(put_tag(head, "FXLD"), DUMP_VERSION);
    to = put_u16(put_u16(to, format->width), format->height);
    to = put_u16(to, format->pixel_bits);
    (void)put_u32(to, format->frames);
    if (!put(head, sizeof head) || !put(format->palette, PALETTE_BYTES)) {
        (void)sink_close(false);
        return PANEL_FAILED;
    }
    return PANEL_READY;
}

static bool begin(uint32_t number, const fxl_pose *pose)
{
    uint8_t head[32];
    uint8_t *to;

    to = put_u32(put_tag(head, "FRAM"), number);
    to = put_u32(to, (uint32_t)pose->position.x);
    to = put_u32(to, (uint32_t)pose->position.y);
    to = put_u32(to, (uint32_t)pose->position.z);
    to = put_u32(put_u32(to, pose->yaw), pose->pitch);
    (void)put_u32(to, pose->roll);
    return put(head, sizeof head);
}

static bool flush(uint16_t x, uint16_t y, uint16_t width, uint16_t height, const void *pixels)
{
    (void)x; /* whole rows come, downward */
    (void)y;
    return put(pixels, (size_t)width * height * pixel_bytes); /* <= 2^21 */
}

static bool end(const fxl_counters *counters, uint32_t clamped, uint64_t instructions)
{
    uint8_t last[48];
    uint8_t *to;

    frames++;
    to = put_u32(put_u32(last, counters->in), counters->backfacing);
    to = put_u32(put_u32(to, counters->outside), counters->degenerate);
    to = put_u32(put_u32(to, counters->refused), counters->drawn);
    to = put_u32(put_u32(to, counters->clipped), counters->refused_calls);
    to = put_u32(put_u32(to, counters->spilled), clamped);
    to = put_u32(to, (uint32_t)instructions);
    (void)put_u32(to, (uint32_t)(instructions >> 32));
    return put(last, sizeof last);
}

static bool close(bool whole)
{
    uint8_t tail[12];

    if (whole) {
        whole = put(tail, (size_t)(put_u32(put_tag(tail, "FEND"), frames) - tail));
        (void)put_u32(tail + 8, ~crc);
        whole = whole && put(tail + 8, 4);
        return sink_close(whole) && whole;
    }
    return sink_close(false);
}

const panel dump_panel = {open, begin, flush, end, close};

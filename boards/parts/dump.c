/* SPDX-License-Identifier: MIT */
/* A panel that is a frame dump (docs/formats.md, section 2), written to a sink as the frames
 * come. The dump gets its tail only if every frame came and every byte was taken, so an
 * incomplete dump is recognised. */
#include <stddef.h>

#include "fixel/crc.h"
#include "parts/dump.h"

#define DUMP_VERSION  3u
#define PALETTE_BYTES 768u

static uint32_t frames; /* ended */
static uint32_t pixel_bytes;
static uint32_t crc; /* of all bytes so far */

static bool put(const uint8_t *bytes, size_t size)
{
    crc = fxl_crc(crc, bytes, size);
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
    crc = FXL_CRC_START;
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

bool dump_box(const fxl_screen_box *box)
{
    uint8_t head[8];
    uint8_t *to;

    to = put_u16(put_u16(head, box->first_column), box->columns);
    (void)put_u16(put_u16(to, box->first_row), box->rows);
    return put(head, sizeof head);
}

static bool flush(uint16_t x, uint16_t y, uint16_t width, uint16_t height, const void *pixels)
{
    (void)x; /* whole rows come, downward; or those of the box that was announced */
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
        (void)put_u32(tail + 8, crc);
        whole = whole && put(tail + 8, 4);
        return sink_close(whole) && whole;
    }
    return sink_close(false);
}

const panel dump_panel = {open, begin, flush, end, close};

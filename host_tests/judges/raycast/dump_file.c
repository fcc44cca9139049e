/* SPDX-License-Identifier: MIT */
#include "dump_file.h"

#include <math.h>
#include <string.h>

#include "file.h"

enum {
    HEAD = 16 + 768,
    POSE = 24,
    AFTER_PIXELS = 36 + 4 + 8,
    TAIL = 12
};

static double radians(const uint8_t *at)
{
    return get_u32(at) * (acos(-1.0) / 2147483648.0);
}

static dump_frame frame_at(const uint8_t *at)
{
    const uint8_t *pose = at + 8;
    return (dump_frame){
        .number = get_u32(at + 4),
        .eye = {get_i32(pose) / 65536.0, get_i32(pose + 4) / 65536.0, get_i32(pose + 8) / 65536.0},
        .yaw = radians(pose + 12),
        .pitch = radians(pose + 16),
        .roll = radians(pose + 20),
        .pixels = pose + POSE,
    };
}

dump dump_read(const char *path)
{
    file_block file = file_read(path);
    const uint8_t *bytes = file.bytes;
    if (file.size < HEAD + TAIL || memcmp(bytes, "FXLD", 4) != 0)
        unusable("%s: not a frame dump", path);
    if (get_u16(bytes + 4) != 3)
        unusable("%s: this version of the frame dump is not known", path);
    if (get_u16(bytes + 10) != 8)
        unusable("%s: rays judge pixels of 8 bits alone", path);
    dump d = {.width = get_u16(bytes + 6), .height = get_u16(bytes + 8)};
    size_t frame_size = 8 + POSE + (size_t)d.width * d.height + AFTER_PIXELS;
    const uint8_t *tail = bytes + file.size - TAIL;
    if (memcmp(tail, "FEND", 4) != 0 || (file.size - HEAD - TAIL) % frame_size != 0)
        unusable("%s: the dump is incomplete", path);
    if (crc32_of(bytes, file.size - 4) != get_u32(tail + 8))
        unusable("%s: the checksum does not match", path);
    d.frame_count = get_u32(tail + 4);
    if (d.frame_count == 0 || d.frame_count != (file.size - HEAD - TAIL) / frame_size)
        unusable("%s: %u frames are said to be in it, which its size belies", path, d.frame_count);
    d.frames = allocate(d.frame_count, sizeof *d.frames);
    for (uint32_t i = 0; i < d.frame_count; i++) {
        const uint8_t *at = bytes + HEAD + i * frame_size;
        if (memcmp(at, "FRAM", 4) != 0)
            unusable("%s: frame %u does not begin where it should", path, i);
        d.frames[i] = frame_at(at);
    }
    return d;
}

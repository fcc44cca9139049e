/* SPDX-License-Identifier: MIT */
#include "file.h"

#include <errno.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <math.h>

_Noreturn void unusable(const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    fputs("raycast: ", stderr);
    vfprintf(stderr, format, arguments);
    fputc('\n', stderr);
    va_end(arguments);
    exit(2);
}

void *allocate(size_t count, size_t size)
{
    void *block = calloc(count ? count : 1, size);
    if (!block)
        unusable("out of memory for %zu items of %zu bytes", count, size);
    return block;
}

file_block file_read(const char *path)
{
    FILE *file = fopen(path, "rb");
    if (!file)
        unusable("cannot open %s: %s", path, strerror(errno));
    file_block block = {NULL, 0};
    size_t room = 0;
    for (;;) {
        if (block.size == room) {
            room = room ? room * 2 : (size_t)1 << 16;
            uint8_t *larger = realloc(block.bytes, room);
            if (!larger)
                unusable("out of memory while reading %s", path);
            block.bytes = larger;
        }
        size_t got = fread(block.bytes + block.size, 1, room - block.size, file);
        if (got == 0)
            break;
        block.size += got;
    }
    if (ferror(file))
        unusable("cannot read %s: %s", path, strerror(errno));
    fclose(file);
    return block;
}

uint16_t get_u16(const uint8_t *at)
{
    return (uint16_t)(at[0] | at[1] << 8);
}

uint32_t get_u32(const uint8_t *at)
{
    return (uint32_t)at[0] | (uint32_t)at[1] << 8 | (uint32_t)at[2] << 16 | (uint32_t)at[3] << 24;
}

int32_t get_i32(const uint8_t *at)
{
    uint32_t bits = get_u32(at);
    int32_t value;
    memcpy(&value, &bits, sizeof value);
    return value;
}

uint32_t crc32_of(const uint8_t *bytes, size_t size)
{
    uint32_t remainders[256];
    for (uint32_t i = 0; i < 256; i++) {
        uint32_t remainder = i;
        for (int bit = 0; bit < 8; bit++)
            remainder = remainder >> 1 ^ (remainder & 1 ? 0xEDB88320u : 0);
        remainders[i] = remainder;
    }
    uint32_t crc = 0xFFFFFFFFu;
    for (size_t i = 0; i < size; i++)
        crc = crc >> 8 ^ remainders[(crc ^ bytes[i]) & 0xFF];
    return ~crc;
}

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

/* SPDX-License-Identifier: MIT */
#include "file.h"

#include <errno.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

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
    uint32_t table[256];
    for (uint32_t i = 0; i < 256; i++) {
        uint32_t remainder = i;
        for (int bit = 0; bit < 8; bit++)
            remainder = remainder >> 1 ^ (remainder & 1 ? 0xEDB88320u : 0);
        table[i] = remainder;
    }
    uint32_t crc = 0xFFFFFFFFu;
    for (size_t i = 0; i < size; i++)
        crc = crc >> 8 ^ table[(crc ^ bytes[i]) & 0xFF];
    return ~crc;
}

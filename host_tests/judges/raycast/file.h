/* SPDX-License-Identifier: MIT */
/* Files: whole ones, and frame dumps. */
#ifndef RAYCAST_FILE_H
#define RAYCAST_FILE_H

#include <stddef.h>
#include <stdint.h>

#include "vector.h"

/* Reads files into memory, and little-endian numbers in them. */

typedef struct {
    uint8_t *bytes;
    size_t size;
} file_block;

/* Prints "raycast: ..." on stderr and exits with 2: the input is unusable. */
_Noreturn void unusable(const char *format, ...) __attribute__((format(printf, 1, 2)));

/* Reads a whole file. Does not return if it cannot be read. */
file_block file_read(const char *path);

uint16_t get_u16(const uint8_t *at);
uint32_t get_u32(const uint8_t *at);
int32_t get_i32(const uint8_t *at);

/* CRC-32 of IEEE 802.3. */
uint32_t crc32_of(const uint8_t *bytes, size_t size);

/* Allocates memory. Does not return null: exits with 2 when memory runs out. */
void *allocate(size_t count, size_t size);

/* A frame dump (docs/formats.md, section 2). */

typedef struct {
    uint32_t number;
    vector eye;
    double yaw, pitch, roll; /* radians */
    const uint8_t *pixels;
} dump_frame;

typedef struct {
    uint32_t width, height, frame_count;
    dump_frame *frames;
} dump;

/* Reads a dump. Does not return if the dump is damaged or incomplete. */
dump dump_read(const char *path);

#endif

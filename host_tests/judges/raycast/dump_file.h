/* SPDX-License-Identifier: MIT */
/* A frame dump (docs/formats.md, section 2). */
#ifndef RAYCAST_DUMP_FILE_H
#define RAYCAST_DUMP_FILE_H

#include <stdint.h>

#include "vector.h"

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

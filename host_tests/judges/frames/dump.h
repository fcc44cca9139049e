/* SPDX-License-Identifier: MIT */
/* Frame dumps (docs/formats.md, section 2), written on the host. */
#ifndef FRAMES_DUMP_H
#define FRAMES_DUMP_H

#include <stdio.h>

#include "draw/stages.h"
#include "fixel/all.h"

typedef struct {
    FILE *file;
    uint32_t crc, frames;
    uint8_t pixel_bits;
    bool failed;
} dump;

/* Opens the file and writes the head. Returns false where it cannot be written. */
bool dump_begin(dump *to, const char *path, const fxl_scene_image *image, uint32_t frames,
                uint8_t pixel_bits);
void dump_frame(dump *to, const fxl_pose *pose, const void *pixels, size_t area,
                const fxl_counters *counters, uint32_t clamped);

/* Closes the file. Returns false where something could not be written. */
bool dump_end(dump *to);

#endif

/* SPDX-License-Identifier: MIT */
/* Frame dumps, and whether their poses are those of the scene's path. */
#ifndef JUDGE_DUMP_H
#define JUDGE_DUMP_H

#include "reference/render.h"
#include "reference/scene.h"

/* Frame dumps (docs/formats.md, section 2): reads a whole dump, and writes that of the reference
 * renderer. */

typedef struct {
    int width, height, pixel_bits; /* 8: entries of the palette; 16: RGB565 */
    uint32_t frame_count;
    size_t frame_size; /* bytes of a frame's record */
    uint8_t *bytes;    /* the whole file */
    size_t size;
} judge_dump;

/* Checks head, frame numbers, tail and checksum. Returns null, or one clause that says what is
 * wrong; *dump then holds nothing. */
const char *judge_dump_open(const char *path, judge_dump *dump);
void judge_dump_close(judge_dump *dump);

ref_pose judge_dump_pose(const judge_dump *dump, uint32_t frame);

/* The pixel of a number, counted row by row. */
uint16_t judge_dump_pixel(const judge_dump *dump, uint32_t frame, size_t number);
const uint8_t *judge_dump_palette(const judge_dump *dump);

/* Makes a dump for another renderer's pixels of so many bits, and its counters. It has the same
 * head and poses otherwise.
 * Instructions, refused calls, spilled polygons and clamped steps are 0. Returns false where
 * memory is short. */
bool judge_dump_like(const judge_dump *board, int pixel_bits, judge_dump *twin);
void judge_dump_put(judge_dump *dump, uint32_t frame, const uint16_t *pixels,
                    const ref_counters *counters);

/* Sets the checksum and writes the file through a temporary one. Returns false where that fails. */
bool judge_dump_save(judge_dump *dump, const char *path);

/* Writes a file that appears under its name only when it is complete. */
bool judge_save_file(const char *path, const void *bytes, size_t size);

/* Compares the poses of a dump with the path of its scene. */

typedef struct {
    uint32_t frames;
    double max_error; /* of a coordinate, in units of 1/65536 */
    double max_bound; /* the bound of docs/accuracy.md at the last frame, same unit */
    uint32_t frames_beyond_bound;
} judge_walk;

/* Compares the poses. Poses of a path must be equal, bit for bit. Segments are replayed in
 * double from the start pose; then angles must be equal, and the error of positions is measured.
 * Returns null, or one clause that says how the dump differs from the path; *frame is then the
 * frame. */
const char *judge_walk_compare(const ref_scene_image *image, const judge_dump *dump,
                               judge_walk *walk, uint32_t *frame);

#endif

/* SPDX-License-Identifier: MIT */
/* Compares the poses of a dump with the path of its scene. */
#ifndef JUDGE_WALK_H
#define JUDGE_WALK_H

#include "judge/dump.h"

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

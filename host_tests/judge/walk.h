/* SPDX-License-Identifier: MIT */
/* The poses of a dump against the scene's path. */
#ifndef JUDGE_WALK_H
#define JUDGE_WALK_H

#include "judge/dump.h"

typedef struct {
    uint32_t frames;
    double max_error; /* of a coordinate, in units of 1/65536 */
    double max_bound; /* what docs/accuracy.md allows at the last frame, same unit */
    uint32_t frames_beyond_bound;
} judge_walk;

/* Poses must be the path's own, bit for bit. Strides are replayed in double
 * from the start pose; angles must be equal, positions are measured. Answers
 * null, or one clause that says how the dump belongs to another walk; *frame
 * is then the frame. */
const char *judge_walk_compare(const ref_scene_image *image, const judge_dump *dump,
                               judge_walk *walk, uint32_t *frame);

#endif

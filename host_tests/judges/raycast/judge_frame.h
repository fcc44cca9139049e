/* SPDX-License-Identifier: MIT */
/* Compares one frame of the reference renderer with rays. */
#ifndef RAYCAST_JUDGE_FRAME_H
#define RAYCAST_JUDGE_FRAME_H

#include "file.h"
#include "scene_file.h"

#define EXAMPLES 4

typedef struct {
    uint32_t x, y;
    uint8_t reference, ray;
} example;

typedef struct {
    uint32_t differing, unexplained;
    example examples[EXAMPLES]; /* the first unexplained pixels */
} verdict;

/* Lights the scene for the frame's eye. pixels (may be null) receives the picture that the rays
 * see, width x height. */
void judge_frame(scene *s, const dump_frame *frame, verdict *v, uint8_t *pixels);

#endif

/* SPDX-License-Identifier: MIT */
/* Every frame of a dump against the twin. */
#ifndef JUDGE_VERDICT_H
#define JUDGE_VERDICT_H

#include "judge/dump.h"

enum {
    JUDGE_SAMPLES_MAX = 4
};

/* One pixel that is not explained. */
typedef struct {
    int x, y;
    uint8_t board, reference;
    double distance; /* infinite where nothing explains it */
} judge_sample;

typedef struct {
    uint32_t differing;
    uint32_t tied;         /* of those differing: centres exactly on an edge */
    uint32_t near_far;     /* of those differing: explained with near and far moved */
    uint32_t unexplained;  /* explained only beyond the distance, or not at all */
    uint32_t inexplicable; /* not at all */
    double max_distance;   /* the largest finite one; negative where nothing differs */
    judge_sample samples[JUDGE_SAMPLES_MAX]; /* of those unexplained, the first */
} judge_frame;

/* Judges every frame, on as many threads as there are processors; frames has
 * room for dump->frame_count. cuts: the planes that the board's clipper cuts by
 * (reference/clipper.h). by_tree: whether its order was the scene's tree's. twin (may be null)
 * receives the twin's pixels. Progress on stderr. False where memory is short. */
bool judge_frames(const ref_scene_image *image, const judge_dump *dump, unsigned cuts, bool by_bsp,
                  double distance, judge_frame *frames, judge_dump *reference);

#endif

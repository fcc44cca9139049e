/* SPDX-License-Identifier: MIT */
/* Compares every frame of a dump with the reference renderer. */
#ifndef JUDGE_VERDICT_H
#define JUDGE_VERDICT_H

#include "judge/dump.h"

enum {
    JUDGE_SAMPLES_MAX = 4
};

/* One pixel that is not explained. */
typedef struct {
    int x, y;
    uint16_t board, twin;
    double distance; /* infinite where no distance explains it */
} judge_sample;

typedef struct {
    uint32_t differing;
    uint32_t tied;         /* of the differing pixels: the centre is exactly on an edge */
    uint32_t near_far;     /* of the differing pixels: explained with near and far moved */
    uint32_t texels;       /* of the differing pixels: explained with texels within their bound */
    uint32_t unexplained;  /* explained only beyond the allowed distance, or not at all */
    uint32_t inexplicable; /* not at all */
    double max_distance;   /* the largest finite one; negative where nothing differs */
    judge_sample samples[JUDGE_SAMPLES_MAX]; /* the first unexplained pixels */
} judge_frame;

/* What is judged, and where the answers go. */
typedef struct {
    const ref_scene_image *image;
    const uint8_t *bytes; /* that the image was read from */
    size_t size;
    const judge_dump *dump;
    ref_method method;   /* how the board drew */
    double distance;     /* pixels from an edge within which a difference is explained */
    int line;            /* palette index of outlines that the board drew, which are explained along
                            the edges of polygons; below 0: none */
    judge_frame *frames; /* as many as the dump has */
    /* Each may be null: the pixels of the reference renderer; the names of the faces that it shows;
     * the names of the faces and billboards that changed each pixel last, also where they let
     * through, 0 where nothing did. */
    judge_dump *twin, *names, *shown;
} judge_task;

/* Judges every frame, on as many threads as there are processors. Prints progress on stderr.
 * Returns false where memory is short, or where the library refuses a scene in which something
 * moves. */
bool judge_frames(const judge_task *asked);

#endif

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

/* A scene: the image, and the bytes that it was read from. */
typedef struct {
    const ref_scene_image *image;
    const uint8_t *bytes;
    size_t size;
} judge_scene;

/* Judges every frame, on as many threads as there are processors. frames has room for
 * dump->frame_count. cuts: the planes that the board's clipper cuts by (reference/clipper.h).
 * by_points: that clipper works from points rounded in the world. by_bsp: the board drew in the
 * order of the scene's BSP. flat: it drew faces in their own colours. depth_bits: it drew by a
 * depth buffer of so many bits; else 0. twin (may be null) receives the pixels of the reference
 * renderer, names (may be null) the names of the faces that it shows. Prints progress on stderr.
 * Returns false where memory is short, or where the library refuses a scene in which something
 * moves. shown (may be null) receives the names of the faces and billboards that changed each pixel
 * last, also where they let through; 0: nothing did. line: the palette index of outlines that the
 * board drew, which are explained along the edges of polygons; below 0: none. */
bool judge_frames(const judge_scene *scene, const judge_dump *dump, unsigned cuts, bool by_points,
                  bool by_bsp, bool flat, int depth_bits, double distance, int line,
                  judge_frame *frames,
                  judge_dump *twin, judge_dump *names, judge_dump *shown);

#endif

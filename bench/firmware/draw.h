/* SPDX-License-Identifier: MIT */
/* What draws a frame: Fixel, the chapter's listing, or a plain memset. One of
 * them is linked. */
#ifndef BENCH_DRAW_H
#define BENCH_DRAW_H

#include "fixel/render.h"

/* The largest screen of a workload, in pixels. */
#define DRAW_PIXELS_MAX (320u * 240u)

/* Makes ready for a scene, which stays; not measured. A SYSTEM_EXIT_... code. */
int draw_open(const fxl_scene_image *image);

/* Draws a frame over a band that is the whole screen and cleared: what is
 * measured. False where the renderer refused. */
bool draw_frame(const fxl_pose *pose, const fxl_band *band);

/* Bytes of RAM that drawing needs beside the band, the scene and the stack. */
uint32_t draw_memory(void);

/* What became of the frame's polygons; zeroes where the renderer does not count. */
const fxl_counters *draw_counters(void);

#endif

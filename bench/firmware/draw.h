/* SPDX-License-Identifier: MIT */
/* The functions that draw a frame: with Fixel, the chapter's listing, or a plain memset. A
 * program links one of them. */
#ifndef BENCH_DRAW_H
#define BENCH_DRAW_H

#include "fixel/render.h"

/* The largest screen of a workload, in pixels. */
#ifndef DRAW_PIXELS_MAX
#define DRAW_PIXELS_MAX (320u * 240u)
#endif

/* Prepares for a scene, which must stay valid; not measured. Returns a SYSTEM_EXIT_... code. */
int draw_open(const fxl_scene_image *image);

/* Draws a frame over a cleared band of the whole screen. This is what is measured. Returns false
 * where the renderer refused. */
bool draw_frame(const fxl_pose *pose, const fxl_band *band);

/* Bytes of RAM that drawing needs beside the band, the scene and the stack. */
uint32_t draw_memory(void);

/* After draw_open: what draws. Of programs that draw with Fixel and change what is drawn. */
fxl_renderer *draw_renderer(void);

/* The counters of the frame; zeroes where the renderer does not count. */
const fxl_counters *draw_counters(void);

#endif

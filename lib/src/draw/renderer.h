/* SPDX-License-Identifier: MIT */
/* What the files of draw share beside submit.h. Internal. */
#ifndef FXL_RENDERER_H
#define FXL_RENDERER_H

#include "fixel/render.h"

/* Counts a call that is refused; answers its status. */
fxl_status fxl_refuse(fxl_workspace *workspace, fxl_status status);

/* fxl_frame_begin. in_bands: what the display list had no room for will be drawn in several bands,
 * for which it pays to measure the rows that it reaches. */
fxl_status fxl_begin(fxl_renderer *renderer, const fxl_pose *pose, bool in_bands);

/* Bytes, rounded up to what any table may begin at. */
static inline size_t fxl_aligned(size_t bytes)
{
    return (bytes + 7u) & ~(size_t)7u;
}

/* Entries of a vertex cache for the largest model of a scene, a power of two, or as many as fit so
 * many bytes. */
uint32_t fxl_cache_entries(const fxl_scene *scene, size_t bytes);

#endif

/* SPDX-License-Identifier: MIT */
/* The clipper of the view, with statistics of what it worked out. Internal. */
#ifndef FXL_CLIP_STATS_H
#define FXL_CLIP_STATS_H

#include "fixel/stage/clip_view.h"

/* fxl_clip_view_to_planes; stats may be null. */
fxl_clip_result fxl_clip_view_by_planes(const fxl_view_polygon *in, const fxl_view_frustum *frustum,
                                        fxl_planes planes, fxl_clip_view_work *work,
                                        fxl_clip_stats *stats, const fxl_view_polygon **result);

/* A plane measured and cut: crossings are the vertices of the result that are new. */
static inline void fxl_clip_stats_add(fxl_clip_stats *stats, const fxl_q18_46 *distances,
                                      uint32_t measured, uint32_t left)
{
    if (stats != NULL) {
        stats->distances += measured;
        for (uint32_t i = 0; left > 0 && i < measured; i++) {
            left -= distances[i] >= 0;
        }
        stats->intersections += left;
    }
}

#endif

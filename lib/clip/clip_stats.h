/* SPDX-License-Identifier: MIT */
/* The clipper of the view, with counts of distances and intersections. Internal. */
#ifndef FXL_CLIP_STATS_H
#define FXL_CLIP_STATS_H

#include "fixel/stage/clip_view.h"

/* The same as fxl_clip_view_to_planes, and it counts in stats, which may be null. */
fxl_clip_result fxl_clip_view_by_planes(const fxl_view_polygon *in, const fxl_view_frustum *frustum,
                                        fxl_planes planes, fxl_clip_view_work *work,
                                        fxl_clip_stats *stats, const fxl_view_polygon **result);

/* Counts one plane. measured is the number of distances, result_count the number of vertices of
 * the result, 0 if the plane did not cut. The intersections are the vertices of the result that
 * are not inside vertices of the input. */
static inline void fxl_clip_stats_add(fxl_clip_stats *stats, const fxl_q18_46 *distances,
                                      uint32_t measured, uint32_t result_count)
{
    if (stats != NULL) {
        stats->distances += measured;
        for (uint32_t i = 0; result_count > 0 && i < measured; i++) {
            result_count -= distances[i] >= 0;
        }
        stats->intersections += result_count;
    }
}

#endif

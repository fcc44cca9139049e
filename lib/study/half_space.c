/* SPDX-License-Identifier: MIT */
#include "../clip/volume.h"
#include "half_space.h"

#include "clip_polygon.h"

/* clippers 1.1 */
fxl_clip_result fxl_clip_to_half_space(const fxl_varying_polygon *in, const fxl_half_space *plane,
                                       fxl_clip_stats *stats, fxl_varying_polygon *out,
                                       fxl_q18_46 *distances)
{
    stats->distances += in->count;
    for (uint32_t i = 0; i < in->count; i++) {
        distances[i] = fxl_half_space_distance(plane, &in->vertices[i].position);
    }
    return fxl_clip_polygon(in, distances, stats, out);
}

static void measure(const void *planes, int plane, const fxl_varying_polygon *polygon,
                    fxl_clip_stats *stats, fxl_q18_46 *distances)
{
    const fxl_volume *volume = (const fxl_volume *)planes;
    stats->distances += polygon->count;
    for (uint32_t i = 0; i < polygon->count; i++) {
        distances[i] =
            fxl_half_space_distance(&volume->planes[plane], &polygon->vertices[i].position);
    }
}

fxl_clip_result fxl_clip_polygon_by_volume(const fxl_varying_polygon *in, uint32_t any,
                                           const fxl_volume *volume, fxl_clip_workspace *workspace,
                                           const fxl_varying_polygon **result)
{
    return fxl_clip_polygon_by_planes(in, any, 0, measure, volume, workspace, result);
}

/* clippers 1.1 */
fxl_clip_result fxl_clip_to_volume(const fxl_varying_polygon *in, const fxl_volume *volume,
                                   fxl_clip_workspace *workspace,
                                   const fxl_varying_polygon **result)
{
    uint32_t any = 0, all = UINT32_MAX;
    for (uint32_t i = 0; i < in->count; i++) {
        uint32_t code = fxl_volume_code(volume, &in->vertices[i].position);
        any |= code;
        all &= code;
    }
    workspace->stats.distances += FXL_PLANE_COUNT * (uint32_t)in->count;
    return fxl_clip_polygon_by_planes(in, any, all, measure, volume, workspace, result);
}

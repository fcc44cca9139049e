/* SPDX-License-Identifier: MIT */
/* Polygons cut plane by plane: functions that the other clippers share. Internal. */
#ifndef FXL_CLIP_POLYGON_H
#define FXL_CLIP_POLYGON_H

#include "../clip/intersection.h"
#include "../clip/volume.h"
#include "normalised.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Clips a polygon to one plane, given the distances of its vertices (Sutherland and Hodgman). A
 * vertex at distance >= 0 is inside. out is written in the cases in which
 * fxl_clip_world_to_plane writes it. Requires distances below 2^63. */
fxl_clip_result fxl_clip_polygon(const fxl_varying_polygon *in, const fxl_q18_46 *distances,
                                 fxl_clip_stats *stats, fxl_varying_polygon *out);

/* Computes the distances of a polygon's vertices from one plane of a clipper. Counts them in
 * stats if they take products. */
typedef void (*fxl_measure)(const void *planes, int plane, const fxl_varying_polygon *polygon,
                            fxl_clip_stats *stats, fxl_q18_46 *distances);

/* Clips a polygon, in order, to the planes that one of its vertices lies outside of. any and all
 * are the OR and the AND of the vertices' outcodes; at most 31 planes. *result is the input
 * itself where no plane cut it, a polygon of workspace where one did, null where nothing is
 * left. */
fxl_clip_result fxl_clip_polygon_by_planes(const fxl_varying_polygon *in, uint32_t any,
                                           uint32_t all, fxl_measure measure, const void *planes,
                                           fxl_clip_workspace *workspace,
                                           const fxl_varying_polygon **result);

/* The same for the planes of each kind of volume, where the AND of the outcodes is 0. */
fxl_clip_result fxl_clip_polygon_by_normalised(const fxl_varying_polygon *in, uint32_t any,
                                               const fxl_normalised *frustum,
                                               fxl_clip_workspace *workspace,
                                               const fxl_varying_polygon **result);
fxl_clip_result fxl_clip_polygon_by_volume(const fxl_varying_polygon *in, uint32_t any,
                                           const fxl_volume *volume, fxl_clip_workspace *workspace,
                                           const fxl_varying_polygon **result);

/* Returns a bit for each vertex that counts as inside, by its distance and the sliver rule.
 * Requires count <= 32. */
uint32_t fxl_inside_bits(const fxl_q18_46 *distances, uint32_t count, fxl_q18_46 sliver);

#ifdef __cplusplus
}
#endif

#endif

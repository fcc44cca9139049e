/* SPDX-License-Identifier: MIT */
/* Clips polygons to half-spaces: one clipper for planes of the world and of the view, and for the
 * planes of a volume. Source: notes on homogeneous view volumes (D5), and C7. */
/* place clipper: only if it needs another part that clippers share */
#ifndef FXL_STUDY_HALF_SPACE_H
#define FXL_STUDY_HALF_SPACE_H

#include "../clip/volume.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Clips a polygon to one half-space, by the rules of fxl_clip_world_to_plane. Error of a new
 * vertex: that of fxl_clip_normalised. */
fxl_clip_result fxl_clip_to_half_space(const fxl_varying_polygon *in, const fxl_half_space *plane,
                                       fxl_clip_stats *stats, fxl_varying_polygon *out,
                                       fxl_q18_46 *distances);

/* Clips a polygon to a volume. Outcodes reject a polygon whose vertices are all outside one
 * plane, and accept one whose vertices are all inside all planes. Any other polygon is clipped,
 * in order, to the planes that a vertex lies outside of. In all else this is
 * fxl_clip_normalised. */
fxl_clip_result fxl_clip_to_volume(const fxl_varying_polygon *in, const fxl_volume *volume,
                                   fxl_clip_workspace *workspace,
                                   const fxl_varying_polygon **result);

#ifdef __cplusplus
}
#endif

#endif

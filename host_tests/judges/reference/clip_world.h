/* SPDX-License-Identifier: MIT */
/* Clipping in world space (docs/extras/clippers.md, section 5), in double. */
#ifndef REF_CLIP_WORLD_H
#define REF_CLIP_WORLD_H

#include "reference/cut.h"
#include "reference/frustum.h"

ref_clip_result ref_clip_world_to_plane(const ref_polygon *in, const ref_plane *plane,
                                        ref_polygon *out);
/* By the planes whose bit, 1 << REF_PLANE_..., is set. */
ref_clip_result ref_clip_world_to_planes(const ref_polygon *in, const ref_frustum *frustum,
                                         unsigned planes, ref_polygon *out);
ref_clip_result ref_clip_world_to_frustum(const ref_polygon *in, const ref_frustum *frustum,
                                          ref_polygon *out);

#endif

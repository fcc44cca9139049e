/* SPDX-License-Identifier: MIT */
/* The clipper in world space with statistics. Internal. */
#ifndef FXL_CLIP_WORLD_BY_PLANES_H
#define FXL_CLIP_WORLD_BY_PLANES_H

#include "clip_world.h"
#include "fixel/records.h"

/* Clips as fxl_clip_world_to_frustum does, but tests only the planes whose bit is set in planes,
 * and those of then, too, once one has cut: rounding may have put a new vertex outside of any
 * plane. stats may be null. */
fxl_clip_result fxl_clip_world_by_planes(const fxl_polygon *in, const fxl_frustum *frustum,
                                         unsigned planes, unsigned then, fxl_clip_world_work *work,
                                         fxl_clip_stats *stats, const fxl_polygon **result);

#endif

/* SPDX-License-Identifier: MIT */
/* The clipper of the world, with statistics of what it worked out. Internal. */
#ifndef FXL_CLIP_WORLD_BY_PLANES_H
#define FXL_CLIP_WORLD_BY_PLANES_H

#include "../../src/clip/clip_stats.h"
#include "fixel/extra/clippers/clip_world.h"

/* fxl_clip_world_to_frustum for a polygon none of whose vertices lies outside of a plane that
 * is not named in planes; stats may be null. */
fxl_clip_result fxl_clip_world_by_planes(const fxl_polygon *in, const fxl_frustum *frustum,
                                         unsigned planes, fxl_clip_world_work *work,
                                         fxl_clip_stats *stats, const fxl_polygon **result);

#endif

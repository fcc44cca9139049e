/* SPDX-License-Identifier: MIT */
/* Random input within the library's contract. The same seed gives the same input. */
#ifndef STAGES_RANDOM_H
#define STAGES_RANDOM_H

#include "draw/stages.h"
#include "fixel/all.h"

typedef struct {
    uint64_t state;
} stages_random;

/* Starts a stream. Each shard of a seed is a stream of its own. */
stages_random stages_random_start(uint64_t seed, uint64_t shard);

fxl_pose stages_random_pose(stages_random *random);
fxl_lens stages_random_lens(stages_random *random);

/* A third of these are off-centre, without an inset. */
fxl_lens stages_random_moved_lens(stages_random *random);

/* Makes a polygon near the visible part of the world: mostly flat and convex; one in eight is
 * any polygon. */
fxl_polygon stages_random_polygon(stages_random *random, const fxl_camera *camera);

/* Makes a point of the world: near the eye or far from it. */
fxl_point stages_random_point(stages_random *random, const fxl_point *eye);

/* Makes the radius of a model: any, or one for which the sphere about the point just reaches a
 * plane. */
fxl_q16_16 stages_random_radius(stages_random *random, const fxl_camera *camera,
                                const fxl_view_frustum *frustum, const fxl_point *centre);

/* Makes a view point, all of whose bits are random; mostly on the screen. */
fxl_view_point stages_random_view_point(stages_random *random, const fxl_lens *lens);

/* Makes an outline about a screen: large, small, on a grid of half pixels (ties), or thin. */
fxl_screen_polygon stages_random_outline(stages_random *random, int width, int height);

/* Returns 0 <= n < limit. */
uint32_t stages_random_below(stages_random *random, uint32_t limit);

#endif

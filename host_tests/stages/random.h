/* SPDX-License-Identifier: MIT */
/* Random input within the library's contract, the same for the same seed. */
#ifndef STAGES_RANDOM_H
#define STAGES_RANDOM_H

#include "fixel/all.h"

typedef struct {
    uint64_t state;
} stages_random;

/* Each shard of a seed is a stream of its own. */
stages_random stages_random_start(uint64_t seed, uint64_t shard);

fxl_pose stages_random_pose(stages_random *random);
fxl_lens stages_random_lens(stages_random *random);

/* A polygon near what the camera sees: mostly flat and convex, one in eight
 * any polygon at all. */
fxl_polygon stages_random_polygon(stages_random *random, const fxl_camera *camera);

/* A point of the world: near the eye or far from it. */
fxl_point stages_random_point(stages_random *random, const fxl_point *eye);

/* A radius of a model, any or so that its sphere about the point just reaches a
 * plane. */
fxl_q16_16 stages_random_radius(stages_random *random, const fxl_camera *camera,
                                const fxl_view_frustum *frustum, const fxl_point *centre);

/* A view point, every bit of it at random; mostly on the screen. */
fxl_view_point stages_random_view_point(stages_random *random, const fxl_lens *lens);

/* An outline about a screen: large, small, on a grid of half pixels (ties), or
 * thin. */
fxl_screen_polygon stages_random_outline(stages_random *random, int width, int height);

/* 0 <= n < limit. */
uint32_t stages_random_below(stages_random *random, uint32_t limit);

#endif

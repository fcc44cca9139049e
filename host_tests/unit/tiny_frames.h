/* SPDX-License-Identifier: MIT */
/* Frames of tiny.h's scene: renderers, placements, random poses about the cubes. */
#ifndef TINY_FRAMES_H
#define TINY_FRAMES_H

#include "tiny.h"

/* Checks the scene, and initialises a renderer of it with the tests' standard lens. */
void tiny_start(fxl_renderer *renderer, tiny_scene *tiny, uint16_t width, uint16_t height,
                const fxl_memory *memory);

/* Turns the instances from first on by placements that turn nothing; TINY_INSTANCES: none has a
 * placement. */
void tiny_place_from(tiny_scene *tiny, fxl_placement placements[TINY_INSTANCES], uint32_t first);

/* Between and beside the cubes, where many faces are cut; turned any way. */
fxl_pose tiny_pose_between(void);

/* Before, between and beside the cubes, and mostly turned to some of them. */
fxl_pose tiny_pose_about(void);

/* The three cubes are ahead, often one behind another. */
fxl_pose tiny_pose_before(void);

#endif

/* SPDX-License-Identifier: MIT */
/* How the walk on a board shares the display list's memory: firmware/walk/plan.c. In bytes,
 * multiples of 8, with records as an Armv6-M or Armv7-M has them. */
#ifndef PREDICT_SHARES_H
#define PREDICT_SHARES_H

#include <stdbool.h>

#include "fixel/scene.h"

/* place pixel-format: what is counted */
/* What motions, beams, surfaces, billboards and a palette of RGB565 take. */
uint32_t taken_bytes(const fxl_scene_image *image);

/* What the order by tree takes of so much; may be more. 0: the scene is drawn by distance. */
uint32_t tree_bytes(const fxl_scene_image *image, uint32_t room);

/* Whether a scene is drawn by its tree. */
bool draws_by_tree(const fxl_scene_image *image);

/* What a depth buffer takes of so much; may be more. 0: the scene is drawn without one. */
uint32_t depth_bytes(const fxl_scene_image *image, uint32_t room);

#endif

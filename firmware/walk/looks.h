/* SPDX-License-Identifier: MIT */
/* What a scene's faces look like beside their colours: beams, light at run time, surfaces. */
#ifndef WALK_LOOKS_H
#define WALK_LOOKS_H

#include "fixel/render.h"
#include "fixel/scene.h"

/* Bytes of memory that they want, a multiple of 8. */
uint32_t walk_looks_bytes(const fxl_scene_image *image);

/* Has a renderer draw them. With surfaces its visibility method becomes fxl_visibility_surfaces:
 * set another one after it. memory has walk_looks_bytes, aligned to 8, for as long as the program
 * runs. */
fxl_status walk_looks_open(const fxl_scene_image *image, fxl_renderer *renderer, uint8_t *memory);

#endif

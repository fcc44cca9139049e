/* SPDX-License-Identifier: MIT */
/* What a scene's faces look like beside their colours: beams, light at run time, surfaces. */
#ifndef WALK_LOOKS_H
#define WALK_LOOKS_H

#include "fixel/render.h"
#include "fixel/scene.h"
#include "fixel/surfaces.h"

/* Bytes of memory that they want, a multiple of 8. */
uint32_t walk_looks_bytes(const fxl_scene_image *image);

/* Has a renderer draw them, surfaces by a painter; where it is null, faces have their own colours.
 * memory has walk_looks_bytes, aligned to 8, for as long as the program runs. */
fxl_status walk_looks_open(const fxl_scene_image *image, const fxl_painter *painter,
                           fxl_renderer *renderer, uint8_t *memory);

#endif

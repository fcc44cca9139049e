/* SPDX-License-Identifier: MIT */
/* A scene's surfaces, on a board that draws them: `make run VISIBILITY=`. */
#ifndef WALK_SURFACES_H
#define WALK_SURFACES_H

#include "fixel/render.h"
#include "fixel/scene.h"
#include "fixel/surfaces.h"

/* Bytes of memory that they want, a multiple of 8; 0 where the board draws none. */
uint32_t walk_surface_bytes(const fxl_scene_surfaces *surfaces);

/* Has a renderer draw them by a painter, lit by its light if it has one. memory has
 * walk_surface_bytes, aligned to 8, for as long as the program runs. */
fxl_status walk_surfaces_open(const fxl_scene_image *image, const fxl_painter *painter,
                              fxl_renderer *renderer, uint8_t *memory);

#endif

/* SPDX-License-Identifier: MIT */
/* A scene's surfaces, on a board that draws them: `make run VISIBILITY=`. */
#ifndef WALK_SURFACES_H
#define WALK_SURFACES_H

#include "fixel/light.h"
#include "fixel/render.h"
#include "fixel/scene.h"

/* Bytes of memory that they want, a multiple of 8; 0 where the board draws none. */
uint32_t walk_surface_bytes(const fxl_scene_surfaces *surfaces);

/* Has a renderer draw them, lit by light if it is not null. memory has walk_surface_bytes, aligned
 * to 8, for as long as the program runs. */
fxl_status walk_surfaces_open(const fxl_scene_image *image, fxl_renderer *renderer, uint8_t *memory,
                              const fxl_light *light);

#endif

/* SPDX-License-Identifier: MIT */
/* The billboards of a scene. */
#ifndef WALK_BILLBOARDS_H
#define WALK_BILLBOARDS_H

#include "fixel/billboards.h"
#include "fixel/render.h"
#include "fixel/scene.h"

/* Bytes of memory that they want, a multiple of 8. */
uint32_t walk_billboards_bytes(const fxl_scene_image *image);

/* Has a renderer draw them by a painter. memory has walk_billboards_bytes, aligned to 8, for as long
 * as the program runs. FXL_E_COMBINATION: the painter is null, which is said. */
fxl_status walk_billboards_open(const fxl_scene_image *image, const fxl_sprite_painter *painter,
                                fxl_renderer *renderer, uint8_t *memory);

#endif

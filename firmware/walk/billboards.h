/* SPDX-License-Identifier: MIT */
/* The billboards of a scene. */
#ifndef WALK_BILLBOARDS_H
#define WALK_BILLBOARDS_H

#include "fixel/render.h"
#include "fixel/scene.h"

/* Bytes of memory that they want, a multiple of 8. */
uint32_t walk_billboards_bytes(const fxl_scene_image *image);

/* Has a renderer draw them, after its methods were set. memory has walk_billboards_bytes, aligned
 * to 8, for as long as the program runs. FXL_E_ORDER: the visibility method draws none,
 * which is said. */
fxl_status walk_billboards_open(const fxl_scene_image *image, fxl_renderer *renderer,
                                uint8_t *memory);

#endif

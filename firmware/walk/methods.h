/* SPDX-License-Identifier: MIT */
/* The clipper and the visibility method that the walk draws with. They are chosen when it is
 * built: `make run CLIPPER= VISIBILITY=`. */
#ifndef WALK_METHODS_H
#define WALK_METHODS_H

#include "fixel/billboards.h"
#include "fixel/render.h"
#include "fixel/scene.h"

/* What the methods want of memory, in bytes, each a multiple of 8. */
typedef struct {
    const fxl_clipper *clipper;
    const fxl_visibility *visibility;
    uint32_t clipper_bytes;
    uint32_t visibility_bytes; /* what it needs at least, and more where more saves time */
    uint32_t piece_bytes;      /* for the pieces of instances that move among a BSP tree */
} walk_methods;

/* Chooses the methods for a scene, where the board has set room bytes aside for them. Without
 * VISIBILITY=, a scene that asks for a depth buffer is drawn with one, another that has a BSP tree
 * by it, and any other by distance, with its surfaces if it has some. What the methods want may be
 * more than room: then they don't fit. False if the scene wants a tree, surfaces, billboards or a
 * depth buffer, and the board has too little memory for it: it sets WALK_WITHOUT_BSP,
 * WALK_WITHOUT_SURFACES, WALK_WITHOUT_BILLBOARDS or WALK_WITHOUT_DEPTH. */
bool walk_methods_choose(walk_methods *methods, const fxl_scene_image *image, uint32_t room);

/* Bytes that the methods want together. */
uint32_t walk_methods_bytes(const walk_methods *methods);

/* Sets a renderer's methods; memory has walk_methods_bytes, aligned to 8. */
fxl_status walk_methods_set(const walk_methods *methods, fxl_renderer *renderer, uint8_t *memory);

/* Has the renderer, whose methods are set, draw billboards too. FXL_E_ORDER: its visibility method
 * draws none. */
fxl_status walk_methods_add_billboards(fxl_renderer *renderer, fxl_billboards *billboards,
                                       const fxl_billboard_set *set);

/* How many instances of the last frame were drawn in a wrong order, because the memory for their
 * pieces was too small. */
uint32_t walk_methods_unsplit(const walk_methods *methods, const fxl_renderer *renderer);

#endif

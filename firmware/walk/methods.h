/* SPDX-License-Identifier: MIT */
/* The clipper, the order and the target that the walk draws with: what the scene asks for, or what
 * was chosen when the walk was built, by `make run CLIPPER= VISIBILITY=`. */
#ifndef WALK_METHODS_H
#define WALK_METHODS_H

#include "fixel/billboards.h"
#include "fixel/render.h"
#include "fixel/scene.h"
#include "fixel/surfaces.h"

/* A target, and what draws surfaces and billboards into it; null: nothing does. */
typedef struct {
    const fxl_target *target;
    const fxl_painter *surfaces;
    const fxl_sprite_painter *sprites;
} walk_target;

/* Those that the program links. */
extern const walk_target walk_targets[];
extern const uint32_t walk_target_count;

/* Whether it links one with so many bits a pixel and in its depth buffer, 0 for none. */
bool walk_methods_draw(uint8_t pixel_bits, uint8_t depth_bits);

/* Bits of the depth buffer that a scene is drawn with, 0 for none: those of `make run DEPTH=`, or what it asks for. */
uint8_t walk_methods_depth_bits(const fxl_scene_image *image);

typedef struct {
    const fxl_clipper *clipper;
    const fxl_order *order;
    walk_target draws;
} walk_methods;

/* Chooses the methods for a scene. A scene is drawn with the target that it asks for; by its BSP tree
 * if it has one, unless it asks for the order by distance. False if the scene wants a tree, surfaces,
 * billboards, lines, a horizon, a depth buffer, RGB565 or an orthographic lens, and the board has too little
 * memory for it: it sets WALK_WITHOUT_ORTHOGRAPHIC, WALK_WITHOUT_BSP, WALK_WITHOUT_SURFACES,
 * WALK_WITHOUT_BILLBOARDS, WALK_WITHOUT_LINES, WALK_WITHOUT_HORIZON, WALK_WITHOUT_DEPTH,
 * WALK_WITHOUT_DEPTH_32 (16 bits alone), WALK_WITHOUT_RGB565 or WALK_WITHOUT_RGB565_DEPTH (RGB565
 * without a depth buffer alone). */
bool walk_methods_choose(walk_methods *methods, const fxl_scene_image *image);

/* How many instances of the last frame were drawn in a wrong order, because the memory for their
 * pieces was too small. */
uint32_t walk_methods_unsplit(const fxl_renderer *renderer);

#endif

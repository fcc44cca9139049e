/* SPDX-License-Identifier: MIT */
/* A scene image as a record of fixel/setup.h: one set-up for exported scenes and for images. */
#ifndef WALK_PLAN_H
#define WALK_PLAN_H

#include "fixel/setup.h"
#include "methods.h"

/* Bytes of the block before the setup's shares, each a multiple of 8. */
typedef struct {
    uint32_t palette; /* of RGB565 */
    uint32_t surfaces, billboards;
    uint32_t clipper;
    uint32_t target; /* memory of a target that has no depth buffer */
} walk_shares;

/* What a scene image is set up with. Nothing of it is read after the set-up. */
typedef struct {
    const fxl_scene_image *image;
    const walk_methods *methods;
    fxl_memory tables;  /* of the renderer; without a display list it gets what the block leaves */
    uint32_t list_most; /* bytes of such a list */
    uint16_t rows;      /* of the depth buffer; 0: one, and as many more as half of what is left holds */
    uint8_t *block;     /* aligned to 8 bytes, for as long as the setup */
    uint32_t size;      /* bytes of it, a multiple of 8 */
    uint32_t needed;    /* written: bytes that the scene and the methods need of it */
    uint32_t used;      /* written: bytes of it that are no display list */
    uint32_t entries;   /* written: of the draw list, that are needed */
    walk_shares taken;  /* this and the rest are internal */
    const fxl_scene *scene;
    uint8_t *clipper_memory;
    fxl_config config;
    fxl_light_settings light;
} walk_plan;

/* Fills *plan from the image and sets it up; members that are not set in *of are zeros. The lens is the image's own. Surfaces and billboards are drawn where
 * the methods have painters for them. *plan is all zeros but for another scene than the image's, or its
 * motions: the act's.
 * FXL_E_CAPACITY: with of->needed above of->size the block is too small, else the draw list.
 * Any other status is that of fxl_setup_init, or of what opens surfaces and billboards. */
fxl_status walk_plan_open(walk_plan *of, fxl_setup_plan *plan, fxl_setup *setup);

#endif

/* SPDX-License-Identifier: MIT */
/* The target that was chosen when the walk was built, or those that a scene may ask for. A program links
 * these and no others. */
#include "methods.h"

#include "fixel/all.h"
#include "study/study.h"

#if defined WALK_WITHOUT_SURFACES && !defined WALK_SURFACES
#define SURFACES(painter) NULL
#else
#define SURFACES(painter) (painter)
#endif
#if defined WALK_WITHOUT_BILLBOARDS
#define SPRITES(painter) NULL
#else
#define SPRITES(painter) (painter)
#endif

const walk_target walk_targets[] = {
#if defined WALK_STUDY
    {&WALK_TARGET, NULL, NULL},
#elif defined WALK_FLAT
    {&fxl_palette, NULL, SPRITES(FXL_SPRITES_OF(fxl_palette))},
#elif defined WALK_PALETTE
    {&fxl_palette, SURFACES(FXL_SURFACES_OF(fxl_palette)), SPRITES(FXL_SPRITES_OF(fxl_palette))},
#elif defined WALK_DEPTH_16
    {&fxl_palette_depth_16, FXL_SURFACES_OF(fxl_palette_depth_16),
     SPRITES(FXL_SPRITES_OF(fxl_palette_depth_16))},
#elif defined WALK_DEPTH_32
    {&fxl_palette_depth_32, FXL_SURFACES_OF(fxl_palette_depth_32),
     SPRITES(FXL_SPRITES_OF(fxl_palette_depth_32))},
#else
    {&fxl_palette, SURFACES(FXL_SURFACES_OF(fxl_palette)), SPRITES(FXL_SPRITES_OF(fxl_palette))},
#if !defined WALK_WITHOUT_DEPTH
    {&fxl_palette_depth_16, SURFACES(FXL_SURFACES_OF(fxl_palette_depth_16)),
     SPRITES(FXL_SPRITES_OF(fxl_palette_depth_16))},
#endif
#if !defined WALK_WITHOUT_DEPTH && !defined WALK_WITHOUT_DEPTH_32
    {&fxl_palette_depth_32, SURFACES(FXL_SURFACES_OF(fxl_palette_depth_32)),
     SPRITES(FXL_SPRITES_OF(fxl_palette_depth_32))},
#endif
#if !defined WALK_WITHOUT_DEPTH && !defined WALK_WITHOUT_RGB565
    {&fxl_rgb565_depth_16, SURFACES(FXL_SURFACES_OF(fxl_rgb565_depth_16)),
     SPRITES(FXL_SPRITES_OF(fxl_rgb565_depth_16))},
#endif
#if !defined WALK_WITHOUT_DEPTH && !defined WALK_WITHOUT_DEPTH_32 && !defined WALK_WITHOUT_RGB565
    {&fxl_rgb565_depth_32, SURFACES(FXL_SURFACES_OF(fxl_rgb565_depth_32)),
     SPRITES(FXL_SPRITES_OF(fxl_rgb565_depth_32))},
#endif
#if !defined WALK_WITHOUT_RGB565
    {&fxl_rgb565, SURFACES(FXL_SURFACES_OF(fxl_rgb565)), SPRITES(FXL_SPRITES_OF(fxl_rgb565))},
#endif
#endif
};

const uint32_t walk_target_count = sizeof walk_targets / sizeof *walk_targets;

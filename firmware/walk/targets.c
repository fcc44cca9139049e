/* SPDX-License-Identifier: MIT */
/* The targets that a scene may ask for, of the depth that was chosen when the walk was built if one was; or the
 * study's target. A program links these and no others. */
#include "methods.h"

#include "fixel/all.h"
#include "study/study.h"

/* The depths that are linked. */
#if defined WALK_DEPTH_BITS
#define HAS_DEPTH_0  (WALK_DEPTH_BITS == 0)
#define HAS_DEPTH_16 (WALK_DEPTH_BITS == 16)
#define HAS_DEPTH_32 (WALK_DEPTH_BITS == 32)
#else
#define HAS_DEPTH_0 1
#if defined WALK_WITHOUT_DEPTH
#define HAS_DEPTH_16 0
#define HAS_DEPTH_32 0
#elif defined WALK_WITHOUT_DEPTH_32
#define HAS_DEPTH_16 1
#define HAS_DEPTH_32 0
#else
#define HAS_DEPTH_16 1
#define HAS_DEPTH_32 1
#endif
#endif

/* place pixel-format: the targets of the program: those of a new format stand behind the conditions of RGB565 */
#if defined WALK_WITHOUT_RGB565 || defined WALK_WITHOUT_RGB565_DEPTH
#define HAS_RGB565_DEPTH 0
#else
#define HAS_RGB565_DEPTH 1
#endif

#if defined WALK_FLAT || (defined WALK_WITHOUT_SURFACES && !defined WALK_SURFACES)
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
#if defined WALK_TARGET
    {&WALK_TARGET, NULL, NULL},
#else
#if HAS_DEPTH_0
    {&fxl_palette, SURFACES(FXL_SURFACES_OF(fxl_palette)), SPRITES(FXL_SPRITES_OF(fxl_palette))},
#endif
#if HAS_DEPTH_16
    {&fxl_palette_depth_16, SURFACES(FXL_SURFACES_OF(fxl_palette_depth_16)),
     SPRITES(FXL_SPRITES_OF(fxl_palette_depth_16))},
#endif
#if HAS_DEPTH_32
    {&fxl_palette_depth_32, SURFACES(FXL_SURFACES_OF(fxl_palette_depth_32)),
     SPRITES(FXL_SPRITES_OF(fxl_palette_depth_32))},
#endif
#if HAS_DEPTH_16 && HAS_RGB565_DEPTH
    {&fxl_rgb565_depth_16, SURFACES(FXL_SURFACES_OF(fxl_rgb565_depth_16)),
     SPRITES(FXL_SPRITES_OF(fxl_rgb565_depth_16))},
#endif
#if HAS_DEPTH_32 && HAS_RGB565_DEPTH
    {&fxl_rgb565_depth_32, SURFACES(FXL_SURFACES_OF(fxl_rgb565_depth_32)),
     SPRITES(FXL_SPRITES_OF(fxl_rgb565_depth_32))},
#endif
#if HAS_DEPTH_0 && !defined WALK_WITHOUT_RGB565
    {&fxl_rgb565, SURFACES(FXL_SURFACES_OF(fxl_rgb565)), SPRITES(FXL_SPRITES_OF(fxl_rgb565))},
#endif
#endif
};

const uint32_t walk_target_count = sizeof walk_targets / sizeof *walk_targets;

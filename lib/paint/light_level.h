/* SPDX-License-Identifier: MIT */
/* The brightness of a face. Internal. */
#ifndef FXL_LIGHT_LEVEL_H
#define FXL_LIGHT_LEVEL_H

#include "fixel/light.h"

/* A face in the world. */
typedef struct {
    fxl_direction normal; /* of unit length, to within 2^-27 */
    fxl_point middle;     /* of its bounding box, doubled: in units of 2^-17, each below 2^30 + 2 */
} fxl_lit_place;

/* The brightness of a face, in 2.30, 0..1. Requires settings that were checked, and a camera.
 * Error: below FXL_LIGHT_ERROR_MAX. */
fxl_q2_30 fxl_light_brightness(const fxl_light_settings *settings, const fxl_camera *camera,
                               const fxl_lit_place *place);

/* The level of a brightness: the nearest, halves upward. Exact. */
static inline uint32_t fxl_light_level(fxl_q2_30 brightness, uint32_t levels)
{
    /* Below 2^6 * 2^30. */
    return (uint32_t)(((uint64_t)(uint32_t)brightness * (levels - 1) + (1u << 29)) >> 30);
}

#endif

/* SPDX-License-Identifier: MIT */
/* The brightness of a face. Internal. */
#ifndef FXL_LIGHT_LEVEL_H
#define FXL_LIGHT_LEVEL_H

#include "../math/core.h"
#include "fixel/light.h"
#include "fixel/surfaces.h"

#ifdef __cplusplus
extern "C" {
#endif

/* A face in the world. */
typedef struct {
    fxl_direction normal; /* of unit length, to within 2^-27 */
    fxl_point middle;     /* of its bounding box, doubled: in units of 2^-17, each below 2^30 + 2 */
} fxl_lit_place;

/* place light: the brightness; from it a level of the ramp, or in RGB565 a part */
/* The brightness of a face, in 2.30, 0..1. Requires settings that were checked, and a camera.
 * Error: below FXL_LIGHT_ERROR_MAX. */
fxl_q2_30 fxl_light_brightness(const fxl_light_settings *settings, const fxl_camera *camera,
                               const fxl_lit_place *place);

/* The light of three corners, without points and fog, of which `place` would be needed for more
 * than its normal: fxl_light_corner_level of the normals that the corners number. It is
 * a kernel: Armv7-M has its own. */
typedef void fxl_corners_light(const fxl_light_settings *settings, const fxl_direction *normals,
                               const fxl_corner *const corners[3], int32_t values[3]);
fxl_corners_light fxl_light_corners_of;

/* Light that was found, by the numbers of normals: of those that are equal modulo FXL_LIGHTS_KEPT the last
 * one. The word of a normal is its number in the upper half and, exclusive or, its light, which is
 * below 2^22: at the number's place it gives the number's bits from 23 on, and light. */
#define FXL_LIGHTS_KEPT 128u

typedef struct {
    uint32_t words[FXL_LIGHTS_KEPT];
} fxl_kept_lights;

/* Sets that no light is kept: bit 22 of each word is not that of the normals of its place. */
static inline void fxl_kept_lights_begin(fxl_kept_lights *kept)
{
    uint32_t *const upper = kept->words + FXL_LIGHTS_KEPT / 2;
    for (uint32_t *word = kept->words; word != upper; word += 4) {
        uint32_t *other = word + FXL_LIGHTS_KEPT / 2;
        word[0] = word[1] = word[2] = word[3] = UINT32_MAX;
        other[0] = other[1] = other[2] = other[3] = 0;
        FXL_IN_ORDER(); /* so that it is no call */
    }
}

/* The light of a normal of lit surfaces, which is then kept in its word. Requires what fxl_light_corners_of does. */
int32_t fxl_kept_light_find(const fxl_surfaces *surfaces, uint32_t number, uint32_t *word);
typedef int32_t fxl_kept_light_finder(const fxl_surfaces *surfaces, uint32_t number,
                                      uint32_t *word);

/* The same, where it may be kept. finder: fxl_kept_light_find. */
static inline int32_t fxl_kept_light(const fxl_surfaces *surfaces, uint32_t number,
                                     fxl_kept_lights *kept, fxl_kept_light_finder *finder)
{
    uint32_t *word = &kept->words[number % FXL_LIGHTS_KEPT];
    const uint32_t light = *word ^ number << 16;
    return light >> 22 == 0 ? (int32_t)light : finder(surfaces, number, word);
}

/* A brightness as levels of the ramp in 16.16, and a half. The product is at most 2^30 * 63 * 2^18,
 * and half a unit. Error: half a unit of 1/65536 level, and FXL_LIGHT_ERROR_MAX of the brightness,
 * which is at most 0.7 of that unit. */
/* surfaces 5.2, 5.3 */
static inline int32_t fxl_light_corner_level(fxl_q2_30 brightness, uint32_t levels_less_1)
{
    const uint64_t product = fxl_multiply_u32((uint32_t)brightness, levels_less_1 << 18);
    return (int32_t)(uint32_t)((product + (((uint64_t)32768u << 32) + ((uint64_t)1 << 31))) >> 32);
}

/* The level of a brightness: the nearest, halves upward. Exact. */
/* light 2.5 */
static inline uint32_t fxl_light_level(fxl_q2_30 brightness, uint32_t levels)
{
    /* Below 2^6 * 2^30. */
    return (uint32_t)(((uint64_t)(uint32_t)brightness * (levels - 1) + (1u << 29)) >> 30);
}

/* How many of 256 parts light takes of a colour: 256 less 256 times a brightness, rounded to
 * nearest. No light is 255: the one part that is left changes no channel, which has at most 63
 * steps. Error of the part: half of 1/256, and FXL_LIGHT_ERROR_MAX of the brightness. */
static inline uint8_t fxl_light_shade(fxl_q2_30 brightness)
{
    const uint32_t part = ((uint32_t)brightness + (1u << 21)) >> 22;
    return (uint8_t)(part == 0 ? 255u : 256u - part);
}

#ifdef __cplusplus
}
#endif

#endif

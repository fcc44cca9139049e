/* SPDX-License-Identifier: MIT */
#include "paint/light_level.c"
#include "proof.h"

/* [[row]]
 * function = "fxl_light_corners_of"
 * property = "any checked settings and normals: nothing overflows or is out of bounds"
 * checks = 200
 */
void prove_light_corners_of(void)
{
    fxl_light_settings settings;
    fxl_direction normals[3];
    fxl_corner any[3];
    const fxl_corner *const corners[3] = {&any[0], &any[1], &any[2]};
    int32_t values[3];
    ASSUME(settings.levels >= FXL_LIGHT_LEVELS_MIN && settings.levels <= FXL_LIGHT_LEVELS_MAX);
    ASSUME(settings.ambient >= 0 && settings.ambient <= FXL_Q2_30_ONE && settings.strength >= 0 && settings.strength <= FXL_Q2_30_ONE);
    ASSUME(WITHIN(settings.direction.x, FXL_Q2_30_ONE + 4) && WITHIN(settings.direction.y, FXL_Q2_30_ONE + 4) &&
           WITHIN(settings.direction.z, FXL_Q2_30_ONE + 4));
    for (int i = 0; i < 3; i++) {
        ASSUME(any[i].normal < 3 && WITHIN(normals[i].x, FXL_Q2_30_ONE + 8) && WITHIN(normals[i].y, FXL_Q2_30_ONE + 8) &&
               WITHIN(normals[i].z, FXL_Q2_30_ONE + 8));
    }
    fxl_light_corners_of(&settings, normals, corners, values);
    PROOF_ENDS();
}

/* [[row]]
 * function = "lib/paint/light_level.h:fxl_light_corner_level"
 * property = "any brightness from 0 to 1: a level of the ramp"
 * checks = 5
 */
void prove_light_corner_level(void)
{
    const fxl_q2_30 brightness = nondet_s32();
    const uint32_t levels_less_1 = nondet_u32();
    ASSUME(brightness >= 0 && brightness <= FXL_Q2_30_ONE && levels_less_1 < FXL_LIGHT_LEVELS_MAX);
    const int32_t level = fxl_light_corner_level(brightness, levels_less_1);
    ASSERT("a level of the ramp", level >= 32768 && (uint32_t)level >> 16 <= levels_less_1);
    PROOF_ENDS();
}

/* [[row]]
 * function = "lib/paint/light_level.h:fxl_light_level"
 * property = "any brightness from 0 to 1: a level of the ramp"
 * checks = 3
 */
void prove_light_level(void)
{
    const fxl_q2_30 brightness = nondet_s32();
    const uint32_t levels = nondet_u32();
    ASSUME(brightness >= 0 && brightness <= FXL_Q2_30_ONE && levels >= FXL_LIGHT_LEVELS_MIN && levels <= FXL_LIGHT_LEVELS_MAX);
    ASSERT("a level of the ramp", fxl_light_level(brightness, levels) < levels);
    PROOF_ENDS();
}

/* [[row]]
 * function = "lib/paint/light_level.h:fxl_light_shade"
 * property = "any brightness from 0 to 1: nothing overflows, and 1 leaves all of a colour"
 * checks = 3
 */
void prove_light_shade(void)
{
    const fxl_q2_30 brightness = nondet_s32();
    ASSUME(brightness >= 0 && brightness <= FXL_Q2_30_ONE);
    ASSERT("all of it is left at 1", brightness != FXL_Q2_30_ONE || fxl_light_shade(brightness) == 0);
    PROOF_ENDS();
}

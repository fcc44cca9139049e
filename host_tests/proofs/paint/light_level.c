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

static uint32_t found;

static int32_t find_any(const fxl_surfaces *surfaces, uint32_t number, uint32_t *word)
{
    const int32_t light = nondet_s32();
    (void)surfaces;
    ASSUME(light >= 32768 && light <= (FXL_LIGHT_LEVELS_MAX << 16) - 32768);
    found++;
    *word = (uint32_t)light ^ number << 16;
    return light;
}

/* [[row]]
 * function = "lib/paint/light_level.h:fxl_kept_light"
 * property = "any two normals after fxl_kept_lights_begin: light is found once, and again after that of another one in its place"
 * checks = 20
 * unwind = 18
 */
void prove_kept_light(void)
{
    fxl_kept_lights kept;
    const uint32_t a = nondet_u32(), b = nondet_u32();
    ASSUME(a <= UINT16_MAX && b <= UINT16_MAX);
    found = 0;
    fxl_kept_lights_begin(&kept);
    const int32_t light = fxl_kept_light(NULL, a, &kept, find_any);
    ASSERT("none is kept at first", found == 1);
    const int32_t other = fxl_kept_light(NULL, b, &kept, find_any);
    ASSERT("of each normal its own", a == b ? found == 1 && other == light : found == 2);
    const int32_t again = fxl_kept_light(NULL, a, &kept, find_any);
    ASSERT("kept, or found anew", (a != b && a % FXL_LIGHTS_KEPT == b % FXL_LIGHTS_KEPT) ? found == 3 : again == light && found <= 2);
    PROOF_ENDS();
}

/* [[row]]
 * function = "fxl_kept_light_find"
 * property = "any checked settings and normal: nothing overflows, and the word is that of the normal and its light"
 * checks = 150
 */
void prove_kept_light_find(void)
{
    fxl_surfaces surfaces;
    fxl_surface_set set;
    fxl_light lit;
    fxl_direction normals[3];
    const uint32_t number = nondet_u32();
    uint32_t word;
    surfaces.set = &set;
    surfaces.light = &lit;
    set.normals = normals;
    fxl_light_settings *settings = &lit.settings;
    ASSUME(settings->levels >= FXL_LIGHT_LEVELS_MIN && settings->levels <= FXL_LIGHT_LEVELS_MAX);
    ASSUME(settings->ambient >= 0 && settings->ambient <= FXL_Q2_30_ONE && settings->strength >= 0 && settings->strength <= FXL_Q2_30_ONE);
    ASSUME(WITHIN(settings->direction.x, FXL_Q2_30_ONE + 4) && WITHIN(settings->direction.y, FXL_Q2_30_ONE + 4) &&
           WITHIN(settings->direction.z, FXL_Q2_30_ONE + 4));
    ASSUME(number < 3 && WITHIN(normals[number].x, FXL_Q2_30_ONE + 8) && WITHIN(normals[number].y, FXL_Q2_30_ONE + 8) &&
           WITHIN(normals[number].z, FXL_Q2_30_ONE + 8));
    const int32_t light = fxl_kept_light_find(&surfaces, number, &word);
    ASSERT("a level of the ramp", light >= 32768 && (uint32_t)light >> 16 < settings->levels);
    ASSERT("the word gives it", (word ^ number << 16) == (uint32_t)light);
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

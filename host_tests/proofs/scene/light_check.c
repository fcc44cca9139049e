/* SPDX-License-Identifier: MIT */
#include "scene/image_check.c"
#include "proof.h"

/* [[row]]
 * function = "fxl_light_check"
 * property = "any settings, or null: nothing overflows or is out of bounds, and of checked settings counts, ambient light, strength and fog are in range"
 * checks = 225
 * uses = ["fxl_is_unit", "fxl_point_in_range"]
 */
void prove_light_check(void)
{
    fxl_light_settings settings;
    fxl_scene_fault fault;
    const fxl_light_settings *given = nondet_bool() ? NULL : &settings;
    const fxl_status status = fxl_light_check(given, nondet_bool() ? NULL : &fault);
    ASSERT("checked, there are settings", status != FXL_OK || given != NULL);
    ASSERT("checked, its counts are in range", status != FXL_OK || (settings.point_count <= FXL_LIGHT_POINTS_MAX && settings.levels >= FXL_LIGHT_LEVELS_MIN &&
                                                                   settings.levels <= FXL_LIGHT_LEVELS_MAX));
    ASSERT("and its fractions", status != FXL_OK || (settings.ambient >= 0 && settings.ambient <= FXL_Q2_30_ONE && settings.strength >= 0 &&
                                                     settings.strength <= FXL_Q2_30_ONE));
    ASSERT("and its fog", status != FXL_OK || (settings.fog_near >= 0 && settings.fog_near <= settings.fog_far && settings.fog_far <= FXL_FAR_MAX));
    PROOF_ENDS();
}

/* [[row]]
 * function = "fxl_light_settings_of"
 * property = "any light of up to 4 points: nothing is out of bounds, and the settings are the light's"
 * checks = 154
 */
void prove_light_settings_of(void)
{
    fxl_light_base base;
    fxl_point_light points[FXL_LIGHT_POINTS_MAX];
    fxl_scene_light light;
    fxl_light_settings settings;
    light.base = &base;
    light.points = points;
    ASSUME(light.point_count <= FXL_LIGHT_POINTS_MAX);
    const uint32_t number = nondet_u32();
    ASSUME(number < FXL_LIGHT_POINTS_MAX);
    fxl_light_settings_of(&light, &settings);
    ASSERT("its points, in their order", number >= light.point_count || settings.points[number].range == points[number].range);
    ASSERT("what the light has", settings.point_count == light.point_count && settings.levels == light.levels && settings.ramp == light.ramp &&
                                     settings.ambient == base.ambient && settings.fog_far == base.fog_far);
    PROOF_ENDS();
}

/* SPDX-License-Identifier: MIT */
/* The settings of a light: those of a scene image, and the check of all. */
#include "../math/arith.h"
#include "../math/memory.h"
#include "../math/plane.h"
#include "scene_check.h"

static bool is_fraction(fxl_q2_30 value)
{
    return value >= 0 && value <= FXL_Q2_30_ONE;
}

/* place light: a new setting: its check */
/* formats 1.11 */
static bool is_fog(const fxl_light_settings *settings)
{
    return (settings->fog_near == 0 && settings->fog_far == 0) ||
           (settings->fog_near >= 0 && settings->fog_near < settings->fog_far &&
            settings->fog_far <= FXL_FAR_MAX);
}

/* formats 1.11 */
static bool is_point_light(const fxl_point_light *light)
{
    return fxl_point_in_range(&light->position) && light->range >= 1 &&
           light->range <= FXL_COORDINATE_MAX && is_fraction(light->strength);
}

/* place field: the check of light's values */
/* formats 1.11 */
fxl_status fxl_light_check(const fxl_light_settings *settings, fxl_scene_fault *fault)
{
    if (settings == NULL) {
        return fxl_fault_at(fault, "light", 0, FXL_E_ARGUMENT);
    }
    if (settings->point_count > FXL_LIGHT_POINTS_MAX || settings->levels < FXL_LIGHT_LEVELS_MIN ||
        settings->levels > FXL_LIGHT_LEVELS_MAX) {
        return fxl_fault_at(fault, "light", 0, FXL_E_COUNT);
    }
    if (!is_fraction(settings->ambient) || !is_fraction(settings->strength) || !is_fog(settings)) {
        return fxl_fault_at(fault, "light", 0, FXL_E_RANGE);
    }
    for (uint32_t i = 0; i < settings->point_count; i++) {
        if (!is_point_light(&settings->points[i])) {
            return fxl_fault_at(fault, "point light", i, FXL_E_RANGE);
        }
    }
    return settings->strength == 0 || fxl_is_unit(&settings->direction)
               ? FXL_OK
               : fxl_fault_at(fault, "light", 0, FXL_E_NORMAL);
}

/* formats 1.11 */
void fxl_light_settings_of(const fxl_scene_light *light, fxl_light_settings *settings)
{
    const fxl_light_base *base = light->base;
    memset(settings, 0, sizeof *settings);
    settings->ambient = base->ambient;
    settings->strength = base->strength;
    settings->direction = base->direction;
    settings->point_count = light->point_count;
    for (uint32_t i = 0; i < light->point_count; i++) {
        settings->points[i] = light->points[i];
    }
    settings->fog_near = base->fog_near;
    settings->fog_far = base->fog_far;
    settings->ramp = light->ramp;
    settings->levels = light->levels;
    settings->dark = light->dark;
}

/* SPDX-License-Identifier: MIT */
#include "scene/placement_code.h"
#include "scene_tables.h"

static fxl_placement placements[INSTANCES];
static uint32_t asked; /* the number that the code of turned instances got */
static fxl_q16_16 any_radius(const fxl_scene *of, uint32_t number)
{
    ASSERT("a turned instance", of == &scene && number >= scene.first_turned && number < scene.instance_count);
    asked = number;
    return nondet_s32();
}

/* [[row]]
 * function = "fxl_instance_radius"
 * property = "any instance of a checked scene, turned or not: its placement's, or its model's, which is in its range"
 * checks = 312
 * unwind = 8
 */
void prove_instance_radius(void)
{
    static const fxl_placement_code code = {.radius = any_radius};
    const uint32_t number = nondet_u32();
    any_checked_scene();
    scene.placements = nondet_bool() ? placements : NULL;
    scene.placement_code = &code;
    asked = INSTANCES;
    ASSUME(number < scene.instance_count && scene.first_turned <= scene.instance_count);
    const bool turned = scene.placements != NULL && number >= scene.first_turned;
    const fxl_q16_16 radius = fxl_instance_radius(&scene, &instances[number]);
    ASSERT("a turned one's is that of its placement", asked == (turned ? number : INSTANCES));
    ASSERT("another's is its model's, in its range", turned || (radius == models[instances[number].model].radius && radius >= 0 && radius <= FXL_RADIUS_MAX));
    PROOF_ENDS();
}

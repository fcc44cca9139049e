/* SPDX-License-Identifier: MIT */
#include "scene/placement_code.h"
#include "scene/scene_check.c"
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
 * property = "any instance of a checked scene, turned or not: its placement's, or its model's, which is in its range; tables of up to 2 entries, 4 vertices and 6 indices"
 * checks = 1765
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

/* For the code of turned instances: any status. */
static fxl_status any_code(const fxl_scene *of, uint32_t *number)
{
    ASSERT("turned instances of the scene", of == &scene && scene.first_turned <= scene.instance_count);
    *number = nondet_u32();
    return (fxl_status)nondet_u32();
}

/* [[row]]
 * function = "lib/scene/scene_check.c:check_placements"
 * property = "any scene, with turned instances or without: one that passes has code for them, and they are the last of its table; tables of up to 2 entries, 4 vertices and 6 indices"
 * checks = 1422
 * unwind = 8
 */
void prove_check_placements(void)
{
    static const fxl_placement_code code = {.check = any_code};
    any_scene();
    scene.placements = nondet_bool() ? placements : NULL;
    fxl_status status;
    if (nondet_bool()) {
        scene.placement_code = NULL;
        status = check_placements(&scene, &fault);
    } else {
        scene.placement_code = &code;
        status = check_placements(&scene, &fault);
    }
    ASSERT("turned instances are the last", status != FXL_OK || scene.placements == NULL || (scene.placement_code != NULL && scene.first_turned <= scene.instance_count));
    PROOF_ENDS();
}

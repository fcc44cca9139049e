/* SPDX-License-Identifier: MIT */
#include "scene/scene_check.c"
#include "scene_tables.h"

static fxl_placement placements[INSTANCES];

/* For the code of turned instances: any status. */
static fxl_status any_code(const fxl_scene *of, uint32_t *number)
{
    ASSERT("turned instances of the scene", of == &scene && scene.first_turned <= scene.instance_count);
    *number = nondet_u32();
    return (fxl_status)nondet_u32();
}

/* [[row]]
 * function = "check_placements"
 * property = "any scene, with turned instances or without: one that passes has code for them, and they are the last of its table"
 * checks = 1298
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

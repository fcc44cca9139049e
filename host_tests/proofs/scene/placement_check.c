/* SPDX-License-Identifier: MIT */
#include "scene/placement_check.c"
#include "proof.h"

/* [[row]]
 * function = "fxl_is_rotation"
 * property = "any rows: no negation overflows"
 * checks = 63
 * contract = true
 * narrows = "it takes over a minute of CPU time with the check"
 */
void prove_is_rotation(void)
{
    fxl_orientation rows;
    (void)fxl_is_rotation(&rows);
    PROOF_ENDS();
}

/* [[row]]
 * function = "fxl_placement_radius"
 * property = "nothing overflows for a scale and a radius in range, and the radius has the slack"
 * checks = 13
 */
void prove_placement_radius(void)
{
    fxl_placement placement;
    const fxl_q16_16 radius = nondet_s32();
    ASSUME(placement.scale >= FXL_SCALE_MIN && placement.scale <= FXL_SCALE_MAX && radius >= 0 && radius <= FXL_RADIUS_MAX);
    ASSUME((uint64_t)(uint32_t)placement.scale * (uint32_t)radius >> 16 <= 2 * (uint64_t)FXL_COORDINATE_MAX);
    ASSERT("not below the slack", fxl_placement_radius(&placement, radius) >= FXL_PLACEMENT_SLACK);
    PROOF_ENDS();
}

/* [[row]]
 * function = "fxl_placement_check"
 * property = "any placement, centre and radius, and null pointers: nothing overflows, and what passes is in range"
 * checks = 69
 * uses = ["fxl_is_rotation"]
 */
void prove_placement_check(void)
{
    fxl_placement placement;
    fxl_point centre;
    const fxl_q16_16 radius = nondet_s32();
    const fxl_status status = fxl_placement_check(nondet_bool() ? NULL : &placement, nondet_bool() ? NULL : &centre, radius);
    ASSERT("checked, it is in range", status != FXL_OK || (placement.scale >= FXL_SCALE_MIN && placement.scale <= FXL_SCALE_MAX && radius >= 0));
    ASSERT("its centre is in the world", status != FXL_OK || fxl_point_in_range(&centre));
    PROOF_ENDS();
}

/* [[row]]
 * function = "fxl_placement_places_are_in_range"
 * property = "nothing overflows or is out of bounds; up to 2 turned instances of 3"
 * checks = 144
 */
void prove_placement_places_are_in_range(void)
{
    fxl_placement placements[2];
    fxl_instance instances[3];
    fxl_model models[2];
    fxl_scene scene;
    scene.placements = placements;
    scene.instances = instances;
    scene.models = models;
    ASSUME(scene.instance_count <= 3 && scene.first_turned <= scene.instance_count && scene.instance_count - scene.first_turned <= 2);
    ASSUME(instances[0].model < 2 && instances[1].model < 2 && instances[2].model < 2);
    (void)fxl_placement_places_are_in_range(&scene);
    PROOF_ENDS();
}

/* [[row]]
 * function = "fxl_placement_check_all"
 * property = "nothing overflows or is out of bounds, and a turned instance is at fault; up to 2 of 3"
 * checks = 119
 * uses = ["fxl_is_rotation"]
 */
void prove_placement_check_all(void)
{
    fxl_placement placements[2];
    fxl_instance instances[3];
    fxl_model models[2];
    fxl_scene scene;
    uint32_t number;
    scene.placements = placements;
    scene.instances = instances;
    scene.models = models;
    ASSUME(scene.instance_count <= 3 && scene.first_turned <= scene.instance_count && scene.instance_count - scene.first_turned <= 2);
    ASSUME(instances[0].model < 2 && instances[1].model < 2 && instances[2].model < 2);
    const fxl_status status = fxl_placement_check_all(&scene, &number);
    ASSERT("a turned instance is at fault", status == FXL_OK || (number >= scene.first_turned && number < scene.instance_count));
    PROOF_ENDS();
}

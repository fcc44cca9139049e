/* SPDX-License-Identifier: MIT */
#include "scene/scene_check_all.c"
#include "proof.h"

fxl_status fxl_scene_check_with(fxl_scene *scene, fxl_scene_fault *fault, fxl_scene_checker *more)
{
    (void)scene, (void)fault, (void)more;
    return nondet_bool() ? FXL_OK : FXL_E_COUNT;
}

void prove_scene_check_all(void)
{
    fxl_scene scene;
    fxl_scene_fault fault;
    const fxl_placement_code *before = scene.placement_code;
    const fxl_status status = fxl_scene_check_all(nondet_bool() ? NULL : &scene, &fault);
    ASSERT("refused, a scene is as it was", status == FXL_OK || scene.placement_code == before);
    PROOF_ENDS();
}

/* SPDX-License-Identifier: MIT */
#include "scene/scene_check_all.c"
#include "proof.h"

fxl_status fxl_scene_check_with(fxl_scene *scene, fxl_scene_fault *fault, fxl_scene_checker *more)
{
    (void)scene, (void)fault, (void)more;
    return nondet_bool() ? FXL_OK : FXL_E_COUNT;
}

/* [[row]]
 * function = "fxl_scene_check_all"
 * property = "any scene, or null: one that is refused keeps the code of its placements"
 * checks = 31
 * stubs = { fxl_scene_check_with = "any status", fxl_bsp_check = "any status", fxl_beam_check = "any status", fxl_beams_fit = "any answer" }
 * stands_in = { fxl_cluster_check = "any_cluster_status" }
 */
void prove_scene_check_all(void)
{
    fxl_scene scene;
    fxl_scene_fault fault;
    const fxl_placement_code *before = scene.placement_code;
    const fxl_status status = fxl_scene_check_all(nondet_bool() ? NULL : &scene, &fault);
    ASSERT("refused, a scene is as it was", status == FXL_OK || scene.placement_code == before);
    PROOF_ENDS();
}

/* For what checks clusters, trees and beams. */
fxl_status any_cluster_status(const fxl_scene *scene, fxl_scene_fault *fault)
{
    (void)scene, (void)fault;
    return (fxl_status)nondet_u32();
}

fxl_status fxl_bsp_check(const fxl_scene *scene, fxl_scene_fault *fault)
{
    (void)scene, (void)fault;
    return (fxl_status)nondet_u32();
}

#define BEAMS FXL_BEAMS_MAX
#define FACES 3
static fxl_beam beams[BEAMS];

fxl_status fxl_beam_check(const fxl_beam *beam)
{
    ASSERT("a beam of the table", beam >= beams && beam < beams + BEAMS);
    return (fxl_status)nondet_u32();
}

bool fxl_beams_fit(const fxl_beam *of, uint32_t beam_count, uint32_t face_vertices)
{
    (void)face_vertices;
    ASSERT("beams of the table", of == beams && beam_count <= BEAMS);
    return nondet_bool();
}

/* [[row]]
 * function = "check_beams"
 * property = "any beams of up to four, and more, and up to 3 faces: nothing is out of bounds, and those that pass have their colours"
 * checks = 111
 * stubs = { fxl_scene_check_with = "not called", fxl_bsp_check = "any status", fxl_beam_check = "any status", fxl_beams_fit = "any answer" }
 * stands_in = { fxl_cluster_check = "any_cluster_status" }
 */
void prove_check_beams(void)
{
    fxl_scene scene;
    fxl_scene_fault fault;
    static fxl_face faces[FACES];
    static uint8_t lit[256];
    scene.beams = nondet_bool() ? beams : NULL;
    scene.lit = nondet_bool() ? lit : NULL;
    scene.faces = faces;
    ASSUME(scene.face_count <= FACES);
    const fxl_status status = check_beams(&scene, &fault);
    ASSERT("at most four, with their colours", status != FXL_OK || scene.beam_count == 0 ||
                                                   (scene.beam_count <= FXL_BEAMS_MAX && scene.lit != NULL));
    (void)check_more(&scene, &fault);
    PROOF_ENDS();
}

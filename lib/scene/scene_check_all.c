/* SPDX-License-Identifier: MIT */
/* The check of a scene that may have clusters, a BSP tree, beams and placements. It is a file of
 * its own, so that a program whose scene has none of them does not link these checks. */
#include "scene_check.h"
#include "fixel/scene.h"

/* place field: the check of its values, in the file of its table */
static fxl_status check_beams(const fxl_scene *scene, fxl_scene_fault *fault)
{
    if (scene->beam_count == 0) {
        return FXL_OK;
    }
    if (scene->beams == NULL || scene->lit == NULL) {
        return fxl_fault_at(fault, "beam table", 0, FXL_E_ARGUMENT);
    }
    if (scene->beam_count > FXL_BEAMS_MAX) {
        return fxl_fault_at(fault, "beam table", 0, FXL_E_COUNT);
    }
    for (uint32_t i = 0; i < scene->beam_count; i++) {
        fxl_status status = fxl_beam_check(&scene->beams[i]);
        if (status != FXL_OK) {
            return fxl_fault_at(fault, "beam", i, status);
        }
    }
    for (uint32_t i = 0; i < scene->face_count; i++) {
        if (!fxl_beams_fit(scene->beams, scene->beam_count, scene->faces[i].count)) {
            return fxl_fault_at(fault, "face", i, FXL_E_CAPACITY);
        }
    }
    return FXL_OK;
}

static fxl_status check_more(const fxl_scene *scene, fxl_scene_fault *fault)
{
    fxl_status status = fxl_cluster_check(scene, fault);
    if (status == FXL_OK) {
        status = fxl_bsp_check(scene, fault);
    }
    return status == FXL_OK ? check_beams(scene, fault) : status;
}

FXL_COLD fxl_status fxl_scene_check_all(fxl_scene *scene, fxl_scene_fault *fault)
{
    if (scene == NULL) {
        return fxl_scene_check_with(scene, fault, check_more);
    }
    const fxl_placement_code *const before = scene->placement_code;
    if (scene->placements != NULL) {
        scene->placement_code = &fxl_turned_instances;
    }
    fxl_status status = fxl_scene_check_with(scene, fault, check_more);
    if (status == FXL_OK) {
        scene->cluster_code = scene->cluster_count > 0 ? &fxl_clusters : NULL;
    } else {
        scene->placement_code = before;
    }
    return status;
}

/* SPDX-License-Identifier: MIT */
#include "renderer.h"
#include "surface_polygon.h"
#include "fixel/depth.h"

const fxl_visibility fxl_visibility_depth = {
    .order = &fxl_by_distance, .target = &fxl_palette_depth_16, .front_to_back = true};
const fxl_visibility fxl_visibility_depth_32 = {
    .order = &fxl_by_distance, .target = &fxl_palette_depth_32, .front_to_back = true};

/* What is blended must be drawn far to near, after what is opaque. */
static bool has_blended_surfaces(const fxl_renderer *renderer)
{
    const fxl_surfaces *surfaces = fxl_surfaces_of(renderer);
    for (uint32_t i = 0; surfaces != NULL && i < surfaces->set->surface_count; i++) {
        if (surfaces->set->surfaces[i].flags & (FXL_SURFACE_BLEND | FXL_SURFACE_ADD)) {
            return true;
        }
    }
    return false;
}

/* Has the surfaces of a renderer drawn into the target. */
static void follow_target(fxl_renderer *renderer, const fxl_target *target)
{
    fxl_surfaces *surfaces = (fxl_surfaces *)(uintptr_t)fxl_surfaces_of(renderer);
    if (surfaces != NULL) {
        surfaces->painter = target == &fxl_palette_depth_32 ? FXL_SURFACES_OF(fxl_palette_depth_32)
                                                            : FXL_SURFACES_OF(fxl_palette_depth_16);
        surfaces->shader.code = surfaces->painter->code;
    }
}

fxl_status fxl_renderer_set_depth(fxl_renderer *renderer, fxl_depth *depth,
                                  const fxl_visibility *method, void *memory, uint32_t size)
{
    if (renderer == NULL) {
        return FXL_E_ARGUMENT;
    }
    if (depth == NULL || method == NULL || method->target->depth_bits == 0) {
        return fxl_refuse(&renderer->workspace, FXL_E_ARGUMENT);
    }
    const fxl_status status = fxl_renderer_set_visibility(renderer, method, memory, size);
    if (status == FXL_OK) {
        renderer->near_first = !has_blended_surfaces(renderer);
        follow_target(renderer, method->target);
    }
    return status;
}

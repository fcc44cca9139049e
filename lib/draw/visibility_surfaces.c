/* SPDX-License-Identifier: MIT */
#include "renderer.h"
#include "surface_polygon.h"

const fxl_visibility fxl_visibility_surfaces = {.order = &fxl_by_distance, .target = &fxl_palette};

fxl_status fxl_renderer_set_surfaces(fxl_renderer *renderer, fxl_surfaces *surfaces,
                                     const fxl_surface_set *set)
{
    if (renderer == NULL) {
        return FXL_E_ARGUMENT;
    }
    const fxl_status status = fxl_surfaces_attach(renderer, surfaces, set, fxl_surfaces_check,
                                                  FXL_SURFACES_OF(fxl_palette));
    return status != FXL_OK || set == NULL
               ? status
               : fxl_renderer_set_visibility(renderer, &fxl_visibility_surfaces, NULL, 0);
}

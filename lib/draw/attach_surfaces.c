/* SPDX-License-Identifier: MIT */
#include "renderer.h"
#include "surface_polygon.h"
#include "fixel/rgb565.h"

fxl_status fxl_attach_surfaces(fxl_renderer *renderer, fxl_surfaces *surfaces,
                               const fxl_surface_set *set, const fxl_painter *painter)
{
    if (renderer == NULL) {
        return FXL_E_ARGUMENT;
    }
    if (set != NULL && painter == NULL) {
        return fxl_refuse(&renderer->workspace, FXL_E_ARGUMENT);
    }
    const fxl_status status = fxl_surfaces_attach(
        renderer, surfaces, set,
        painter != NULL && painter->target->pixel_bits == 16 ? fxl_surfaces_check_rgb565
                                                             : fxl_surfaces_check,
        painter);
    if (status == FXL_OK) {
        renderer->check = fxl_check_combination;
    }
    return status;
}

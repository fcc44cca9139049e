/* SPDX-License-Identifier: MIT */
#include "renderer.h"
#include "../paint/billboard_paint.h"

fxl_status fxl_renderer_set_billboards_by_depth(fxl_renderer *renderer, fxl_billboards *billboards,
                                                const fxl_billboard_set *set)
{
    if (renderer == NULL) {
        return FXL_E_ARGUMENT;
    }
    fxl_status status = fxl_billboards_check_attaching(renderer, billboards, set);
    if (status == FXL_OK) {
        status = set == NULL ? FXL_E_ARGUMENT
                 : renderer->target == NULL || renderer->target->depth_bits == 0 ? FXL_E_ORDER
                                                                                 : FXL_OK;
    }
    if (status != FXL_OK) {
        return fxl_refuse(&renderer->workspace, status);
    }
    return fxl_billboards_attach(renderer, billboards, set,
                                 renderer->target->depth_bits == 32
                                     ? FXL_SPRITES_OF(fxl_palette_depth_32)
                                     : FXL_SPRITES_OF(fxl_palette_depth_16));
}

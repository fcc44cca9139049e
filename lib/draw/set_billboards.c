/* SPDX-License-Identifier: MIT */
#include "renderer.h"
#include "../paint/billboard_paint.h"

const fxl_visibility fxl_visibility_billboards = {.order = &fxl_by_distance_with_billboards,
                                                  .target = &fxl_palette};

fxl_status fxl_renderer_set_billboards(fxl_renderer *renderer, fxl_billboards *billboards,
                                       const fxl_billboard_set *set)
{
    if (renderer == NULL) {
        return FXL_E_ARGUMENT;
    }
    if (set != NULL && renderer->target != NULL &&
        fxl_billboards_check_attaching(renderer, billboards, set) == FXL_OK &&
        (renderer->target != &fxl_palette ||
         (renderer->order != &fxl_by_distance &&
          renderer->order != &fxl_by_distance_with_billboards))) {
        return fxl_refuse(&renderer->workspace, FXL_E_ORDER);
    }
    return fxl_billboards_attach(renderer, billboards, set, FXL_SPRITES_OF(fxl_palette));
}

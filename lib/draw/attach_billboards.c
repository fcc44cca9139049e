/* SPDX-License-Identifier: MIT */
#include "renderer.h"
#include "submit.h"
#include "../paint/billboard_paint.h"

fxl_status fxl_attach_billboards(fxl_renderer *renderer, fxl_billboards *billboards,
                                 const fxl_billboard_set *set, const fxl_sprite_painter *painter)
{
    if (renderer == NULL) {
        return FXL_E_ARGUMENT;
    }
    if (set != NULL && painter == NULL) {
        return fxl_refuse(&renderer->workspace, FXL_E_ARGUMENT);
    }
    const fxl_status status = fxl_billboards_attach(renderer, billboards, set, painter);
    if (status == FXL_OK) {
        renderer->check = fxl_check_combination;
    }
    return status;
}

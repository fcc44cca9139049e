/* SPDX-License-Identifier: MIT */

#include "../math/family.h"
#include "model_view.h"
#include "outcode.h"

#if !FXL_KERNELS_ARMV6M && !FXL_KERNELS_ARMV7M

void fxl_transform_vertex(const fxl_model_view *model_view, uint32_t number,
                          fxl_cached_vertex *entry)
{
    const fxl_view *view = model_view->view;
    fxl_model_view_position(model_view, number, &entry->position);
    entry->tag = model_view->tag + number;
    unsigned outside = 0;
    if (model_view->planes != 0) {
        if ((model_view->planes & FXL_MODEL_VIEW_SCALED) != 0) {
            (void)model_view->scale_vertex(model_view, entry);
            return;
        }
        outside = fxl_outside(&view->view_frustum, model_view->planes, &entry->position);
    }
    entry->clip_flags = outside | FXL_VERTEX_UNPROJECTED;
}

#endif

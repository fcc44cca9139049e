/* SPDX-License-Identifier: MIT */
#include "../math/arith.h"
#include "../math/family.h"
#include "outcode.h"

#define FXL_HERE
#include "model_view.h"

/* SPEC 2.1, 3.3, 4.6, clippers 1.4 */
void fxl_transform_point(const fxl_camera *camera, const fxl_point *point, fxl_view_point *view)
{
    FXL_ASSERT(fxl_point_in_range(point));
    /* Both within FXL_COORDINATE_MAX, so each difference is below 2^30. */
    fxl_point difference;
    fxl_subtract(point, &camera->position, &difference);
    const fxl_view_point eye_itself = {0, 0, 0};
    fxl_rotate(&camera->axes, &difference, &eye_itself, view);
}

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

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

/* The clip flags of a vertex whose upper words do not decide. Apart, and called last: what a call
 * leaves intact would else be saved at each vertex. */
static __attribute__((noinline)) void decide(const fxl_model_view *model_view,
                                             fxl_cached_vertex *entry)
{
    entry->clip_flags =
        FXL_VERTEX_UNPROJECTED | fxl_outcode(&model_view->view->view_frustum,
                                             (fxl_planes)model_view->planes, &entry->position);
}

void fxl_transform_vertex(const fxl_model_view *model_view, uint32_t number,
                          fxl_cached_vertex *entry)
{
    fxl_model_view_position(model_view, number, &entry->position);
    entry->tag = model_view->tag + number;
    unsigned outside = 0;
    if (model_view->planes != 0) {
        if ((model_view->planes & FXL_MODEL_VIEW_SCALED) != 0) {
            (void)model_view->scale_vertex(model_view, entry);
            return;
        }
        outside =
            fxl_outside(&model_view->view->view_frustum, model_view->planes, &entry->position);
        if ((outside & FXL_OUTSIDE_IS_OPEN) != 0) {
            decide(model_view, entry);
            return;
        }
    }
    entry->clip_flags = outside | FXL_VERTEX_UNPROJECTED;
}

#endif

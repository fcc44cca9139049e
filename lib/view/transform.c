/* SPDX-License-Identifier: MIT */
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

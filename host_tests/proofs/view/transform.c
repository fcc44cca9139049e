/* SPDX-License-Identifier: MIT */
#include "view/transform.c"
#include "proof.h"

void prove_rotate(void)
{
    fxl_axes *axes;
    fxl_point *point;
    fxl_view_point *origin, *sum;
    fxl_rotate(axes, point, origin, sum);
    PROOF_ENDS();
}

void prove_transform_point(void)
{
    fxl_camera *camera;
    fxl_point *point;
    fxl_view_point *view;
    fxl_transform_point(camera, point, view);
    PROOF_ENDS();
}

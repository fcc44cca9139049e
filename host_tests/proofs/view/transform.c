/* SPDX-License-Identifier: MIT */
#include "view/transform.c"
#include "proof.h"

/* [[row]]
 * function = "lib/view/model_view.h:fxl_rotate"
 * property = "no sum overflows, for an origin below 2^62"
 * checks = 329
 * contract = true
 * uses = ["fxl_dot"]
 */
void prove_rotate(void)
{
    fxl_axes *axes;
    fxl_point *point;
    fxl_view_point *origin, *sum;
    fxl_rotate(axes, point, origin, sum);
    PROOF_ENDS();
}

/* [[row]]
 * function = "fxl_transform_point"
 * property = "no sum overflows, and each coordinate is below 7 2^59"
 * checks = 384
 * contract = true
 * uses = ["fxl_dot", "fxl_point_in_range", "fxl_subtract"]
 */
void prove_transform_point(void)
{
    fxl_camera *camera;
    fxl_point *point;
    fxl_view_point *view;
    fxl_transform_point(camera, point, view);
    PROOF_ENDS();
}

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

/* For fxl_transform_point: what its contract requires. */
void any_transform(const fxl_camera *camera, const fxl_point *point, fxl_view_point *view)
{
    fxl_view_point any;
    (void)camera;
    ASSERT("a point of the world", FXL_POINT_BELOW(point, FXL_COORDINATE_MAX));
    *view = any;
}

/* [[row]]
 * function = "fxl_transform_polygon"
 * property = "any polygon of up to 32 vertices of the world: nothing is out of bounds"
 * checks = 93
 * unwind = 33
 * stands_in = { fxl_transform_point = "any_transform" }
 */
void prove_transform_polygon(void)
{
    fxl_camera camera;
    static fxl_polygon polygon;
    static fxl_view_polygon view;
    ANY_CONTENT(&polygon);
    ASSUME(polygon.count <= FXL_POLYGON_CAPACITY);
    for (uint32_t i = 0; i < FXL_POLYGON_CAPACITY; i++) {
        ASSUME(FXL_POINT_BELOW(&polygon.vertices[i].position, FXL_COORDINATE_MAX));
    }
    fxl_transform_polygon(&camera, &polygon, &view);
    ASSERT("as many vertices", view.count == polygon.count);
    PROOF_ENDS();
}

/* SPDX-License-Identifier: MIT */

#include "../math/arith.h"
#include "../scene/face_bounds.h"
#include "cull.h"
#include "model_view.h"

/* SPEC 4.5 */
bool fxl_face_is_front(const fxl_scene *scene, const fxl_instance *instance, const fxl_face *face,
                       const fxl_point *eye)
{
    uint32_t first_vertex = scene->models[instance->model].first_vertex;
    const fxl_point *vertex = &scene->vertices[first_vertex + face->indices[0]];
    const fxl_point *centre = &instance->centre;
    /* The vertex in the world and the eye are within FXL_COORDINATE_MAX, so each
     * difference is below 2^30; so is eye - centre. */
    return fxl_dot(&face->normal, eye->x - centre->x - vertex->x, eye->y - centre->y - vertex->y,
                   eye->z - centre->z - vertex->z) > 0;
}

/* SPEC 4.5 */
bool fxl_bounded_face_is_front(const fxl_face *face, const fxl_face_bounds *bounds,
                               const fxl_point *eye)
{
    return fxl_dot(&face->normal, eye->x, eye->y, eye->z) > fxl_face_bounds_height(bounds);
}

bool fxl_exact_dot_is_negative(const fxl_direction *direction, int32_t x, int32_t y, int32_t z)
{
    return fxl_dot(direction, x, y, z) < 0;
}

void fxl_face_to_polygon(const fxl_model_view *model_view, const fxl_face *face,
                         fxl_polygon *polygon)
{
    const uint16_t *indices = fxl_face_indices(model_view->indices, face);
    const fxl_point *eye = &model_view->view->camera.position;
    FXL_ASSERT(face->count >= 3 && face->count <= FXL_FACE_VERTICES_MAX);
    polygon->colour = face->material;
    polygon->count = face->count;
    polygon->textured = false;
    for (uint32_t i = 0; i < face->count; i++) {
        fxl_point from_eye = fxl_model_view_vertex(model_view, indices[i]);
        fxl_point *position = &polygon->vertices[i].position;
        position->x = from_eye.x + eye->x;
        position->y = from_eye.y + eye->y;
        position->z = from_eye.z + eye->z;
    }
}

/* --- spheres ----------------------------------------------------------------------------------- */

/* The sphere test uses upper words only. The upper word of a view point in 18.46 is in
 * units of 2^-14. The upper word of its product with a component of a normal is in units of
 * 2^-12. Distances are in units of 2^-12.
 *
 * Error of a distance, in these units. Side planes: the floors of the view point move the
 * distance by less than (side + depth) / 4 < 0.36; the floors of the two products move it by
 * less than 2 in all; the floor of the inset moves it by less than 1 the other way. Near and
 * far: two floors, less than 1. So a true distance differs from the computed one by less
 * than 2.37.
 *
 * How much farther than the radius a vertex may lie from the centre, along the normal of a
 * plane. Entries of the matrix have errors of 2 units of 2^-30 (camera.h), so a row stretches
 * by at most 6 * 2^-30. The two components of a normal have errors of 1 unit each, which
 * stretch it by 1.5 * 2^-30. Together that is 13 / 65536 at the largest radius. The normals of
 * the world (frustum.h: 4 * 2^-30 a component) differ from these by less than 14.5 * 2^-30,
 * which moves a point that is 28375 units away by 25 / 65536. Five cuts in the world round by
 * 0.9 / 65536 each; cuts in the view round by a negligible amount. All this is below
 * 43 / 65536, which is 2.7 of the units of 2^-12.
 *
 * Both errors together are below 5.1. The slack that is added to the radius, floored, is 9,
 * so at least 8 remain for the errors. So the test never rejects an instance of which a
 * face would be drawn. */
#define SLACK 9

/* The upper word of a product. */
static int32_t multiply_upper(fxl_q2_30 component, int32_t coordinate)
{
    return (int32_t)(fxl_multiply_s31(component, coordinate) >> 32);
}

/* Tests the two side planes of one axis. The normal of low points along the axis. across and
 * along are below 2^29, so their products' upper words are below 2^27. So is the reach. No
 * sum of these exceeds 2^30. */
/* SPEC 4.4 */
static uint32_t side_planes(fxl_q2_30 side, fxl_q2_30 depth, int32_t across, int32_t along,
                            int32_t inset, int32_t reach, int low, int high)
{
    int32_t apart = multiply_upper(side, across);
    int32_t ahead = multiply_upper(depth, along) - inset;
    int32_t from_low = ahead + apart;
    int32_t from_high = ahead - apart;
    if (from_low + reach < 0 || from_high + reach < 0) {
        return FXL_SPHERE_OUTSIDE;
    }
    return (uint32_t)(from_low < reach) << low | (uint32_t)(from_high < reach) << high;
}

/* The coordinate along an axis of the view, in units of 2^-14. Exact except for the floor. */
static int32_t upper(fxl_q18_46 coordinate)
{
    return (int32_t)((uint64_t)coordinate >> 32);
}

/* SPEC 4.4 */
uint32_t fxl_sphere_planes(const fxl_camera *camera, const fxl_view_frustum *frustum,
                           const fxl_point *centre, fxl_q16_16 radius)
{
    FXL_ASSERT(fxl_point_in_range(centre) && radius >= 0 && radius <= FXL_RADIUS_MAX);
    const int32_t reach = (radius >> 4) + SLACK;
    /* Both within FXL_COORDINATE_MAX, so each difference is below 2^30. */
    fxl_point from_eye;
    fxl_view_point at = {0, 0, 0};
    fxl_subtract(centre, &camera->position, &from_eye);
    uint32_t estimate = fxl_estimated_sphere(&camera->axes, frustum, &from_eye, reach);
    if (estimate != FXL_SPHERE_UNDECIDED) {
        return estimate;
    }
    fxl_rotate(&camera->axes, &from_eye, &at, &at);

    int32_t z = upper(at.z);
    int32_t from_near = (z >> 2) - (int32_t)(frustum->near_z >> 34);
    int32_t from_far = (int32_t)(frustum->far_z >> 34) - (z >> 2);
    if (from_near + reach < 0 || from_far + reach < 0) {
        return FXL_SPHERE_OUTSIDE;
    }
    uint32_t planes = (uint32_t)(from_near < reach) << FXL_PLANE_NEAR | (uint32_t)(from_far < reach)
                                                                            << FXL_PLANE_FAR;

    int32_t inset = (int32_t)(frustum->inset >> 34);
    int32_t x = upper(at.x);
    uint32_t across = side_planes(frustum->x_side, frustum->x_depth, x, z, inset, reach,
                                  FXL_PLANE_LEFT, FXL_PLANE_RIGHT);
    if (across == FXL_SPHERE_OUTSIDE) {
        return FXL_SPHERE_OUTSIDE;
    }
    int32_t y = upper(at.y);
    uint32_t upright = side_planes(frustum->y_side, frustum->y_depth, y, z, inset, reach,
                                   FXL_PLANE_BOTTOM, FXL_PLANE_TOP);
    return upright == FXL_SPHERE_OUTSIDE ? FXL_SPHERE_OUTSIDE : planes | across | upright;
}

#if !FXL_IS_COMPACT && !FXL_KERNELS_ARMV7M

const fxl_face *fxl_next_front_face(const fxl_model_view *model_view, fxl_face_walk *walk)
{
    return fxl_next_face_by(model_view, walk, fxl_model_view_face_is_front);
}

#endif

/* SPDX-License-Identifier: MIT */
/* Only upper words are used: of a view point in 18.46 the upper word is in units
 * of 2^-14, of its product with a component of a normal in units of 2^-12.
 * Distances are in the latter.
 *
 * How far off they are, in these units. Side planes: the floors of the view point
 * move the distance by less than (side + depth) / 4 < 0.36, the floors of two
 * products by less than 2 in all, that of the inset by less than 1 the other way.
 * Near and far: two floors, less than 1. So a true distance lies less than 2.37
 * from the computed one.
 *
 * How much farther than the radius from the centre a vertex may lie along that
 * normal: rows of the matrix err by 2 units of 2^-30 an entry (camera.h) and so
 * stretch by 6 * 2^-30 at most, a normal's two components err by 1 each and
 * stretch it by 1.5 * 2^-30: 13 / 65536 at the largest radius. The world's normals
 * (frustum.h: 4 * 2^-30 a component) differ from these by less than 14.5 * 2^-30,
 * which moves a point that is 28375 units away by 25 / 65536; five cuts in the
 * world round by 0.9 / 65536 each, in the view by nothing to speak of. All this
 * is below 43 / 65536, 2.7 of our units.
 *
 * Both together are below 5.1. What is added to the radius, floored, is 9, so at
 * least 8 are left for them: no object is left out of which a face is drawn. */
#include "fixel/sphere.h"

#include "arith.h"

#define SLACK 9 /* bug: sphere-slack */

/* The upper word of a product. */
static int32_t scaled(fxl_q2_30 part, int32_t size)
{
    return (int32_t)(fxl_multiply_s31(part, size) >> 32);
}

/* The two planes through the eye of one axis; the normal of low points along it.
 * across and along are below 2^29, what is made of them below 2^27: no sum of it
 * and of the reach, which is below 2^27 too, passes 2^30. */
static uint32_t side_planes(fxl_q2_30 side, fxl_q2_30 depth, int32_t across, int32_t along,
                            int32_t inset, int32_t reach, int low, int high)
{
    int32_t apart = scaled(side, across);
    int32_t ahead = scaled(depth, along) - inset;
    int32_t from_low = ahead + apart;
    int32_t from_high = ahead - apart; /* bug: sphere-swap */
    if (from_low + reach < 0 || from_high + reach < 0) {
        return FXL_SPHERE_OUTSIDE;
    }
    return (uint32_t)(from_low < reach) << low | (uint32_t)(from_high < reach) << high;
}

/* Exact but for the floor. */
static int32_t along_axis(const fxl_direction *axis, int32_t dx, int32_t dy, int32_t dz)
{
    return (int32_t)((uint64_t)fxl_dot(axis, dx, dy, dz) >> 32);
}

uint32_t fxl_sphere_planes(const fxl_camera *camera, const fxl_view_frustum *frustum,
                           const fxl_point *centre, fxl_q16_16 radius)
{
    FXL_ASSERT(fxl_point_in_range(centre) && radius >= 0 && radius <= FXL_RADIUS_MAX);
    const int32_t reach = (radius >> 4) + SLACK;
    /* Both within FXL_COORDINATE_MAX, so each difference is below 2^30. */
    int32_t dx = centre->x - camera->position.x;
    int32_t dy = centre->y - camera->position.y;
    int32_t dz = centre->z - camera->position.z;

    int32_t z = along_axis(&camera->forward, dx, dy, dz);
    int32_t from_near = (z >> 2) - (int32_t)(frustum->near >> 34);
    int32_t from_far = (int32_t)(frustum->far >> 34) - (z >> 2);
    if (from_near + reach < 0 || from_far + reach < 0) { /* bug: sphere-far */
        return FXL_SPHERE_OUTSIDE;
    }
    uint32_t planes = (uint32_t)(from_near < reach) << FXL_PLANE_NEAR | (uint32_t)(from_far < reach)
                                                                            << FXL_PLANE_FAR;

    int32_t inset = (int32_t)(frustum->inset >> 34);
    int32_t x = along_axis(&camera->right, dx, dy, dz);
    planes |= side_planes(frustum->x_side, frustum->x_depth, x, z, inset, reach, FXL_PLANE_LEFT,
                          FXL_PLANE_RIGHT);
    if (planes >= FXL_SPHERE_OUTSIDE) {
        return FXL_SPHERE_OUTSIDE;
    }
    int32_t y = along_axis(&camera->up, dx, dy, dz);
    planes |= side_planes(frustum->y_side, frustum->y_depth, y, z, inset, reach, FXL_PLANE_BOTTOM,
                          FXL_PLANE_TOP);
    return planes >= FXL_SPHERE_OUTSIDE ? FXL_SPHERE_OUTSIDE : planes;
}

/* SPDX-License-Identifier: MIT */

#include "../math/arith.h"
#include "../math/plane.h"
#include "../math/square_root.h"
#include "view.h"

/* Scales (a, b), 0 < a, b < 2^30, to unit length. Both are first shifted up until one of
 * them has 30 bits, so that the last unit of the root is below 2^-29 of it. */
static void normalise(uint32_t a, uint32_t b, fxl_q2_30 *unit_a, fxl_q2_30 *unit_b)
{
    unsigned shift = 30u - fxl_bit_length(a | b);
    uint32_t wide_a = a << shift;
    uint32_t wide_b = b << shift;
    /* The squares are below 2^60, so four times their sum is below 2^63. Its root is
     * twice the length, which has one bit more than the length. */
    uint32_t length =
        fxl_square_root(4 * (fxl_multiply_u32(wide_a, wide_a) + fxl_multiply_u32(wide_b, wide_b)));
    *unit_a = fxl_divide_round((int64_t)wide_a << 31, length);
    *unit_b = fxl_divide_round((int64_t)wide_b << 31, length);
}

/* A component of turn. The vectors have unit length, so the sum of the two products is below
 * 2^61. */
static fxl_q2_30 turned_entry(fxl_q2_30 along, fxl_q2_30 side, fxl_q2_30 depth, fxl_q2_30 forward)
{
    return (fxl_q2_30)fxl_round_shift(
        fxl_multiply_s32(along, side) + fxl_multiply_s32(depth, forward), 30);
}

/* Rotates a normal of the view into the world: along * side + depth * forward. */
static fxl_direction turn(fxl_q2_30 along, const fxl_direction *side, fxl_q2_30 depth,
                          const fxl_direction *forward)
{
    fxl_direction turned = {turned_entry(along, side->x, depth, forward->x),
                            turned_entry(along, side->y, depth, forward->y),
                            turned_entry(along, side->z, depth, forward->z)};
    return turned;
}

/* Sets up the two side planes that bound one axis of the screen, by those of the view. */
static void set_side_planes(const fxl_camera *camera, const fxl_direction *axis, fxl_q2_30 along,
                            fxl_q2_30 depth, fxl_q16_16 inset, fxl_plane *low, fxl_plane *high)
{
    fxl_direction normal = turn(along, axis, depth, &camera->axes.forward);
    *low = fxl_plane_from_point(&camera->position, &normal, inset);
    normal = turn(-along, axis, depth, &camera->axes.forward);
    *high = fxl_plane_from_point(&camera->position, &normal, inset);
}

void fxl_view_frustum_from_lens(const fxl_lens *lens, fxl_view_frustum *frustum)
{
    uint32_t focal = (uint32_t)lens->focal;
    normalise(focal, lens->width * 32768u, &frustum->x_side, &frustum->x_depth);
    normalise(focal, lens->height * 32768u, &frustum->y_side, &frustum->y_depth);
    /* near_z and far_z are below 2^31, the inset is at most 2^16: the products are below 2^62. */
    frustum->near_z = ((int64_t)lens->near_z + lens->inset) * FXL_Q2_30_ONE;
    frustum->far_z = ((int64_t)lens->far_z - lens->inset) * FXL_Q2_30_ONE;
    frustum->inset = (int64_t)lens->inset * FXL_Q2_30_ONE;
}

void fxl_frustum_from_camera(const fxl_camera *camera, const fxl_lens *lens, fxl_frustum *frustum)
{
    fxl_view_frustum sides;
    fxl_view_frustum_from_lens(lens, &sides);
    fxl_frustum_from_sides(camera, lens, &sides, frustum);
}

void fxl_frustum_from_sides(const fxl_camera *camera, const fxl_lens *lens,
                            const fxl_view_frustum *sides, fxl_frustum *frustum)
{
    fxl_plane *planes = frustum->planes;
    set_side_planes(camera, &camera->axes.right, sides->x_side, sides->x_depth, lens->inset,
                    &planes[FXL_PLANE_LEFT], &planes[FXL_PLANE_RIGHT]);
    set_side_planes(camera, &camera->axes.up, sides->y_side, sides->y_depth, lens->inset,
                    &planes[FXL_PLANE_BOTTOM], &planes[FXL_PLANE_TOP]);

    /* near_z and far_z add at most 2^31 * 2^30 = 2^61 to a distance below 2^61. */
    planes[FXL_PLANE_NEAR] =
        fxl_plane_from_point(&camera->position, &camera->axes.forward, lens->inset);
    planes[FXL_PLANE_NEAR].distance += (int64_t)lens->near_z * FXL_Q2_30_ONE;

    fxl_direction backward = {-camera->axes.forward.x, -camera->axes.forward.y,
                              -camera->axes.forward.z};
    planes[FXL_PLANE_FAR] = fxl_plane_from_point(&camera->position, &backward, lens->inset);
    planes[FXL_PLANE_FAR].distance -= (int64_t)lens->far_z * FXL_Q2_30_ONE;
}

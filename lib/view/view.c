/* SPDX-License-Identifier: MIT */
/* Each entry of the matrix is a sum of two products. A table says which factors they have; written
 * out, the sums take 116 bytes more on a Cortex-M3. */
#include "../math/arith.h"
#include "../math/plane.h"
#include "fixel/camera.h"
#include "view.h"
#include "../scene/lens.h"
#include "project.h"

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
/* SPEC 1.3 */
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
/* SPEC 4.3 */
static void set_side_planes(const fxl_camera *camera, const fxl_direction *axis, fxl_q2_30 along,
                            fxl_q2_30 depth, fxl_q16_16 inset, fxl_plane *low, fxl_plane *high)
{
    fxl_direction normal = turn(along, axis, depth, &camera->axes.forward);
    *low = fxl_plane_from_point(&camera->position, &normal, inset);
    normal = turn(-along, axis, depth, &camera->axes.forward);
    *high = fxl_plane_from_point(&camera->position, &normal, inset);
}

/* A slope of a pair of side planes: (depth - margin) / side, in units of 2^-30. The margin is the inset
 * by near_z, and at least a unit more, which a rounded quotient does not use up: side is at most 1. So
 * slope z side is at most depth z less the inset, if z is at least near_z. A lens so wide that the
 * slope is 2 or more has 0, and one so narrow that it would be below 0. */
static fxl_q2_30 slope_of(fxl_q2_30 side, fxl_q2_30 depth, int32_t margin)
{
    const uint32_t rest = (uint32_t)(depth - margin);
    return rest < 2 * (uint32_t)side ? fxl_divide_round((int64_t)rest << 30, (uint32_t)side) : 0;
}

/* SPEC 4.3 */
void fxl_view_frustum_from_lens(const fxl_lens *lens, fxl_view_frustum *frustum)
{
    uint32_t focal = (uint32_t)lens->focal;
    normalise(focal, lens->width * 32768u, &frustum->x_side, &frustum->x_depth);
    normalise(focal, lens->height * 32768u, &frustum->y_side, &frustum->y_depth);
    /* near_z and far_z are below 2^31, the inset is at most 2^16: the products are below 2^62. */
    frustum->near_z = ((int64_t)lens->near_z + lens->inset) * FXL_Q2_30_ONE;
    frustum->far_z = ((int64_t)lens->far_z - lens->inset) * FXL_Q2_30_ONE;
    frustum->inset = (int64_t)lens->inset * FXL_Q2_30_ONE;
    const int32_t margin =
        fxl_divide_round(frustum->inset, (uint32_t)lens->near_z + (uint32_t)lens->inset) + 2;
    frustum->x_slope = slope_of(frustum->x_side, frustum->x_depth, margin);
    frustum->y_slope = slope_of(frustum->y_side, frustum->y_depth, margin);
}

/* SPEC 4.3 */
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

/* The factors, in units of 2^-31: cosines (C) and sines (S) of yaw (Y), pitch (P) and roll (R), the
 * negated sines, x and z of the view's up before roll, and constants. */
enum {
    CY,
    SY,
    CP,
    SP,
    CR,
    SR,
    MINUS_SY,
    MINUS_SP,
    MINUS_SR,
    UP_X,
    UP_Z,
    ONE,
    ZERO,
    FACTOR_COUNT
};

/* a b + c d: the numbers of four factors. */
typedef uint8_t sum_of_products[4];

/* The view's up before roll is (-sp sy, cp, -sp cy). */
static const sum_of_products up_x = {MINUS_SP, SY, ZERO, ZERO};
static const sum_of_products up_z = {MINUS_SP, CY, ZERO, ZERO};

/* SPEC 1.3 */
static const sum_of_products matrix[3][3] = {
    {{CR, CY, SR, UP_X}, {SR, CP, ZERO, ZERO}, {CR, MINUS_SY, SR, UP_Z}}, /* right */
    {{MINUS_SR, CY, CR, UP_X}, {CR, CP, ZERO, ZERO}, {SR, SY, CR, UP_Z}}, /* up */
    {{CP, SY, ZERO, ZERO}, {SP, ONE, ZERO, ZERO}, {CP, CY, ZERO, ZERO}}}; /* forward */

/* A sum of two products, rounded once: an entry of the matrix to 2^-30, a factor of others to 2^-31.
 * Error: half a unit. Every sum is an entry of a rotation, so |a b| + |c d| <= 2^62 (1 + 2^-29), and
 * adding the half of the rounding does not overflow. A shift by a variable would be a function of the
 * compiler's library where this is compiled for size. */
/* accuracy 1.1 */
static int64_t sum(const int64_t *factors, const sum_of_products of, bool is_entry)
{
    const int64_t exact = fxl_multiply_s64(factors[of[0]], factors[of[1]]) +
                          fxl_multiply_s64(factors[of[2]], factors[of[3]]);
    return is_entry ? fxl_round_shift(exact, 32) : fxl_round_shift(exact, 31);
}

/* SPEC 4.2 */
FXL_COLD fxl_status fxl_camera_from_pose(const fxl_pose *pose, fxl_camera *camera)
{
    if (pose == NULL || camera == NULL) {
        return FXL_E_ARGUMENT;
    }
    if (!fxl_point_in_range(&pose->position)) {
        return FXL_E_RANGE;
    }
    const fxl_angle angles[3] = {pose->yaw, pose->pitch, pose->roll};
    fxl_direction *const rows[3] = {&camera->axes.right, &camera->axes.up, &camera->axes.forward};
    int64_t factors[FACTOR_COUNT];
    for (uint32_t i = 0; i < 3; i++) {
        factors[CY + 2 * i] = fxl_cos_q31(angles[i]);
        factors[SY + 2 * i] = fxl_sin_q31(angles[i]);
        factors[MINUS_SY + i] = -factors[SY + 2 * i];
    }
    factors[ONE] = (int64_t)1 << 31;
    factors[ZERO] = 0;
    factors[UP_X] = sum(factors, up_x, false);
    factors[UP_Z] = sum(factors, up_z, false);
    camera->position = pose->position;
    for (uint32_t i = 0; i < 3; i++) {
        rows[i]->x = (fxl_q2_30)sum(factors, matrix[i][0], true);
        rows[i]->y = (fxl_q2_30)sum(factors, matrix[i][1], true);
        rows[i]->z = (fxl_q2_30)sum(factors, matrix[i][2], true);
    }
    return FXL_OK;
}

void fxl_view_set_lens(fxl_view *view, const fxl_lens *lens)
{
    view->lens = *lens;
    view->frame = 0;
    fxl_view_frustum_from_lens(lens, &view->view_frustum);
    fxl_projection_from_lens(lens, &view->projection);
    if (lens->off_centre != NULL) {
        lens->off_centre->set_lens(view);
    }
}

fxl_lens fxl_view_drawn_lens(const fxl_view *view)
{
    fxl_lens lens = view->lens;
    lens.focal = fxl_view_drawn_focal(view);
    lens.centre_x = view->projection.centre_x;
    lens.centre_y = view->projection.centre_y;
    lens.off_centre = NULL;
    return lens;
}

/* SPEC 3.2 */
__attribute__((noinline)) fxl_status fxl_view_set_own_pose(fxl_view *view, const fxl_pose *pose)
{
    const fxl_status status = fxl_camera_from_pose(pose, &view->camera);
    if (status == FXL_OK) {
        fxl_view_next_frame(view);
    }
    return status;
}

fxl_status fxl_view_set_pose(fxl_view *view, const fxl_pose *pose)
{
    return view->lens.off_centre != NULL ? view->lens.off_centre->set_pose(view, pose)
                                         : fxl_view_set_own_pose(view, pose);
}

void fxl_view_set_world_frustum(fxl_view *view)
{
    fxl_frustum_from_sides(&view->camera, &view->lens, &view->view_frustum, &view->frustum);
}

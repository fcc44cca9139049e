/* SPDX-License-Identifier: MIT */
/* Orientations from angles and from products. */
#include "fixel/camera.h"
#include "fixel/orientation.h"

#include "../math/arith.h"
#include "orthonormal.h"

static int64_t widened(fxl_q2_30 entry)
{
    return (int64_t)entry * FXL_Q2_30_ONE;
}

/* The camera's rows are the columns. The camera's entries are at most 1.7 units off; each row and
 * column of them is then off by at most 1.7 sqrt(3). With C = R + e, the nearest rotation is
 * R + (e - R e' R) / 2, of which an entry is at most (1.7 + 3 * 1.7) / 2 = 3.4 units. */
fxl_status fxl_orientation_from_angles(fxl_angle yaw, fxl_angle pitch, fxl_angle roll,
                                       fxl_orientation *orientation)
{
    const fxl_pose pose = {{0, 0, 0}, yaw, pitch, roll};
    fxl_camera camera;
    if (orientation == NULL) {
        return FXL_E_ARGUMENT;
    }
    const fxl_status status = fxl_camera_from_pose(&pose, &camera);
    FXL_ASSERT(status == FXL_OK);
    (void)status;
    const fxl_axes *axes = &camera.axes;
    const fxl_wide_matrix matrix = {
        {{widened(axes->right.x), widened(axes->up.x), widened(axes->forward.x)},
         {widened(axes->right.y), widened(axes->up.y), widened(axes->forward.y)},
         {widened(axes->right.z), widened(axes->up.z), widened(axes->forward.z)}}};
    fxl_orthonormalise(&matrix, orientation);
    return FXL_OK;
}

/* A row of a times b. By Cauchy-Schwarz an entry is at most 2^60 (1 + 2^-24)^2, and so is every
 * partial sum. Exact. */
static void multiply_row(const fxl_direction *row, const fxl_orientation *b, int64_t out[3])
{
    out[0] = fxl_multiply_s32(row->x, b->x.x) + fxl_multiply_s32(row->y, b->y.x) +
             fxl_multiply_s32(row->z, b->z.x);
    out[1] = fxl_multiply_s32(row->x, b->x.y) + fxl_multiply_s32(row->y, b->y.y) +
             fxl_multiply_s32(row->z, b->z.y);
    out[2] = fxl_multiply_s32(row->x, b->x.z) + fxl_multiply_s32(row->y, b->y.z) +
             fxl_multiply_s32(row->z, b->z.z);
}

static bool is_rotation(const fxl_orientation *orientation)
{
    const fxl_point origin = {0, 0, 0};
    const fxl_turn turn = {*orientation, FXL_Q16_16_ONE};
    return fxl_turn_check(&turn, &origin, 0) == FXL_OK;
}

/* Two rows of a checked orientation are within 2^-28, and the third is within 2^-26 a component of
 * their cross product. So no eigenvalue of A A' - I is above 2^-24, nor of B B' - I; of the product
 * none is above 2^-23 (1 + 2^-24). */
fxl_status fxl_orientation_multiply(const fxl_orientation *a, const fxl_orientation *b,
                                    fxl_orientation *product)
{
    if (a == NULL || b == NULL || product == NULL) {
        return FXL_E_ARGUMENT;
    }
    if (!is_rotation(a) || !is_rotation(b)) {
        return FXL_E_TURN;
    }
    fxl_wide_matrix matrix;
    multiply_row(&a->x, b, matrix.rows[0]);
    multiply_row(&a->y, b, matrix.rows[1]);
    multiply_row(&a->z, b, matrix.rows[2]);
    fxl_orthonormalise(&matrix, product);
    return FXL_OK;
}

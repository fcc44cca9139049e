/* SPDX-License-Identifier: MIT */
/* Each entry of the matrix is a sum of two products. A table says which factors they have; written
 * out, the sums take 116 bytes more on a Cortex-M3. */

#include "../math/arith.h"
#include "../math/sine.h"
#include "fixel/camera.h"

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

static const sum_of_products matrix[3][3] = {
    {{CR, CY, SR, UP_X}, {SR, CP, ZERO, ZERO}, {CR, MINUS_SY, SR, UP_Z}}, /* right */
    {{MINUS_SR, CY, CR, UP_X}, {CR, CP, ZERO, ZERO}, {SR, SY, CR, UP_Z}}, /* up */
    {{CP, SY, ZERO, ZERO}, {SP, ONE, ZERO, ZERO}, {CP, CY, ZERO, ZERO}}}; /* forward */

/* A sum of two products, rounded once, to units of 2^(bits - 62). Error: half a unit. Every sum is
 * an entry of a rotation, so |a b| + |c d| <= 2^62 (1 + 2^-29), and adding the half of the rounding
 * does not overflow. */
static int64_t sum(const int64_t *factors, const sum_of_products of, unsigned bits)
{
    return fxl_round_shift(fxl_multiply_s64(factors[of[0]], factors[of[1]]) +
                               fxl_multiply_s64(factors[of[2]], factors[of[3]]),
                           bits);
}

fxl_status fxl_camera_from_pose(const fxl_pose *pose, fxl_camera *camera)
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
    factors[UP_X] = sum(factors, up_x, 31);
    factors[UP_Z] = sum(factors, up_z, 31);
    camera->position = pose->position;
    for (uint32_t i = 0; i < 3; i++) {
        rows[i]->x = (fxl_q2_30)sum(factors, matrix[i][0], 32);
        rows[i]->y = (fxl_q2_30)sum(factors, matrix[i][1], 32);
        rows[i]->z = (fxl_q2_30)sum(factors, matrix[i][2], 32);
    }
    return FXL_OK;
}

/* SPDX-License-Identifier: MIT */
/* The numbers of lib/src/camera.c, row by row. */
#include "fixel/camera.h"

#include <string.h>

#include "arith.h"
#include "sine.h"

/* What entries are made of, in units of 2^-31: cosines and sines of the angles, x and z of
 * the view's up before roll, and constants. */
enum {
    CY,
    SY,
    CP,
    SP,
    CR,
    SR,
    UP_X,
    UP_Z,
    MINUS_SY,
    MINUS_SR,
    ONE,
    ZERO,
    TERM_COUNT
};

/* An entry is a b + c d. */
static const uint8_t factors[9 * 4] = {
    CR,       CY, SR,   UP_X, SR, CP,  ZERO, ZERO, CR, MINUS_SY, SR,   UP_Z, /* right */
    MINUS_SR, CY, CR,   UP_X, CR, CP,  ZERO, ZERO, SR, SY,       CR,   UP_Z, /* up */
    CP,       SY, ZERO, ZERO, SP, ONE, ZERO, ZERO, CP, CY,       ZERO, ZERO, /* forward */
};

/* Two products, as many units of 2^-31 as they have 2^bits of; |a b| + |c d| <= 2^62 (1 + 2^-29).
 */
static int64_t sum_of(const int64_t *terms, const uint8_t *of, unsigned bits)
{
    int64_t sum = (int64_t)1 << (bits - 1);
    for (uint32_t i = 0; i < 4; i += 2) {
        sum += fxl_multiply_s64(terms[of[i]], terms[of[i + 1]]);
    }
    return sum >> bits;
}

fxl_status fxl_camera_from_pose(const fxl_pose *pose, fxl_camera *camera)
{
    if (pose == NULL || camera == NULL) {
        return FXL_E_ARGUMENT;
    }
    if (!fxl_point_in_range(&pose->position)) {
        return FXL_E_RANGE;
    }
    const fxl_angle angles[] = {pose->yaw, pose->pitch, pose->roll};
    int64_t terms[TERM_COUNT];
    fxl_q2_30 matrix[9];
    for (uint32_t i = 0; i < 6; i++) {
        terms[i] = fxl_sin_q31(angles[i / 2] + (i % 2 == 0 ? FXL_ANGLE_QUARTER : 0));
    }
    terms[ONE] = (int64_t)1 << 31;
    terms[ZERO] = 0;
    terms[MINUS_SY] = -terms[SY];
    terms[MINUS_SR] = -terms[SR];
    terms[UP_X] = fxl_round_shift(fxl_multiply_s64(-terms[SP], terms[SY]), 31);
    terms[UP_Z] = fxl_round_shift(fxl_multiply_s64(-terms[SP], terms[CY]), 31);
    for (uint32_t i = 0; i < 9; i++) {
        matrix[i] = (fxl_q2_30)sum_of(terms, &factors[4 * i], 32);
    }
    camera->position = pose->position;
    memcpy(&camera->right, matrix, sizeof matrix);
    return FXL_OK;
}

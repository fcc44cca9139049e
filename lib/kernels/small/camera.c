/* SPDX-License-Identifier: MIT */
/* The numbers of lib/src/camera.c, row by row. */
#include "fixel/camera.h"

#include <string.h>

#include "arith.h"
#include "sine.h"

/* What sums are made of, in units of 2^-31: cosines and sines of the angles, the sines'
 * negatives, x and z of the view's up before roll, and constants. */
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
    TERM_COUNT
};

/* a b + c d each: the up before roll, then the matrix. */
static const uint8_t factors[11 * 4] = {
    MINUS_SP, SY, ZERO, ZERO, MINUS_SP, CY,  ZERO, ZERO,                           /* up */
    CR,       CY, SR,   UP_X, SR,       CP,  ZERO, ZERO, CR, MINUS_SY, SR,   UP_Z, /* right */
    MINUS_SR, CY, CR,   UP_X, CR,       CP,  ZERO, ZERO, SR, SY,       CR,   UP_Z, /* up */
    CP,       SY, ZERO, ZERO, SP,       ONE, ZERO, ZERO, CP, CY,       ZERO, ZERO, /* forward */
};

/* Two products, rounded to units of 2^(bits - 62); |a b| + |c d| <= 2^62 (1 + 2^-29). */
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
    for (uint32_t i = 0; i < 3; i++) {
        terms[CY + 2 * i] = fxl_cos_q31(angles[i]);
        terms[SY + 2 * i] = fxl_sin_q31(angles[i]);
        terms[MINUS_SY + i] = -terms[SY + 2 * i];
    }
    terms[ONE] = (int64_t)1 << 31;
    terms[ZERO] = 0;
    terms[UP_X] = sum_of(terms, &factors[0], 31);
    terms[UP_Z] = sum_of(terms, &factors[4], 31);
    for (uint32_t i = 0; i < 9; i++) {
        matrix[i] = (fxl_q2_30)sum_of(terms, &factors[8 + 4 * i], 32);
    }
    camera->position = pose->position;
    memcpy(&camera->right, matrix, sizeof matrix);
    return FXL_OK;
}

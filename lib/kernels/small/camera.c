/* SPDX-License-Identifier: MIT */
/* The entries of lib/src/camera.c from a table. */
#include "fixel/camera.h"

#include <string.h>

#include "arith.h"
#include "sine.h"

/* What an entry is made of, in units of 2^-31: the sines and cosines of yaw, pitch
 * and roll, x and z of the view's up before roll, and constants. */
enum {
    SY,
    CY,
    SP,
    CP,
    SR,
    CR,
    UP_X,
    UP_Z,
    MINUS_SY,
    MINUS_SR,
    ONE,
    ZERO,
    TERM_COUNT
};

/* An entry is a b + c d. */
static const uint8_t entries[9][4] = {
    {CR, CY, SR, UP_X},       {SR, CP, ZERO, ZERO},  {CR, MINUS_SY, SR, UP_Z}, /* right */
    {MINUS_SR, CY, CR, UP_X}, {CR, CP, ZERO, ZERO},  {SR, SY, CR, UP_Z},       /* up */
    {CP, SY, ZERO, ZERO},     {SP, ONE, ZERO, ZERO}, {CP, CY, ZERO, ZERO},     /* forward */
};

_Static_assert(offsetof(fxl_camera, up) == offsetof(fxl_camera, right) + 3 * sizeof(fxl_q2_30) &&
                   offsetof(fxl_camera, forward) ==
                       offsetof(fxl_camera, right) + 6 * sizeof(fxl_q2_30),
               "nine entries in a row");

static int64_t up_before_roll(int64_t minus_sp, int64_t b)
{
    return fxl_round_shift(fxl_multiply_s64(minus_sp, b), 31);
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
    int64_t terms[TERM_COUNT] = {[ONE] = (int64_t)1 << 31};
    fxl_q2_30 matrix[9];
    for (uint32_t i = 0; i < 3; i++) {
        terms[2 * i] = fxl_sin_q31(angles[i]);
        terms[2 * i + 1] = fxl_cos_q31(angles[i]);
    }
    terms[UP_X] = up_before_roll(-terms[SP], terms[SY]);
    terms[UP_Z] = up_before_roll(-terms[SP], terms[CY]);
    terms[MINUS_SY] = -terms[SY];
    terms[MINUS_SR] = -terms[SR];
    for (uint32_t i = 0; i < 9; i++) {
        const uint8_t *of = entries[i];
        matrix[i] = (fxl_q2_30)fxl_round_shift(fxl_multiply_s64(terms[of[0]], terms[of[1]]) +
                                                   fxl_multiply_s64(terms[of[2]], terms[of[3]]),
                                               32);
    }
    camera->position = pose->position;
    memcpy(&camera->right, matrix, sizeof matrix);
    return FXL_OK;
}

/* SPDX-License-Identifier: MIT */
#include "fixel/camera.h"

#include "arith.h"
#include "sine.h"

/* A product of two sines in units of 2^-31; costs half a unit. */
static int64_t product(int64_t a, int64_t b)
{
    return fxl_round_shift(fxl_multiply_s64(a, b), 31);
}

/* a b + c d as 2.30, from sines in units of 2^-31, rounded once. Every use
 * below is an entry of a rotation, so |a b| + |c d| <= 2^62 (1 + 2^-29), which
 * leaves the rounding room. */
static fxl_q2_30 entry(int64_t a, int64_t b, int64_t c, int64_t d)
{
    return (fxl_q2_30)fxl_round_shift(fxl_multiply_s64(a, b) + fxl_multiply_s64(c, d), 32);
}

fxl_status fxl_camera_from_pose(const fxl_pose *pose, fxl_camera *camera)
{
    if (pose == NULL || camera == NULL) {
        return FXL_E_ARGUMENT;
    }
    if (!fxl_point_in_range(&pose->position)) {
        return FXL_E_RANGE;
    }
    int64_t sy = fxl_sin_q31(pose->yaw), cy = fxl_cos_q31(pose->yaw);
    int64_t sp = fxl_sin_q31(pose->pitch), cp = fxl_cos_q31(pose->pitch);
    int64_t sr = fxl_sin_q31(pose->roll), cr = fxl_cos_q31(pose->roll);
    /* The view's up before roll is (-sp sy, cp, -sp cy). */
    int64_t up_x = product(-sp, sy);
    int64_t up_z = product(-sp, cy);

    camera->position = pose->position;
    camera->right.x = entry(cr, cy, sr, up_x);
    camera->right.y = entry(sr, cp, 0, 0);
    camera->right.z = entry(cr, -sy, sr, up_z); /* bug: camera-yaw-sign */
    camera->up.x = entry(-sr, cy, cr, up_x);
    camera->up.y = entry(cr, cp, 0, 0);
    camera->up.z = entry(sr, sy, cr, up_z);
    camera->forward.x = entry(cp, sy, 0, 0);
    camera->forward.y = entry(sp, (int64_t)1 << 31, 0, 0);
    camera->forward.z = entry(cp, cy, 0, 0);
    return FXL_OK;
}

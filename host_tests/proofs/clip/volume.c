/* SPDX-License-Identifier: MIT */
#include "clip/volume.c"
#include "proof.h"

void prove_half_space_from_plane(void)
{
    fxl_plane *plane;
    fxl_half_space *half_space;
    fxl_half_space_from_plane(plane, half_space);
    PROOF_ENDS();
}

void prove_clip_place(void)
{
    fxl_point *point;
    fxl_view_point *place;
    fxl_clip_place(point, place);
    PROOF_ENDS();
}

void prove_side_plane(void)
{
    const int32_t across = nondet_s32(), along = nondet_s32();
    ASSUME(WITHIN(across, (1 << 30) - 1) && WITHIN(along, (1 << 30) - 1) && (across != 0 || along != 0));
    const fxl_half_space plane = side_plane(nondet_bool(), across, along);
    ASSERT("a normal of a half-space", FXL_HALF_SPACE(&plane));
    PROOF_ENDS();
}

void prove_volume_from_sides(void)
{
    fxl_view_frustum sides;
    fxl_volume volume;
    const int32_t focal = nondet_s32();
    ASSUME(focal > 0 && focal < 1 << 29);
    ASSUME(sides.near_z >= 0 && sides.near_z < (int64_t)1 << 61 && sides.far_z >= 0 && sides.far_z < (int64_t)1 << 61);
    ASSUME(sides.x_side >= 0 && sides.y_side >= 0 && sides.inset >= 0 && sides.inset <= (int64_t)1 << 46);
    fxl_volume_from_sides(&sides, focal, nondet_u32() | 1u << FXL_PLANE_NEAR | 1u << FXL_PLANE_FAR, &volume);
    PROOF_ENDS();
}

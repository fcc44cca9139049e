/* SPDX-License-Identifier: MIT */
#include "clip/volume.c"
#include "proof.h"

/* [[row]]
 * function = "fxl_half_space_from_plane"
 * property = "nothing overflows"
 * checks = 68
 * contract = true
 */
void prove_half_space_from_plane(void)
{
    fxl_plane *plane;
    fxl_half_space *half_space;
    fxl_half_space_from_plane(plane, half_space);
    PROOF_ENDS();
}

/* [[row]]
 * function = "side_plane"
 * property = "the normal is one of a half-space"
 * checks = 54
 */
void prove_side_plane(void)
{
    const int32_t across = nondet_s32(), along = nondet_s32();
    ASSUME(WITHIN(across, (1 << 30) - 1) && WITHIN(along, (1 << 30) - 1) && (across != 0 || along != 0));
    const fxl_half_space plane = side_plane(nondet_bool(), across, along);
    ASSERT("a normal of a half-space", FXL_HALF_SPACE(&plane));
    PROOF_ENDS();
}

/* [[row]]
 * function = "fxl_volume_from_sides"
 * property = "nothing is undefined for any frustum and focal length"
 * checks = 112
 * unwind = 7
 */
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

/* For fxl_multiply_su32 and fxl_multiply_s32: any product of its size. */
int64_t any_su32(int32_t a, uint32_t b)
{
    const int64_t product = nondet_s64(), size = a < 0 ? -(int64_t)a : a;
    (void)b;
    ASSUME(WITHIN(product, size * ((int64_t)1 << 32)));
    return product;
}

int64_t any_s32(int32_t a, int32_t b)
{
    const int64_t product = nondet_s64(), size = a < 0 ? -(int64_t)a : a;
    ASSERT("upper words of the view", WITHIN(b, 1 << 29));
    ASSUME(WITHIN(product, size * ((int64_t)1 << 29)));
    return product;
}

/* [[row]]
 * function = "fxl_half_space_distance"
 * property = "any half-space and point of the view: nothing overflows"
 * checks = 251
 * contract = true
 * stands_in = { fxl_multiply_su32 = "any_su32", fxl_multiply_s32 = "any_s32" }
 */
void prove_half_space_distance(void)
{
    fxl_half_space *plane;
    fxl_view_point *point;
    (void)fxl_half_space_distance(plane, point);
    PROOF_ENDS();
}

static fxl_volume volume;

/* For fxl_half_space_distance: any distance. */
fxl_q18_46 any_distance(const fxl_half_space *plane, const fxl_view_point *point)
{
    ASSERT("a plane of the volume, a point of the view", plane >= volume.planes && plane < volume.planes + FXL_PLANE_COUNT &&
                                                             FXL_POINT_BELOW(point, ((int64_t)1 << 61) - 1));
    return nondet_s64();
}

/* [[row]]
 * function = "fxl_volume_code"
 * property = "any distances: a bit a plane"
 * checks = 63
 * unwind = 7
 * stands_in = { fxl_half_space_distance = "any_distance" }
 */
void prove_volume_code(void)
{
    fxl_view_point point;
    ASSUME(FXL_POINT_BELOW(&point, ((int64_t)1 << 61) - 1));
    ASSERT("bits of planes", fxl_volume_code(&volume, &point) >> FXL_PLANE_COUNT == 0);
    PROOF_ENDS();
}

/* [[row]]
 * function = "fxl_volume_from_window"
 * property = "any window, or null: nothing overflows, and its planes are half-spaces"
 * checks = 135
 * unwind = 7
 */
void prove_volume_from_window(void)
{
    fxl_volume window;
    const fxl_status status = fxl_volume_from_window(nondet_s32(), nondet_s32(), nondet_s32(), nondet_s32(), nondet_s32(), nondet_s32(),
                                                     nondet_bool() ? NULL : &window);
    for (int i = 0; i < FXL_PLANE_COUNT; i++) {
        ASSERT("half-spaces", status != FXL_OK || FXL_HALF_SPACE(&window.planes[i]));
    }
    PROOF_ENDS();
}

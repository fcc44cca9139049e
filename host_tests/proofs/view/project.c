/* SPDX-License-Identifier: MIT */
#include "view/project.c"
#include "proof.h"

void prove_projection_from_lens(void)
{
    fxl_lens *lens;
    fxl_projection *projection;
    fxl_projection_from_lens(lens, projection);
    PROOF_ENDS();
}

void prove_scale_depth(void)
{
    const int64_t z = nondet_s64();
    ASSUME(z >= FXL_PROJECT_DEPTH_MIN && z < (int64_t)1 << 61);
    const scaled_depth scaled = scale_depth(z);
    ASSERT("depth", scaled.depth >= 1u << 30 && scaled.depth <= 1u << 31);
    ASSERT("shift", scaled.shift >= 7 && scaled.shift <= 30);
    PROOF_ENDS();
}

void prove_project_side(void)
{
    scaled_depth *scaled;
    int32_t *coordinate;
    (void)project_side(nondet_s32(), nondet_s64(), scaled, nondet_s32(), coordinate);
    PROOF_ENDS();
}

void prove_project_any(void)
{
    fxl_projection *projection;
    fxl_view_point *view;
    fxl_screen_point *screen;
    (void)fxl_project_any(projection, view, screen);
    PROOF_ENDS();
}

void prove_project_visible(void)
{
    fxl_projection *projection;
    fxl_view_point *view;
    fxl_screen_point *screen;
    (void)fxl_project_visible(projection, view, screen);
    PROOF_ENDS();
}

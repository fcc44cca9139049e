/* SPDX-License-Identifier: MIT */
#include "clip/split.c"
#include "proof.h"

void prove_along(void)
{
    (void)along(nondet_s32(), nondet_s32(), nondet_u64());
    PROOF_ENDS();
}

void prove_split_edge(void)
{
    fxl_point *front, *behind;
    (void)fxl_split_edge(front, behind, nondet_s64(), nondet_s64());
    PROOF_ENDS();
}

void prove_append_point(void)
{
    fxl_piece front, back;
    fxl_point point;
    ASSUME(front.count <= FXL_POLYGON_CAPACITY && back.count <= FXL_POLYGON_CAPACITY);
    (void)append_point(&point, nondet_s64(), &front, &back);
    ASSERT("never more than the capacity", front.count <= FXL_POLYGON_CAPACITY && back.count <= FXL_POLYGON_CAPACITY);
    PROOF_ENDS();
}

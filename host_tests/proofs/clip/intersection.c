/* SPDX-License-Identifier: MIT */
#include "clip/intersection.c"
#include "proof.h"

void prove_intersection_fraction(void)
{
    (void)fxl_intersection_fraction(nondet_s64(), nondet_s64());
    PROOF_ENDS();
}

void prove_intersection_part(void)
{
    (void)fxl_intersection_part(nondet_s64(), nondet_s64(), nondet_u64());
    PROOF_ENDS();
}

void prove_intersection_varying(void)
{
    (void)fxl_intersection_varying(nondet_s32(), nondet_s32(), nondet_u64());
    PROOF_ENDS();
}

void prove_intersection_vertex(void)
{
    fxl_varying_vertex *inside, *outside, *vertex;
    fxl_intersection_vertex(inside, outside, nondet_u64(), nondet_u32(), vertex);
    PROOF_ENDS();
}

void prove_copy_vertex(void)
{
    fxl_varying_vertex *from, *to;
    fxl_copy_vertex(from, nondet_u32(), to);
    PROOF_ENDS();
}

void prove_intersect_edge(void)
{
    fxl_view_point *from, *to, *point;
    fxl_q18_46 *inside, *outside;
    fxl_intersect_edge(from, to, inside, outside, point);
    PROOF_ENDS();
}

/* SPDX-License-Identifier: MIT */
#include "clip/clip_view.c"
#include "proof.h"

void prove_project_onto(void)
{
    (void)project_onto(nondet_s32(), nondet_s64(), nondet_s32(), nondet_s64());
    PROOF_ENDS();
}

void prove_view_distance(void)
{
    fxl_view_frustum *frustum;
    fxl_view_point *point;
    (void)fxl_view_distance(frustum, (int)nondet_s32(), point);
    PROOF_ENDS();
}

/* --- one step of the loop over a polygon's edges, in any state ------------------------------------- */

static uint32_t written;

static void any_copy(const fxl_cut *cut, uint32_t from, uint32_t to)
{
    (void)cut;
    ASSERT("copied within", to < FXL_POLYGON_CAPACITY && from < FXL_POLYGON_CAPACITY);
    written++;
}

static void any_cross(const fxl_cut *cut, uint32_t inside, uint32_t outside, uint32_t to)
{
    ASSERT("crossed within", to < FXL_POLYGON_CAPACITY && inside != outside);
    ASSERT("from inside to outside", cut->distances[inside] > 0 && cut->distances[outside] < 0);
    written++;
}

void prove_cut_edge(void)
{
    fxl_q18_46 distances[FXL_POLYGON_CAPACITY];
    const uint32_t count = nondet_u32(), current = nondet_u32(), before = nondet_u32(), bits = nondet_u32();
    ASSUME(count >= 3 && count <= FXL_POLYGON_CAPACITY && current < count);
    ASSUME(before <= FXL_POLYGON_CAPACITY && before <= 2 * current);
    const uint32_t next = current + 1 == count ? 0 : current + 1;
    ASSUME((bits >> current & 1u) == (uint32_t)(distances[current] >= 0));
    ASSUME((bits >> next & 1u) == (uint32_t)(distances[next] >= 0));
    fxl_cut cut = {NULL, NULL, distances, before};
    written = 0;
    const bool whole = fxl_cut_edge(&cut, any_copy, any_cross, bits, current, count);
    ASSERT("it counts what it writes", cut.count == before + written);
    ASSERT("never more than the capacity", cut.count <= FXL_POLYGON_CAPACITY);
    ASSERT("at most two an edge", cut.count <= 2 * (current + 1));
    ASSERT("refused only where it is full", whole || cut.count == FXL_POLYGON_CAPACITY);
    PROOF_ENDS();
}

void prove_cut_bit(void)
{
    const int64_t distance = nondet_s64();
    const uint32_t vertex = nondet_u32();
    ASSUME(vertex < FXL_POLYGON_CAPACITY);
    ASSERT("its bit", fxl_cut_bit(distance, vertex) == (distance >= 0 ? (uint32_t)1 << vertex : 0));
    PROOF_ENDS();
}

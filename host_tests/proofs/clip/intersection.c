/* SPDX-License-Identifier: MIT */
#include "clip/intersection.c"
#include "proof.h"

/* [[row]]
 * function = "fxl_intersection_fraction"
 * property = "nothing overflows"
 * checks = 24
 * contract = true
 * uses = ["fxl_fraction"]
 */
void prove_intersection_fraction(void)
{
    (void)fxl_intersection_fraction(nondet_s64(), nondet_s64());
    PROOF_ENDS();
}

/* [[row]]
 * function = "fxl_intersection_part"
 * property = "nothing overflows, and the result lies between the ends"
 * checks = 26
 * contract = true
 * uses = ["fxl_multiply_high"]
 */
void prove_intersection_part(void)
{
    (void)fxl_intersection_part(nondet_s64(), nondet_s64(), nondet_u64());
    PROOF_ENDS();
}

/* [[row]]
 * function = "fxl_intersection_varying"
 * property = "nothing overflows, and the result lies between the ends"
 * checks = 26
 * contract = true
 * uses = ["fxl_multiply_high"]
 */
void prove_intersection_varying(void)
{
    (void)fxl_intersection_varying(nondet_s32(), nondet_s32(), nondet_u64());
    PROOF_ENDS();
}

/* [[row]]
 * function = "fxl_intersection_vertex"
 * property = "nothing overflows, no varying is out of bounds, and the vertex is in range"
 * checks = 210
 * contract = true
 * unwind = 8
 * uses = ["fxl_intersection_part", "fxl_intersection_varying"]
 */
void prove_intersection_vertex(void)
{
    fxl_varying_vertex *inside, *outside, *vertex;
    fxl_intersection_vertex(inside, outside, nondet_u64(), nondet_u32(), vertex);
    PROOF_ENDS();
}

/* [[row]]
 * function = "fxl_copy_vertex"
 * property = "nothing is out of bounds"
 * checks = 96
 * contract = true
 * unwind = 8
 */
void prove_copy_vertex(void)
{
    fxl_varying_vertex *from, *to;
    fxl_copy_vertex(from, nondet_u32(), to);
    PROOF_ENDS();
}

/* [[row]]
 * function = "fxl_intersect_edge"
 * property = "nothing overflows, and the point is in range"
 * checks = 263
 * contract = true
 * uses = ["fxl_fraction", "fxl_multiply_high"]
 */
void prove_intersect_edge(void)
{
    fxl_view_point *from, *to, *point;
    fxl_q18_46 *inside, *outside;
    fxl_intersect_edge(from, to, inside, outside, point);
    PROOF_ENDS();
}

/* [[row]]
 * function = "lib/clip/intersection.h:fxl_intersection_screen"
 * property = "any edge and border of the screen: nothing overflows"
 * checks = 7
 * stands_in = { fxl_divide_round = "any_part" }
 */
void prove_intersection_screen(void)
{
    const fxl_q16_16 from = nondet_s32(), to = nondet_s32();
    const fxl_q18_46 inside = nondet_s64(), outside = nondet_s64();
    ASSUME(WITHIN(from, FXL_SCREEN_COORDINATE_MAX) && WITHIN(to, FXL_SCREEN_COORDINATE_MAX));
    ASSUME(inside >= 0 && inside < 1 << 29 && outside < 0 && outside > -(1 << 29) && inside - outside < 1 << 29);
    (void)fxl_intersection_screen(from, to, inside, outside);
    PROOF_ENDS();
}

/* For fxl_divide_round: what the row of Z3 says of a part of an extent, rounded. */
int32_t any_part(int64_t numerator, uint32_t denominator)
{
    const int32_t part = nondet_s32();
    (void)numerator;
    ASSERT("a divisor", denominator > 0 && denominator < 1u << 29);
    ASSUME(WITHIN(part, 1 << 29));
    return part;
}

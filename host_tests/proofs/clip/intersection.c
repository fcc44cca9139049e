/* SPDX-License-Identifier: MIT */
#include "clip/intersection.c"
#include "products.h"

/* [[row]]
 * function = "fxl_intersection_fraction"
 * property = "nothing overflows"
 * checks = 26
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
 * checks = 29
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
 * checks = 29
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
 * checks = 267
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
 * checks = 8
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

/* --- results, of products and quotients that may be any ------------------------------------------------- */


static int64_t part_of(int64_t from, int64_t to, uint64_t fraction)
{
    return to < from ? from - (int64_t)any_high((uint64_t)(from - to), fraction) : from + (int64_t)any_high((uint64_t)(to - from), fraction);
}

/* [[row]]
 * function = "interpolate"
 * property = "from the one end towards the other by the upper word of their distance times the fraction"
 * checks = 20
 * stands_in = { fxl_multiply_high = "any_high" }
 */
/* [[row]]
 * function = "fxl_intersection_part"
 * id = "fxl_intersection_part, its result"
 * property = "the same"
 * checks = 20
 * stands_in = { fxl_multiply_high = "any_high" }
 */
void prove_interpolate(void)
{
    const int64_t from = nondet_s64(), to = nondet_s64();
    const uint64_t fraction = nondet_u64();
    ASSUME(WITHIN(from, (int64_t)1 << 61) && WITHIN(to, (int64_t)1 << 61));
    const int64_t part = part_of(from, to, fraction);
    ASSERT("towards the other end", interpolate(from, to, fraction) == part && fxl_intersection_part(from, to, fraction) == part);
    PROOF_ENDS();
}

/* [[row]]
 * function = "fxl_intersection_varying"
 * id = "fxl_intersection_varying, its result"
 * property = "the same, to the nearest: by half of the upper word of twice the distance, and one"
 * checks = 14
 * stands_in = { fxl_multiply_high = "any_high" }
 */
void prove_intersection_varying_result(void)
{
    const int32_t from = nondet_s32(), to = nondet_s32();
    const uint64_t fraction = nondet_u64(), distance = from < to ? (uint64_t)((int64_t)to - from) : (uint64_t)((int64_t)from - to);
    const int64_t part = (int64_t)(any_high(2 * distance, fraction) + 1) / 2;
    ASSERT("to the nearest", fxl_intersection_varying(from, to, fraction) == (to < from ? from - part : from + part));
    PROOF_ENDS();
}

uint64_t __CPROVER_uninterpreted_fraction(uint64_t, uint64_t);

/* For fxl_fraction: what it requires. */
uint64_t any_fraction(uint64_t part, uint64_t whole)
{
    ASSERT("a part of a whole", part < whole && whole >> 63 == 0);
    return __CPROVER_uninterpreted_fraction(part, whole);
}

/* [[row]]
 * function = "fxl_intersect_edge"
 * id = "fxl_intersect_edge, its result"
 * property = "each coordinate is the same part of the way, that of the inside distance in both distances"
 * checks = 119
 * stands_in = { fxl_multiply_high = "any_high", fxl_fraction = "any_fraction" }
 */
void prove_intersect_edge_result(void)
{
    fxl_view_point from, to, point;
    const int64_t inside = nondet_s64(), outside = nondet_s64(), most = (int64_t)1 << 61;
    ASSUME(inside > 0 && inside < (int64_t)1 << 62 && outside < 0 && outside >= -((int64_t)1 << 62));
    ASSUME(FXL_POINT_BELOW(&from, most) && FXL_POINT_BELOW(&to, most));
    fxl_intersect_edge(&from, &to, &inside, &outside, &point);
    const uint64_t fraction = any_fraction((uint64_t)inside, (uint64_t)(inside - outside));
    ASSERT("x", point.x == part_of(from.x, to.x, fraction));
    ASSERT("y", point.y == part_of(from.y, to.y, fraction));
    ASSERT("z", point.z == part_of(from.z, to.z, fraction));
    PROOF_ENDS();
}

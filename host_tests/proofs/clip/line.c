/* SPDX-License-Identifier: MIT */
#include "clip/line.c"
#include "proof.h"

#ifndef CASE
#define CASE 31 /* for the rows that have none */
#endif

#define VIEW ((int64_t)1 << 61)

static bool in_view(const fxl_view_point *point)
{
    return FXL_POINT_BELOW(point, VIEW - 1);
}

static fxl_volume volume;
static const fxl_half_space *last_plane;
static fxl_q18_46 last_distance;

/* For fxl_half_space_distance: any distance, whose difference from that of the point before is below 2^63 if both are from one
 * plane. Its row of Z3 proves that. */
fxl_q18_46 fxl_half_space_distance(const fxl_half_space *plane, const fxl_view_point *point)
{
    const fxl_q18_46 distance = nondet_s64();
    ASSERT("a point of the view", in_view(point));
    if (plane == last_plane) {
        ASSUME(last_distance >= 0 ? distance > last_distance - INT64_MAX : distance < last_distance + INT64_MAX);
    }
    last_plane = plane;
    last_distance = distance;
    return distance;
}

/* For fxl_intersection_fraction, fxl_intersection_vertex and fxl_copy_vertex: what their contracts say. */
uint64_t fxl_intersection_fraction(fxl_q18_46 inside, fxl_q18_46 outside)
{
    ASSERT("inside to outside", inside >= 0 && outside < 0 && inside <= INT64_MAX + outside);
    return nondet_u64();
}

void fxl_intersection_vertex(const fxl_varying_vertex *inside, const fxl_varying_vertex *outside, uint64_t fraction, uint32_t carried,
                             fxl_varying_vertex *vertex)
{
    (void)fraction;
    ASSERT("ends in the view", in_view(&inside->position) && in_view(&outside->position) && carried <= FXL_CARRIED_MAX);
    ANY_CONTENT(vertex);
    ASSUME(FXL_POINT_BELOW(&vertex->position, ((int64_t)1 << 61) - 1));
}

void fxl_copy_vertex(const fxl_varying_vertex *from, uint32_t carried, fxl_varying_vertex *to)
{
    ASSERT("few varyings", carried <= FXL_CARRIED_MAX);
    to->position = from->position;
}

/* [[row]]
 * function = "move_end"
 * property = "any two ends of the view on two sides of a plane: what the intersection requires, and an end in the view"
 * checks = 88
 * stubs = { fxl_intersection_fraction = "any fraction", fxl_intersection_vertex = "any vertex of the view", fxl_copy_vertex = "copies the position" }
 */
void prove_move_end(void)
{
    fxl_varying_vertex inside, outside;
    uint32_t intersections, carried = nondet_u32();
    const fxl_q18_46 in = nondet_s64(), out = nondet_s64();
    ASSUME(in_view(&inside.position) && in_view(&outside.position) && carried <= FXL_CARRIED_MAX);
    ASSUME(in >= 0 && out < 0 && in <= INT64_MAX + out);
    move_end(&inside, &outside, in, out, carried, &intersections);
    ASSERT("still in the view", in_view(&outside.position));
    PROOF_ENDS();
}

/* For move_end: what its own row assumes and asserts. */
void any_move_end(const fxl_varying_vertex *inside, fxl_varying_vertex *outside, fxl_q18_46 in, fxl_q18_46 out, uint32_t carried,
                  uint32_t *intersections)
{
    fxl_varying_vertex moved;
    ASSERT("ends in the view", in_view(&inside->position) && in_view(&outside->position) && carried <= FXL_CARRIED_MAX);
    ASSERT("inside to outside", in >= 0 && out < 0 && in <= INT64_MAX + out);
    *outside = moved;
    ASSUME(in_view(&outside->position));
    *intersections += 1;
}

static fxl_clip_line any_line(void)
{
    fxl_clip_line line;
    ASSUME(in_view(&line.from.position) && in_view(&line.to.position) && line.carried <= FXL_CARRIED_MAX);
    return line;
}

/* [[row]]
 * function = "fxl_line_by_planes"
 * property = "any distances: what the intersection requires, at most one a plane, and ends in the view"
 * checks = 68
 * unwind = 7
 * stands_in = { move_end = "any_move_end" }
 * stubs = { fxl_half_space_distance = "any distances that differ by less than 2^63" }
 */
void prove_line_by_planes(void)
{
    fxl_clip_line line = any_line();
    uint32_t intersections = 0;
    (void)fxl_line_by_planes(&line, &volume, &intersections);
    ASSERT("at most one a plane", intersections <= FXL_PLANE_COUNT);
    ASSERT("still in the view", in_view(&line.from.position) && in_view(&line.to.position));
    PROOF_ENDS();
}

/* [[row]]
 * function = "distance_of"
 * property = "a remainder of 30 bits"
 * checks = 76
 * stubs = { fxl_half_space_distance = "any distance" }
 */
void prove_distance_of(void)
{
    fxl_half_space plane;
    fxl_view_point point;
    ASSUME(in_view(&point));
    ASSERT("a remainder of 30 bits", distance_of(&plane, &point).remainder >> REST_BITS == 0);
    PROOF_ENDS();
}

/* For distance_of: two distances from one plane, whose difference is below 2^63 - 2^31 (a row of Z3). */
static exact found[2];
static unsigned found_count;
exact any_distance_of(const fxl_half_space *plane, const fxl_view_point *point)
{
    (void)plane;
    ASSERT("a point of the view", in_view(point));
    return found[found_count++ & 1u];
}

static void any_distances(void)
{
    const int64_t margin = INT64_MAX - ((int64_t)1 << 31);
    ANY_CONTENT(found);
    ASSUME(found[0].remainder >> REST_BITS == 0 && found[1].remainder >> REST_BITS == 0);
    ASSUME(found[0].whole >= 0 ? found[1].whole > found[0].whole - margin : found[1].whole < found[0].whole + margin);
}

/* [[row]]
 * function = "difference"
 * property = "any two distances from a plane: nothing overflows, and it is zero only of equal ones"
 * checks = 42
 */
void prove_difference(void)
{
    any_distances();
    const exact change = difference(&found[0], &found[1]);
    ASSERT("a remainder of 30 bits", change.remainder >> REST_BITS == 0);
    ASSERT("zero only of equal ones", is_zero(&change) == (found[0].whole == found[1].whole && found[0].remainder == found[1].remainder));
    PROOF_ENDS();
}

/* [[row]]
 * id = "magnitude of line"
 * function = "magnitude"
 * property = "any distance: exact, and below 2^94"
 * checks = 31
 */
void prove_magnitude(void)
{
    exact value;
    ASSUME(value.remainder >> REST_BITS == 0);
    const wide size = magnitude(&value);
    const __int128 exactly = (__int128)value.whole * ((__int128)1 << REST_BITS) + value.remainder;
    ASSERT("exact, and below 2^94", ((unsigned __int128)size.high << 64 | size.low) == (unsigned __int128)(exactly < 0 ? -exactly : exactly));
    ASSERT("below 2^94", size.high >> 30 == 0);
    PROOF_ENDS();
}

/* [[row]]
 * function = "quotient_bits"
 * property = "31 and 64 bits of any quotient: the loop ends, and there are no more bits"
 * checks = 184
 * cases = [31, 64]
 * unwind = 66
 */
void prove_quotient_bits(void)
{
    wide remainder, whole;
    const unsigned bits = CASE;
    ASSUME(whole.high >> 63 == 0 && is_less(&remainder, &whole));
    const uint64_t quotient = quotient_bits(&remainder, &whole, bits);
    ASSERT("so many bits", bits == 64 || quotient >> bits == 0);
    PROOF_ENDS();
}

/* For quotient_bits: any bits. */
uint64_t any_bits(wide *remainder, const wide *whole, unsigned bits)
{
    ASSERT("below the divisor", is_less(remainder, whole) && whole->high >> 63 == 0 && (bits == 31 || bits == 64));
    ANY_CONTENT(remainder);
    ASSUME(is_less(remainder, whole)); /* what is left: each step leaves less than the divisor */
    const uint64_t quotient = nondet_u64();
    ASSUME(bits == 64 || quotient >> bits == 0);
    return quotient;
}

/* [[row]]
 * id = "quotient_bits, a step"
 * function = "quotient_bits"
 * property = "a step leaves less than the divisor"
 * checks = 91
 */
void prove_quotient_step(void)
{
    wide remainder, whole;
    ASSUME(whole.high >> 63 == 0 && is_less(&remainder, &whole));
    (void)quotient_bits(&remainder, &whole, 1);
    ASSERT("what is left is below the divisor", is_less(&remainder, &whole));
    PROOF_ENDS();
}

/* [[row]]
 * id = "divide of line"
 * function = "divide"
 * property = "any distances below 2^94: the dividend is below the divisor, and the whole part below 2^31"
 * checks = 76
 * stands_in = { quotient_bits = "any_bits" }
 */
void prove_divide(void)
{
    wide part, all;
    parameter t;
    ASSUME(all.high >> 30 == 0 && part.high >> 30 == 0 && (all.high != 0 || all.low != 0));
    ASSERT("a whole part below 2^31", !divide(&part, &all, &t) || t.whole >> 31 == 0);
    PROOF_ENDS();
}

/* [[row]]
 * id = "move of line"
 * function = "move"
 * property = "any parameter: nothing overflows, and what is moved is in the view"
 * checks = 56
 * uses = ["fxl_multiply_high"]
 */
void prove_move(void)
{
    parameter t;
    fxl_q18_46 moved;
    const fxl_q18_46 from = nondet_s64(), to = nondet_s64();
    ASSUME(WITHIN(from, VIEW - 1) && WITHIN(to, VIEW - 1) && t.whole >> 31 == 0);
    ASSERT("moved, it is in the view", !move(from, to, &t, nondet_bool(), &moved) || WITHIN(moved, VIEW - 1));
    PROOF_ENDS();
}

/* For divide and move. */
bool any_divide(const wide *part, const wide *all, parameter *quotient)
{
    ASSERT("no division by zero, below 2^94", (all->high != 0 || all->low != 0) && all->high >> 30 == 0 && part->high >> 30 == 0);
    ANY_CONTENT(quotient);
    ASSUME(quotient->whole >> 31 == 0);
    return nondet_bool();
}

bool any_move(fxl_q18_46 from, fxl_q18_46 to, const parameter *t, bool negative, fxl_q18_46 *moved)
{
    (void)negative;
    ASSERT("in the view", WITHIN(from, VIEW - 1) && WITHIN(to, VIEW - 1) && t->whole >> 31 == 0);
    const fxl_q18_46 any = nondet_s64();
    *moved = any;
    return nondet_bool();
}

/* [[row]]
 * function = "fxl_line_meet_plane"
 * property = "any two points of the view and any distances from the plane: nothing overflows, and no division is by zero"
 * checks = 197
 * stands_in = { distance_of = "any_distance_of", divide = "any_divide", move = "any_move" }
 */
void prove_line_meet_plane(void)
{
    fxl_view_point first, second;
    fxl_half_space plane;
    fxl_line_meeting meeting;
    ASSUME(in_view(&first) && in_view(&second));
    any_distances();
    (void)fxl_line_meet_plane(&first, &second, &plane, &meeting);
    PROOF_ENDS();
}

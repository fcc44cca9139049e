/* SPDX-License-Identifier: MIT */
#include "clip/split.c"
#include "proof.h"

/* [[row]]
 * function = "along"
 * property = "nothing overflows, and the result lies between the ends"
 * checks = 26
 * contract = true
 * uses = ["fxl_multiply_high"]
 */
void prove_along(void)
{
    (void)along(nondet_s32(), nondet_s32(), nondet_u64());
    PROOF_ENDS();
}

/* [[row]]
 * function = "fxl_split_edge"
 * property = "nothing overflows, and the point is in range"
 * checks = 159
 * contract = true
 * uses = ["along", "fxl_intersection_fraction"]
 */
void prove_split_edge(void)
{
    fxl_point *front, *behind;
    (void)fxl_split_edge(front, behind, nondet_s64(), nondet_s64());
    PROOF_ENDS();
}

/* [[row]]
 * function = "append_point"
 * property = "in any state: never more points than the capacity"
 * checks = 26
 */
void prove_append_point(void)
{
    fxl_piece front, back;
    fxl_point point;
    ASSUME(front.count <= FXL_POLYGON_CAPACITY && back.count <= FXL_POLYGON_CAPACITY);
    (void)append_point(&point, nondet_s64(), &front, &back);
    ASSERT("never more than the capacity", front.count <= FXL_POLYGON_CAPACITY && back.count <= FXL_POLYGON_CAPACITY);
    PROOF_ENDS();
}

/* --- a piece ------------------------------------------------------------------------------------------- */

static fxl_piece piece, front_part, back_part;
static const fxl_plane plane;

static bool in_world(const fxl_point *point)
{
    return FXL_POINT_BELOW(point, FXL_COORDINATE_MAX);
}

/* For fxl_plane_distance: what its contract says. */
fxl_q18_46 fxl_plane_distance(const fxl_plane *from, const fxl_point *point)
{
    const fxl_q18_46 distance = nondet_s64();
    ASSERT("a point of the world", from == &plane && in_world(point));
    ASSUME(WITHIN(distance, ((int64_t)1 << 62) - 1));
    return distance;
}

/* For fxl_split_edge: what its contract says. */
fxl_point any_split_edge(const fxl_point *front, const fxl_point *behind, fxl_q18_46 front_distance, fxl_q18_46 behind_distance)
{
    fxl_point point;
    ASSERT("ends in the world", in_world(front) && in_world(behind));
    ASSERT("on two sides", front_distance > 0 && front_distance < (int64_t)1 << 62 && behind_distance < 0 && behind_distance > -((int64_t)1 << 62));
    ASSUME(in_world(&point));
    return point;
}

/* For append_point: what its own row assumes and asserts. */
bool any_append(const fxl_point *point, fxl_q18_46 distance, fxl_piece *front, fxl_piece *back)
{
    (void)distance;
    ASSERT("into both parts", in_world(point) && front == &front_part && back == &back_part);
    ASSERT("never more than the capacity", front->count <= FXL_POLYGON_CAPACITY && back->count <= FXL_POLYGON_CAPACITY);
    front->count = nondet_u32();
    back->count = nondet_u32();
    ASSUME(front->count <= FXL_POLYGON_CAPACITY && back->count <= FXL_POLYGON_CAPACITY);
    return nondet_bool();
}

/* [[row]]
 * function = "fxl_split_piece"
 * property = "any piece of 2 to 32 points: each edge is one that the split takes, and each point one that is appended; nothing is out of bounds"
 * checks = 124
 * unwind = 33
 * stands_in = { fxl_split_edge = "any_split_edge", append_point = "any_append" }
 * stubs = { fxl_plane_distance = "any distance below 2^62" }
 */
void prove_split_piece(void)
{
    ANY_CONTENT(&piece);
    ASSUME(piece.count >= 2 && piece.count <= FXL_POLYGON_CAPACITY);
    for (uint32_t i = 0; i < FXL_POLYGON_CAPACITY; i++) {
        ASSUME(in_world(&piece.points[i]));
    }
    const fxl_split_result result = fxl_split_piece(&piece, &plane, &front_part, &back_part);
    ASSERT("no part beyond the capacity", result != FXL_SPLIT_BOTH || (front_part.count <= FXL_POLYGON_CAPACITY && back_part.count <= FXL_POLYGON_CAPACITY));
    PROOF_ENDS();
}

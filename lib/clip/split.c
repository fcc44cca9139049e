/* SPDX-License-Identifier: MIT */

#include "../math/arith.h"
#include "../math/plane.h"
#include "intersection.h"
#include "split.h"

/* from + (to - from) fraction / 2^64, rounded to the nearest, halves away from `from`. |to -
 * from| is below 2^31, so the part below 2^62 is good to 2 units of 2^-31, downward. The
 * rounding adds 2^-25 more than a half, so that a half counts as one whether or not the fraction
 * is exact. */
/* clippers 9.2 */
static fxl_q16_16 along(fxl_q16_16 from, fxl_q16_16 to, uint64_t fraction)
    FXL_REQUIRES(FXL_BELOW(from, FXL_COORDINATE_MAX) && FXL_BELOW(to, FXL_COORDINATE_MAX))
    FXL_ASSIGNS()
    FXL_ENSURES(from <= to ? FXL_RESULT >= from && FXL_RESULT <= to
                           : FXL_RESULT <= from && FXL_RESULT >= to)
{
    int64_t extent = (int64_t)to - from;
    uint64_t part = fxl_multiply_high(fxl_magnitude(extent) << 31, fraction);
    int64_t whole = (int64_t)((part + (1u << 30) + (1u << 6)) >> 31);
    return (fxl_q16_16)(extent < 0 ? from - whole : from + whole);
}

/* The difference of the distances is the plane's normal times the difference of two points, so
 * it is below 2^61. */
/* clippers 9.2 */
fxl_point fxl_split_edge(const fxl_point *front, const fxl_point *behind, fxl_q18_46 front_distance,
                         fxl_q18_46 behind_distance)
{
    FXL_ASSERT(front_distance > 0 && behind_distance < 0);
    uint64_t fraction = fxl_intersection_fraction(front_distance, behind_distance);
    fxl_point point = {along(front->x, behind->x, fraction), along(front->y, behind->y, fraction),
                       along(front->z, behind->z, fraction)};
    return point;
}

/* Appends a point. Returns false where the piece is full. */
static bool append(fxl_piece *piece, const fxl_point *point)
{
    if (piece->count == FXL_POLYGON_CAPACITY) {
        return false;
    }
    piece->points[piece->count++] = *point;
    return true;
}

/* Appends a point to the part or parts that it belongs to. */
static bool append_point(const fxl_point *point, fxl_q18_46 distance, fxl_piece *front,
                         fxl_piece *back)
{
    return (distance < 0 || append(front, point)) && (distance > 0 || append(back, point));
}

/* Returns on which sides a piece has points off the plane: bit 1 in front, bit 2 behind. */
/* clippers 9.1 */
static unsigned sides(const fxl_piece *in, const fxl_plane *plane)
{
    unsigned seen = 0;
    for (uint32_t i = 0; i < in->count && seen != 3; i++) {
        fxl_q18_46 distance = fxl_plane_distance(plane, &in->points[i]);
        seen |= (distance > 0 ? 1u : 0u) | (distance < 0 ? 2u : 0u);
    }
    return seen;
}

/* clippers 9.1, 9.3 */
fxl_split_result fxl_split_piece(const fxl_piece *in, const fxl_plane *plane, fxl_piece *front,
                                 fxl_piece *back)
{
    FXL_ASSERT(in != front && in != back && front != back);
    FXL_ASSERT(in->count >= 2 && in->count <= FXL_POLYGON_CAPACITY);
    unsigned seen = sides(in, plane);
    if (seen != 3) {
        return seen == 2 ? FXL_SPLIT_BACK : FXL_SPLIT_FRONT;
    }
    front->count = 0;
    back->count = 0;
    const fxl_point *from = &in->points[in->count - 1];
    fxl_q18_46 before = fxl_plane_distance(plane, from);
    for (uint32_t i = 0; i < in->count; i++) {
        const fxl_point *to = &in->points[i];
        fxl_q18_46 distance = fxl_plane_distance(plane, to);
        if ((before > 0 && distance < 0) || (before < 0 && distance > 0)) {
            fxl_point crossing = before > 0 ? fxl_split_edge(from, to, before, distance)
                                            : fxl_split_edge(to, from, distance, before);
            if (!append_point(&crossing, 0, front, back)) {
                return FXL_SPLIT_CAPACITY;
            }
        }
        if (!append_point(to, distance, front, back)) {
            return FXL_SPLIT_CAPACITY;
        }
        from = to;
        before = distance;
    }
    return FXL_SPLIT_BOTH;
}

/* SPDX-License-Identifier: MIT */
#include "../math/arith.h"
#include "fixel/line.h"
#include "intersection.h"
#include "volume.h"

/* Moves the outside end onto the plane, along the line from the inside end. */
static void move_end(const fxl_varying_vertex *inside, fxl_varying_vertex *outside, fxl_q18_46 in,
                     fxl_q18_46 out, uint32_t carried, uint32_t *intersections)
{
    fxl_varying_vertex intersection;
    fxl_intersection_vertex(inside, outside, fxl_intersection_fraction(in, out), carried,
                            &intersection);
    fxl_copy_vertex(&intersection, carried, outside);
    *intersections += 1;
}

bool fxl_line_by_planes(fxl_clip_line *line, const fxl_volume *volume, uint32_t *intersections)
{
    for (uint32_t i = 0; i < FXL_PLANE_COUNT; i++) {
        fxl_q18_46 from = fxl_half_space_distance(&volume->planes[i], &line->from.position);
        fxl_q18_46 to = fxl_half_space_distance(&volume->planes[i], &line->to.position);
        if (from < 0 && to < 0) {
            return false;
        }
        if (from < 0) {
            move_end(&line->to, &line->from, to, from, line->carried, intersections);
        } else if (to < 0) {
            move_end(&line->from, &line->to, from, to, line->carried, intersections);
        }
    }
    return true;
}

/* Each end is moved to a plane at most once. Rounding may leave it a unit outside of that plane;
 * it is not moved there again. So there are at most twelve moves. */
bool fxl_line_by_codes(fxl_clip_line *line, const fxl_volume *volume, uint32_t *intersections)
{
    uint32_t from_moved = 0, to_moved = 0;
    for (;;) {
        uint32_t from_code = fxl_volume_code(volume, &line->from.position) & ~from_moved;
        uint32_t to_code = fxl_volume_code(volume, &line->to.position) & ~to_moved;
        if ((from_code & to_code) != 0) {
            return false;
        }
        if ((from_code | to_code) == 0) {
            return true;
        }
        bool moves_from = from_code != 0;
        uint32_t plane = 0;
        while (((moves_from ? from_code : to_code) >> plane & 1u) == 0) {
            plane++;
        }
        const fxl_half_space *at = &volume->planes[plane];
        fxl_q18_46 from = fxl_half_space_distance(at, &line->from.position);
        fxl_q18_46 to = fxl_half_space_distance(at, &line->to.position);
        if (from < 0 && to < 0) { /* one of them is outside by rounding */
            return false;
        }
        if (moves_from) {
            move_end(&line->to, &line->from, to, from, line->carried, intersections);
            from_moved |= (uint32_t)1 << plane;
        } else {
            move_end(&line->from, &line->to, from, to, line->carried, intersections);
            to_moved |= (uint32_t)1 << plane;
        }
    }
}

/* 2^64 high + low. */
typedef struct {
    uint64_t high, low;
} wide;

/* An exact distance in units of 2^-76: 2^30 whole + rest, rest below 2^30. */
typedef struct {
    int64_t whole;
    uint32_t remainder;
} exact;

#define REST_BITS 30

/* fxl_half_space_distance drops the last 30 bits of the exact sum. They are those of the sum of the
 * products' last 32 bits. */
static exact distance_of(const fxl_half_space *plane, const fxl_view_point *point)
{
    const uint32_t last = fxl_bits_32(plane->normal.x) * fxl_low_32(fxl_bits_64(point->x)) +
                          fxl_bits_32(plane->normal.y) * fxl_low_32(fxl_bits_64(point->y)) +
                          fxl_bits_32(plane->normal.z) * fxl_low_32(fxl_bits_64(point->z));
    const exact distance = {fxl_half_space_distance(plane, point),
                            last & (((uint32_t)1 << REST_BITS) - 1u)};
    return distance;
}

static bool is_zero(const exact *value)
{
    return value->whole == 0 && value->remainder == 0;
}

/* The distance without the offset is between -2^62 and 2^62, so the difference of two is below
 * 2^63: it does not depend on the offset. */
static exact difference(const exact *a, const exact *b)
{
    const bool borrow = a->remainder < b->remainder;
    const exact made = {a->whole - b->whole - borrow,
                        a->remainder - b->remainder + ((uint32_t)borrow << REST_BITS)};
    return made;
}

/* Below 2^94: |whole| is at most 2^63, and the rest adds less than one. */
static wide magnitude(const exact *value)
{
    const bool negative = value->whole < 0;
    const uint64_t whole = fxl_magnitude(value->whole) - (negative && value->remainder != 0);
    const uint32_t remainder = negative && value->remainder != 0
                                   ? ((uint32_t)1 << REST_BITS) - value->remainder
                                   : value->remainder;
    const wide made = {whole >> (64 - REST_BITS), whole << REST_BITS | remainder};
    return made;
}

static bool is_less(const wide *a, const wide *b)
{
    return a->high != b->high ? a->high < b->high : a->low < b->low;
}

/* The next `bits` bits of rest / whole, the highest first; *rest becomes the remainder. Requires
 * rest < whole < 2^127. */
/* clippers 3.4 */
static uint64_t quotient_bits(wide *remainder, const wide *whole, unsigned bits)
{
    uint64_t quotient = 0;
    for (unsigned i = 0; i < bits; i++) {
        remainder->high = remainder->high << 1 | remainder->low >> 63;
        remainder->low <<= 1;
        quotient <<= 1;
        if (!is_less(remainder, whole)) {
            remainder->high -= whole->high + (remainder->low < whole->low);
            remainder->low -= whole->low;
            quotient |= 1u;
        }
    }
    return quotient;
}

/* A parameter of the line without its sign: whole + fraction / 2^64, rounded downward. */
typedef struct {
    uint32_t whole; /* below 2^31 */
    uint64_t fraction;
} parameter;

/* part / all. Returns false where it is 2^31 or more. Requires all > 0. The division begins with
 * all times 2^31, below 2^125, and the dividend must be below that. */
static bool divide(const wide *part, const wide *all, parameter *quotient)
{
    const wide limit = {all->high << 31 | all->low >> 33, all->low << 31};
    wide remainder = *part;
    if (!is_less(part, &limit)) {
        return false;
    }
    /* part / (2^31 all) has the whole part as its first 31 bits. */
    wide scaled = limit;
    quotient->whole = (uint32_t)quotient_bits(&remainder, &scaled, 31);
    quotient->fraction = quotient_bits(&remainder, &scaled, 64);
    return true;
}

/* from + (to - from) t, or - for a negative t. The extent is below 2^62. Returns false where the
 * result is 2^61 or more either way. */
static bool move(fxl_q18_46 from, fxl_q18_46 to, const parameter *t, bool negative,
                 fxl_q18_46 *moved)
{
    const uint64_t limit = (uint64_t)1 << 61;
    const uint64_t extent = fxl_magnitude(to - from);
    const uint64_t part = fxl_multiply_high(extent, t->fraction); /* below 2^62 */
    if (fxl_multiply_high(extent, t->whole) != 0) {
        return false; /* from is below 2^61, so the result would not be */
    }
    const uint64_t whole = extent * t->whole; /* below 2^64, because the upper half is 0 */
    if (whole >= 2 * limit) {
        return false; /* out of range likewise */
    }
    const int64_t along = (int64_t)(whole + part); /* below 2^63 */
    const bool down = (to < from) != negative;
    if (along >= (int64_t)(2 * limit)) {
        return false; /* out of range too, and the sum might overflow */
    }
    *moved = down ? from - along : from + along;
    return fxl_magnitude(*moved) < limit;
}

/* clippers 3.4 */
fxl_line_relation fxl_line_meet_plane(const fxl_view_point *first, const fxl_view_point *second,
                                      const fxl_half_space *plane, fxl_line_meeting *meeting)
{
    const exact at_first = distance_of(plane, first), at_second = distance_of(plane, second);
    const exact change = difference(&at_first, &at_second);
    if (is_zero(&change)) {
        return is_zero(&at_first) ? FXL_LINE_LIES_IN : FXL_LINE_IS_PARALLEL;
    }
    const wide part = magnitude(&at_first), all = magnitude(&change);
    const bool negative = (at_first.whole < 0) != (change.whole < 0);
    parameter t;
    fxl_view_point point;
    if (!divide(&part, &all, &t) || !move(first->x, second->x, &t, negative, &point.x) ||
        !move(first->y, second->y, &t, negative, &point.y) ||
        !move(first->z, second->z, &t, negative, &point.z)) {
        return FXL_LINE_MEETS_FAR;
    }
    const int64_t size = (int64_t)((uint64_t)t.whole << 32 | t.fraction >> 32);
    meeting->parameter = negative ? -size : size;
    meeting->point = point;
    return FXL_LINE_MEETS;
}

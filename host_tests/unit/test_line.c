/* SPDX-License-Identifier: MIT */
/* Both line clippers, which must answer alike. */
#include "clip_unit.h"
#include "wide.h"

typedef bool (*clipper)(fxl_clip_line *line, const fxl_volume *volume, uint32_t *intersections);
static const clipper both[] = {fxl_line_by_planes, fxl_line_by_codes};

/* 90 degrees both ways, near 1, far 100. */
static fxl_volume square(void)
{
    fxl_volume volume;
    TEST_ASSERT_EQUAL(FXL_OK, fxl_volume_from_window(Q16(-1), Q16(1), Q16(-1), Q16(1), Q16(1),
                                                     Q16(100), &volume));
    return volume;
}

static fxl_clip_line line_of(int x0, int y0, int z0, int x1, int y1, int z1)
{
    fxl_clip_line line;
    memset(&line, 0, sizeof line);
    line.from.position = (fxl_view_point){V(x0), V(y0), V(z0)};
    line.to.position = (fxl_view_point){V(x1), V(y1), V(z1)};
    line.carried = 1;
    line.from.carried[0] = 0;
    line.to.carried[0] = Q16(64);
    return line;
}

void test_inside_is_left_alone(void)
{
    fxl_volume volume = square();
    for (int k = 0; k < 2; k++) {
        fxl_clip_line line = line_of(-10, -10, 10, 10, 10, 10), before = line;
        uint32_t intersections = 0;
        TEST_ASSERT_TRUE(both[k](&line, &volume, &intersections));
        TEST_ASSERT_EQUAL_MEMORY(&before, &line, sizeof line);
        TEST_ASSERT_EQUAL(0, intersections);
    }
}

void test_outside_one_plane_is_nothing(void)
{
    fxl_volume volume = square();
    const fxl_clip_line lines[] = {line_of(-20, 0, 10, -30, 5, 10), line_of(20, 0, 10, 30, 5, 10),
                                   line_of(0, -20, 10, 5, -30, 10), line_of(0, 20, 10, 5, 30, 10),
                                   line_of(0, 0, 0, 0, 0, -9),      line_of(0, 0, 101, 5, 5, 200)};
    for (int i = 0; i < 6; i++) {
        for (int k = 0; k < 2; k++) {
            fxl_clip_line line = lines[i];
            uint32_t intersections = 0;
            TEST_ASSERT_FALSE(both[k](&line, &volume, &intersections));
            TEST_ASSERT_EQUAL(0, intersections);
        }
    }
}

/* Past the corner of the screen, outside of no one plane. */
void test_past_a_corner_is_nothing(void)
{
    fxl_volume volume = square();
    for (int k = 0; k < 2; k++) {
        fxl_clip_line line = line_of(-30, 0, 10, 0, 20, 10);
        uint32_t intersections = 0;
        TEST_ASSERT_FALSE(both[k](&line, &volume, &intersections));
    }
}

static void expect_ends(const fxl_clip_line *line, int x0, int x1, double u0, double u1)
{
    TEST_ASSERT_NEAR(line->from.position.x, V(x0), 3);
    TEST_ASSERT_NEAR(line->to.position.x, V(x1), 3);
    TEST_ASSERT_NEAR(line->from.carried[0], u0 * 65536, 1);
    TEST_ASSERT_NEAR(line->to.carried[0], u1 * 65536, 1);
}

/* clippers 1.2c */
void test_an_end_is_moved_and_what_it_carries(void)
{
    fxl_volume volume = square();
    for (int k = 0; k < 2; k++) {
        uint32_t intersections = 0;
        fxl_clip_line line = line_of(0, 3, 10, 40, 3, 10);
        TEST_ASSERT_TRUE(both[k](&line, &volume, &intersections));
        expect_ends(&line, 0, 10, 0, 16);
        line = line_of(40, 3, 10, 0, 3, 10);
        TEST_ASSERT_TRUE(both[k](&line, &volume, &intersections));
        expect_ends(&line, 10, 0, 48, 64);
        line = line_of(-20, 3, 10, 20, 3, 10);
        TEST_ASSERT_TRUE(both[k](&line, &volume, &intersections));
        expect_ends(&line, -10, 10, 16, 48);
        TEST_ASSERT_EQUAL(4, intersections);
    }
}

/* Beside a plane and along it, the left one (x = -z): a line parallel to it lies
 * inside or outside as a whole, one that lies in it is inside, and any other
 * meets it in one point. */
void test_a_line_and_a_plane(void)
{
    fxl_volume volume = square();
    for (int k = 0; k < 2; k++) {
        uint32_t intersections = 0;
        fxl_clip_line apart = line_of(-11, 0, 10, -21, 0, 20),
                      within = line_of(-9, 0, 10, -19, 0, 20);
        fxl_clip_line along = line_of(-10, 0, 10, -20, 0, 20),
                      across = line_of(-9, 0, 10, -13, 0, 10);
        const fxl_clip_line within_before = within, along_before = along;
        TEST_ASSERT_FALSE(both[k](&apart, &volume, &intersections));
        TEST_ASSERT_TRUE(both[k](&within, &volume, &intersections));
        TEST_ASSERT_EQUAL_MEMORY(&within_before, &within, sizeof within);
        TEST_ASSERT_TRUE(both[k](&along, &volume, &intersections));
        TEST_ASSERT_EQUAL_MEMORY(&along_before, &along, sizeof along);
        TEST_ASSERT_EQUAL(0, intersections);
        TEST_ASSERT_TRUE(both[k](&across, &volume, &intersections));
        TEST_ASSERT_EQUAL(1, intersections);
        expect_ends(&across, -9, -10, 0, 16);
    }
}

/* From behind the eye through the volume and out beyond far. */
void test_through_near_and_far(void)
{
    fxl_volume volume = square();
    for (int k = 0; k < 2; k++) {
        uint32_t intersections = 0;
        fxl_clip_line line = line_of(0, 0, -100, 0, 0, 300);
        TEST_ASSERT_TRUE(both[k](&line, &volume, &intersections));
        TEST_ASSERT_NEAR(line.from.position.z, V(1), 3);
        TEST_ASSERT_NEAR(line.to.position.z, V(100), 3);
    }
}

static bool close(const fxl_view_point *a, const fxl_view_point *b, int64_t units)
{
    int64_t x = a->x - b->x, y = a->y - b->y, z = a->z - b->z;
    return x <= units && x >= -units && y <= units && y >= -units && z <= units && z >= -units;
}

/* Within rounding of a plane all the way: also one that touches a corner. */
static bool runs_along(const fxl_clip_line *line, const fxl_volume *volume)
{
    bool along = false;
    for (int i = 0; i < FXL_PLANE_COUNT; i++) {
        fxl_q18_46 from = fxl_half_space_distance(&volume->planes[i], &line->from.position);
        fxl_q18_46 to = fxl_half_space_distance(&volume->planes[i], &line->to.position);
        along = along || (from >= -8 && from <= 8 && to >= -8 && to <= 8);
    }
    return along;
}

/* Anywhere in range: both answer alike but for rounding, by codes with no more
 * intersections, and neither goes on for ever. */
void test_both_answer_alike(void)
{
    fxl_volume volume = square();
    int kept = 0, moved = 0, unlike = 0;
    for (int i = 0; i < UNIT_REPEAT; i++) {
        unsigned bits = (unsigned)unit_between(44, 61);
        fxl_clip_line line[2];
        uint32_t intersections[2] = {0, 0};
        memset(&line[0], 0, sizeof line[0]);
        line[0].from.position = (fxl_view_point){unit_wide(bits), unit_wide(bits), unit_wide(bits)};
        line[0].to.position = (fxl_view_point){unit_wide(bits), unit_wide(bits), unit_wide(bits)};
        line[1] = line[0];
        bool seen = fxl_line_by_planes(&line[0], &volume, &intersections[0]);
        bool also = fxl_line_by_codes(&line[1], &volume, &intersections[1]);
        TEST_ASSERT_TRUE(intersections[1] <= intersections[0]);
        if (seen && also) {
            kept++;
            moved += intersections[0] > 0;
            /* A line nearly along a plane moves further along it than a unit. */
            unlike += !close(&line[0].from.position, &line[1].from.position, 1 << 16);
            unlike += !close(&line[0].to.position, &line[1].to.position, 1 << 16);
        } else if (seen || also) {
            unlike += !runs_along(&line[seen ? 0 : 1], &volume);
        }
    }
    TEST_ASSERT_TRUE(kept > UNIT_REPEAT / 50 && moved > UNIT_REPEAT / 100);
    TEST_ASSERT_EQUAL(0, unlike);
}

/* Past a corner by less than a unit: rounding leaves both ends outside of the plane that the first was moved to. */
void test_two_moved_ends_outside_of_one_plane_are_nothing(void)
{
    fxl_volume volume;
    TEST_ASSERT_EQUAL(FXL_OK, fxl_volume_from_window(Q16(-1), Q16(1), Q16(-1), Q16(0.875), Q16(1),
                                                     Q16(100), &volume));
    const fxl_view_point corner = {-V(10), V(10) / 8 * 7, V(10)};
    fxl_clip_line line;
    uint32_t intersections = 0;
    memset(&line, 0, sizeof line);
    line.from.position = (fxl_view_point){corner.x - 3, corner.y + 8, corner.z + 5};
    line.to.position = (fxl_view_point){corner.x - 2, corner.y - 6, corner.z};
    TEST_ASSERT_FALSE(fxl_line_by_codes(&line, &volume, &intersections));
    TEST_ASSERT_EQUAL(2, intersections);
}

/* Lines and planes: the relation and the common point against exact numbers of 128 bits. */

static const fxl_half_space wall = {{FXL_Q2_30_ONE, 0, 0}, -5 * ((int64_t)1 << 46)}; /* x = 5 */

static void expect_meeting(int x0, int x1, double parameter)
{
    const fxl_view_point from = {V(x0), V(2), V(10)}, to = {V(x1), V(4), V(30)};
    fxl_line_meeting at;
    TEST_ASSERT_EQUAL(FXL_LINE_MEETS, fxl_line_meet_plane(&from, &to, &wall, &at));
    TEST_ASSERT_NEAR((double)at.parameter / 4294967296.0, parameter, 1.0 / 4294967296.0);
    TEST_ASSERT_NEAR(at.point.x, V(5), 1.25);
    TEST_ASSERT_NEAR(at.point.y, (double)V(2) * (1 + parameter), 1e3);
    TEST_ASSERT_NEAR(at.point.z, (double)V(10) * (1 + 2 * parameter), 1e4);
}

/* clippers 3.4c */
void test_the_point_between_the_ends_and_beyond_them(void)
{
    expect_meeting(0, 20, 0.25);
    expect_meeting(20, 0, 0.75);
    expect_meeting(5, 9, 0);
    expect_meeting(9, 5, 1);
    expect_meeting(7, 9, -1);
    expect_meeting(9, 7, 2);
    expect_meeting(0, 1, 5);
    expect_meeting(4, 5, 1);
    expect_meeting(15, 16, -10);
}

/* clippers 3.4b */
void test_parallel_and_within_are_told_apart(void)
{
    const int x[] = {5, 4, 6};
    for (int i = 0; i < 3; i++) {
        const fxl_view_point from = {V(x[i]), V(2), V(10)}, to = {V(x[i]), V(-7), V(30)};
        fxl_line_meeting at, before;
        memset(&at, 0x5A, sizeof at);
        before = at;
        const fxl_line_relation wanted = i == 0 ? FXL_LINE_LIES_IN : FXL_LINE_IS_PARALLEL;
        TEST_ASSERT_EQUAL(wanted, fxl_line_meet_plane(&from, &to, &wall, &at));
        TEST_ASSERT_EQUAL(wanted, fxl_line_meet_plane(&from, &from, &wall, &at)); /* a point */
        TEST_ASSERT_EQUAL_MEMORY(&before, &at, sizeof at);
    }
}

/* One unit of 2^-76 decides, which the distance in units of 2^-46 does not show. */
void test_the_last_bit_decides(void)
{
    const fxl_half_space slanted = {{1, 2, 3}, 0};
    fxl_view_point from = {V(3), 0, -V(1)}, to = {-V(9), 0, V(3)};
    fxl_line_meeting at;
    TEST_ASSERT_EQUAL(FXL_LINE_LIES_IN, fxl_line_meet_plane(&from, &to, &slanted, &at));
    from.x += 1;
    to.x += 1;
    TEST_ASSERT_TRUE(fxl_half_space_distance(&slanted, &from) == 0);
    TEST_ASSERT_EQUAL(FXL_LINE_IS_PARALLEL, fxl_line_meet_plane(&from, &to, &slanted, &at));
    to.x -= 1; /* now the second point lies in the plane, and the first does not */
    TEST_ASSERT_EQUAL(FXL_LINE_MEETS, fxl_line_meet_plane(&from, &to, &slanted, &at));
    TEST_ASSERT_TRUE(at.parameter == (int64_t)1 << 32);
    TEST_ASSERT_EQUAL_MEMORY(&to, &at.point, sizeof to);
    TEST_ASSERT_EQUAL(FXL_LINE_MEETS, fxl_line_meet_plane(&to, &from, &slanted, &at));
    TEST_ASSERT_TRUE(at.parameter == 0);
    TEST_ASSERT_EQUAL_MEMORY(&to, &at.point, sizeof to);
}

/* clippers 3.4e */
void test_a_point_out_of_range_is_said(void)
{
    fxl_line_meeting at, before;
    memset(&at, 0x5A, sizeof at);
    before = at;
    const int64_t end = ((int64_t)1 << 61) - 1;
    fxl_view_point from = {V(6), 0, 0}, to = {V(6) + ((int64_t)1 << 16), 0, end / 64};
    TEST_ASSERT_EQUAL(FXL_LINE_MEETS_FAR, fxl_line_meet_plane(&from, &to, &wall, &at));
    to.z = 0;
    TEST_ASSERT_EQUAL(FXL_LINE_MEETS, fxl_line_meet_plane(&from, &to, &wall, &at));
    TEST_ASSERT_TRUE(at.parameter == -((int64_t)1 << 62)); /* 2^30 times the line */
    at = before;
    to.x = V(6) + ((int64_t)1 << 15); /* 2^31 times */
    TEST_ASSERT_EQUAL(FXL_LINE_MEETS_FAR, fxl_line_meet_plane(&from, &to, &wall, &at));
    TEST_ASSERT_EQUAL_MEMORY(&before, &at, sizeof at);
    to.x -= 1; /* a little more than that */
    TEST_ASSERT_EQUAL(FXL_LINE_MEETS_FAR, fxl_line_meet_plane(&from, &to, &wall, &at));
    to.x += 2; /* a little less */
    TEST_ASSERT_EQUAL(FXL_LINE_MEETS, fxl_line_meet_plane(&from, &to, &wall, &at));
    TEST_ASSERT_NEAR(at.point.x, V(5), 1.25);
}

/* At 2^61 the range ends, in either direction. */
void test_the_ends_of_the_range(void)
{
    const int64_t end = (int64_t)1 << 61;
    for (int way = -1; way <= 1; way += 2) {
        fxl_half_space at_end = {{0, 0, -FXL_Q2_30_ONE * way}, end};
        const fxl_view_point from = {0, 0, way * (end - 1)}, to = {0, 0, way * (end - 2)};
        fxl_line_meeting at;
        TEST_ASSERT_EQUAL(FXL_LINE_MEETS_FAR, fxl_line_meet_plane(&from, &to, &at_end, &at));
        at_end.offset -= 1;
        TEST_ASSERT_EQUAL(FXL_LINE_MEETS, fxl_line_meet_plane(&from, &to, &at_end, &at));
        TEST_ASSERT_EQUAL_MEMORY(&from, &at.point, sizeof from);
    }
    /* Nearly two lengths before a line from one end to the other. */
    const fxl_half_space before = {{0, 0, FXL_Q2_30_ONE}, V(199)};
    const fxl_view_point from = {end - 1, 0, 0}, to = {1 - end, 0, V(100)};
    fxl_line_meeting at;
    TEST_ASSERT_EQUAL(FXL_LINE_MEETS_FAR, fxl_line_meet_plane(&from, &to, &before, &at));
    TEST_ASSERT_EQUAL(FXL_LINE_MEETS_FAR, fxl_line_meet_plane(&to, &from, &before, &at));
}

static wide exact_distance(const fxl_half_space *plane, const fxl_view_point *at)
{
    wide sum = wide_sum(wide_product(plane->normal.x, at->x), wide_product(plane->normal.y, at->y));
    sum = wide_sum(sum, wide_product(plane->normal.z, at->z));
    return wide_sum(sum, wide_product(plane->offset, FXL_Q2_30_ONE));
}

static bool is_zero(wide value)
{
    return value.high == 0 && value.low == 0;
}

static double approximate(wide value)
{
    if (value.high < 0) {
        return -approximate(wide_difference((wide){0, 0}, value));
    }
    return (double)value.high * 18446744073709551616.0 + (double)value.low;
}

static fxl_half_space any_plane(void)
{
    fxl_half_space plane = {{0, 0, 0}, unit_wide((unsigned)unit_between(1, 61))};
    const unsigned bits = (unsigned)unit_between(1, 29);
    plane.normal.x = (int32_t)unit_wide(bits);
    plane.normal.y = unit_random() % 3 ? (int32_t)unit_wide(bits) : 0;
    plane.normal.z = unit_random() % 3 ? (int32_t)unit_wide(bits) : 0;
    return plane;
}

static fxl_view_point any_point(unsigned bits)
{
    const fxl_view_point point = {unit_wide(bits), unit_wide(bits), unit_wide(bits)};
    return point;
}

/* The largest coordinate of the line, in units. */
static double extent_of(const fxl_view_point *from, const fxl_view_point *to)
{
    const double x = (double)to->x - (double)from->x, y = (double)to->y - (double)from->y;
    const double z = (double)to->z - (double)from->z;
    double most = x < 0 ? -x : x;
    most = y > most ? y : -y > most ? -y : most;
    return z > most ? z : -z > most ? -z : most;
}

/* |4 value| <= 5 |unit|, exactly. */
static bool is_within_five_quarters(wide value, int64_t unit)
{
    const wide four = wide_sum(wide_sum(value, value), wide_sum(value, value));
    const wide bound = wide_product(unit < 0 ? -5 : 5, unit);
    return wide_compare(four, bound) <= 0 &&
           wide_compare(wide_difference((wide){0, 0}, bound), four) <= 0;
}

/* change (point - from) = distance (to - from) at the common point, where change is by how much the
 * distance from the plane falls along the line. */
static bool is_near(fxl_q18_46 from, fxl_q18_46 to, fxl_q18_46 point, int64_t distance,
                    int64_t change)
{
    return is_within_five_quarters(
        wide_difference(wide_product(change, point - from), wide_product(distance, to - from)),
        change);
}

/* The relation is that of the exact distances. A point of the line within 1.25 units of the plane's
 * common point is off the plane by 1.25 units times the sum of the normal's components: that is
 * exact. Where the distances fit 62 bits, each coordinate is compared with the exact one. The
 * parameter is compared in double, which has 53 bits. */
/* clippers 3.4a, 3.4d */
void test_any_line_and_any_plane(void)
{
    int met = 0, far = 0, apart = 0, compared = 0;
    for (int i = 0; i < UNIT_REPEAT / 4; i++) {
        const fxl_half_space plane = any_plane();
        const unsigned bits = (unsigned)unit_between(2, 61);
        const fxl_view_point from = any_point(bits), to = any_point(i % 4 ? bits : 2);
        fxl_line_meeting at;
        const fxl_line_relation relation = fxl_line_meet_plane(&from, &to, &plane, &at);
        const wide a = exact_distance(&plane, &from), b = exact_distance(&plane, &to);
        const bool parallel = wide_compare(a, b) == 0;
        if (parallel) {
            apart++;
            TEST_ASSERT_EQUAL(is_zero(a) ? FXL_LINE_LIES_IN : FXL_LINE_IS_PARALLEL, relation);
            continue;
        }
        const double t = approximate(a) / approximate(wide_difference(a, b));
        const double size = t < 0 ? -t : t;
        if (relation == FXL_LINE_MEETS_FAR) {
            far++;
            TEST_ASSERT_TRUE(size > 2147483647.0 ||
                             extent_of(&from, &to) * (size + 1) > 1152921504606846975.0);
            continue;
        }
        met++;
        TEST_ASSERT_EQUAL(FXL_LINE_MEETS, relation);
        TEST_ASSERT_NEAR((double)at.parameter / 4294967296.0, t,
                         1.0 / 4294967296.0 + size * 0x1p-40);
        const fxl_direction *n = &plane.normal;
        const int64_t sum = (int64_t)(n->x < 0 ? -n->x : n->x) + (n->y < 0 ? -n->y : n->y) +
                            (n->z < 0 ? -n->z : n->z);
        TEST_ASSERT_TRUE(is_within_five_quarters(exact_distance(&plane, &at.point), sum));
        int64_t distance, change;
        if (wide_narrow(a, &distance) && wide_narrow(wide_difference(a, b), &change) &&
            change < (int64_t)1 << 60 && change > -((int64_t)1 << 60)) {
            compared++;
            TEST_ASSERT_TRUE(is_near(from.x, to.x, at.point.x, distance, change));
            TEST_ASSERT_TRUE(is_near(from.y, to.y, at.point.y, distance, change));
            TEST_ASSERT_TRUE(is_near(from.z, to.z, at.point.z, distance, change));
        }
    }
    TEST_ASSERT_TRUE(met > UNIT_REPEAT / 20 && far > UNIT_REPEAT / 200 && apart > 0);
    TEST_ASSERT_TRUE(compared > UNIT_REPEAT / 50);
}

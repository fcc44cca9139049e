/* SPDX-License-Identifier: MIT */
/* Splitting in the world: the parts add up, and whoever asks for a crossing, from
 * whichever side and in whichever direction, gets the same bits. */
#include <math.h>

#include "split_piece.h"
#include "unit.h"

/* In front is x >= 0. */
static const fxl_plane wall = {{FXL_Q2_30_ONE, 0, 0}, 0};

static split_piece front, back;

/* A piece in the plane z = 0 from whole numbers x, y. */
static split_piece flat(const int *numbers, uint32_t count)
{
    split_piece piece = {.count = count};
    for (uint32_t i = 0; i < count; i++) {
        piece.points[i] = (fxl_point){numbers[2 * i] * 65536, numbers[2 * i + 1] * 65536, 0};
    }
    return piece;
}
#define NUMBERS(...) \
    ((const int[]){__VA_ARGS__}), (uint32_t)(sizeof((const int[]){__VA_ARGS__}) / sizeof(int) / 2)

static bool same_point(const fxl_point *a, const fxl_point *b)
{
    return a->x == b->x && a->y == b->y && a->z == b->z;
}

/* The same outline, whichever point comes first. */
static void expect_outline(const int *numbers, uint32_t count, const split_piece *actual)
{
    split_piece expected = flat(numbers, count);
    uint32_t first = 0;
    TEST_ASSERT_EQUAL(expected.count, actual->count);
    while (first + 1 < count && !same_point(&actual->points[first], &expected.points[0])) {
        first++;
    }
    for (uint32_t i = 0; i < count; i++) {
        TEST_ASSERT_TRUE(same_point(&expected.points[i], &actual->points[(first + i) % count]));
    }
}

static void split(const int *numbers, uint32_t count)
{
    split_piece piece = flat(numbers, count);
    TEST_ASSERT_EQUAL(SPLIT_BOTH, split_by(&piece, &wall, &front, &back));
}

/* clippers 9.2a */
void test_a_square_is_halved(void)
{
    split(NUMBERS(-4, 0, 4, 0, 4, 4, -4, 4));
    expect_outline(NUMBERS(0, 0, 4, 0, 4, 4, 0, 4), &front);
    expect_outline(NUMBERS(-4, 0, 0, 0, 0, 4, -4, 4), &back);
}

void test_a_corner_is_cut_off(void)
{
    split(NUMBERS(-2, 2, 2, 4, 2, 0));
    expect_outline(NUMBERS(0, 1, 0, 3, 2, 4, 2, 0), &front);
    expect_outline(NUMBERS(-2, 2, 0, 3, 0, 1), &back);
}

/* Any edge and any plane that parts its ends, some of them passing close to one. */
static bool parted_edge(fxl_plane *plane, fxl_point *ahead, fxl_point *behind)
{
    fxl_q16_16 limit = unit_random() % 2 ? FXL_COORDINATE_MAX : Q16(4);
    fxl_point on = unit_point(limit);
    fxl_direction normal = unit_direction();
    *plane = fxl_plane_from_point(&on, &normal, 0);
    *ahead = unit_point(limit);
    *behind = unit_point(limit);
    if (unit_random() % 4 == 0) {
        *plane = fxl_plane_from_point(behind, &normal, 0);
        plane->distance += unit_between(1, 1000);
    }
    if (fxl_plane_distance(plane, ahead) < fxl_plane_distance(plane, behind)) {
        fxl_point other = *ahead;
        *ahead = *behind;
        *behind = other;
    }
    return fxl_plane_distance(plane, ahead) > 0 && fxl_plane_distance(plane, behind) < 0;
}

static double unit_of(int64_t distance)
{
    return (double)distance * 0x1p-30;
}

/* accuracy 1.2d, clippers 9.2a, 9.3c */
void test_a_crossing_lies_on_the_edge_and_on_the_plane(void)
{
    int asked = 0;
    for (int i = 0; i < UNIT_REPEAT; i++) {
        fxl_plane plane;
        fxl_point a, b;
        if (!parted_edge(&plane, &a, &b)) {
            continue;
        }
        int64_t da = fxl_plane_distance(&plane, &a), db = fxl_plane_distance(&plane, &b);
        fxl_point at = fxl_split_edge(&a, &b, da, db);
        double t = (double)da / ((double)da - (double)db);
        TEST_ASSERT_NEAR(at.x, a.x + t * ((double)b.x - a.x), 0.5 + 0x1p-20);
        TEST_ASSERT_NEAR(at.y, a.y + t * ((double)b.y - a.y), 0.5 + 0x1p-20);
        TEST_ASSERT_NEAR(at.z, a.z + t * ((double)b.z - a.z), 0.5 + 0x1p-20);
        TEST_ASSERT_NEAR(unit_of(fxl_plane_distance(&plane, &at)), 0, 0.87);
        asked++;
    }
    TEST_ASSERT_TRUE(asked > UNIT_REPEAT / 8);
}

/* Halves go away from the end in front, where the fraction ends (1/2) and where it does not
 * (1/3 of 1.5 units, 1/10 of 5). */
/* clippers 9.2b */
void test_halves_go_away_from_the_front(void)
{
    const struct {
        int front, behind, extent, want;
    } cases[] = {{1, -1, 3, 2}, {1, -1, -3, -2}, {2, -4, 3, 1}, {1, -9, 5, 1}, {1, -9, -25, -3}};
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        fxl_point a = {cases[i].front, 0, 0}, b = {cases[i].behind, cases[i].extent, 0};
        fxl_point at =
            fxl_split_edge(&a, &b, fxl_plane_distance(&wall, &a), fxl_plane_distance(&wall, &b));
        TEST_ASSERT_EQUAL_INT32(0, at.x);
        TEST_ASSERT_EQUAL_INT32(cases[i].want, at.y);
    }
}

/* Less than half a unit is nothing, though only by 1.5 units of 2^-25; a half is a unit. */
void test_barely_less_than_half_a_unit(void)
{
    const fxl_q18_46 half = (fxl_q18_46)1 << 27;
    for (int sign = -1; sign <= 1; sign += 2) {
        const fxl_point ahead = {0, 0, 0}, behind = {sign, -sign, 0};
        fxl_point at = fxl_split_edge(&ahead, &behind, half - 12, -half - 12);
        TEST_ASSERT_EQUAL_INT32(0, at.x);
        TEST_ASSERT_EQUAL_INT32(0, at.y);
        at = fxl_split_edge(&ahead, &behind, half, -half);
        TEST_ASSERT_EQUAL_INT32(sign, at.x);
        TEST_ASSERT_EQUAL_INT32(-sign, at.y);
    }
}

/* A point that is one unit of 2^-46 off the plane is off the plane, on either side. */
void test_the_least_distance_divides(void)
{
    for (int sign = -1; sign <= 1; sign += 2) {
        const fxl_plane plane = {{FXL_Q2_30_ONE, 0, 0}, -sign};
        const split_piece piece = {3, {{0, 0, 0}, {0, Q16(1), 0}, {-sign * Q16(1), 0, 0}}};
        TEST_ASSERT_EQUAL(SPLIT_BOTH, split_by(&piece, &plane, &front, &back));
    }
}

/* Of both triangles beside an edge too, whichever way they walk it. */
/* clippers 9.3a */
void test_halves_are_the_same_for_both_sides(void)
{
    const fxl_point ahead = {Q16(1), 3, 0}, behind = {Q16(-1), 0, 0}, third = {Q16(9), Q16(9), 0};
    const split_piece pieces[] = {{3, {ahead, behind, third}}, {3, {behind, ahead, third}}};
    for (int k = 0; k < 2; k++) {
        bool found = false;
        TEST_ASSERT_EQUAL(SPLIT_BOTH, split_by(&pieces[k], &wall, &front, &back));
        for (uint32_t n = 0; n < front.count; n++) {
            found |= front.points[n].x == 0 && front.points[n].y == 1; /* 1.5, away from 3 */
        }
        TEST_ASSERT_TRUE(found);
    }
}

/* Triangles on both sides of an edge, each walked its own way, and the same planes
 * turned about: one point, in all four parts and in all four of the other way. */
/* clippers 9.3a */
void test_neighbours_get_the_same_bits(void)
{
    int asked = 0;
    for (int i = 0; i < UNIT_REPEAT; i++) {
        fxl_plane plane;
        fxl_point a, b;
        if (!parted_edge(&plane, &a, &b)) {
            continue;
        }
        fxl_point c = unit_point(FXL_COORDINATE_MAX);
        const split_piece one = {3, {a, b, c}}, other = {3, {b, a, c}};
        int64_t da = fxl_plane_distance(&plane, &a), db = fxl_plane_distance(&plane, &b);
        fxl_point want = fxl_split_edge(&a, &b, da, db);
        const split_piece *const pieces[] = {&one, &other};
        for (int k = 0; k < 2; k++) {
            TEST_ASSERT_EQUAL(SPLIT_BOTH, split_by(pieces[k], &plane, &front, &back));
            int in_front = 0, behind = 0;
            for (uint32_t n = 0; n < front.count; n++) {
                in_front += same_point(&front.points[n], &want);
            }
            for (uint32_t n = 0; n < back.count; n++) {
                behind += same_point(&back.points[n], &want);
            }
            TEST_ASSERT_TRUE(in_front >= 1 && behind >= 1);
        }
        asked++;
    }
    TEST_ASSERT_TRUE(asked > UNIT_REPEAT / 8);
}

/* Twice the area of a piece in the plane z = 0, in units of 2^-32, exact for the
 * pieces below. */
static int64_t area(const split_piece *piece)
{
    int64_t sum = 0;
    for (uint32_t i = 0; i < piece->count; i++) {
        const fxl_point *a = &piece->points[i], *b = &piece->points[(i + 1) % piece->count];
        sum += (int64_t)a->x * b->y - (int64_t)a->y * b->x;
    }
    return sum;
}

/* Both parts together are the piece with its two crossings put in: so they have its
 * area but for what rounding moves its outline, and none of it twice. */
void test_areas_add_up(void)
{
    const double pi = 3.14159265358979323846;
    for (int i = 0; i < UNIT_REPEAT; i++) {
        split_piece piece = {.count = 3 + unit_random() % (FXL_POLYGON_CAPACITY - 4)};
        double radius = unit_between(1 << 8, Q16(8000)), turn = unit_random();
        for (uint32_t n = 0; n < piece.count; n++) {
            double angle = turn + 2 * pi * n / piece.count;
            piece.points[n] = (fxl_point){(int32_t)floor(radius * cos(angle)),
                                          (int32_t)floor(radius * sin(angle)), 0};
        }
        fxl_plane plane = wall;
        plane.distance = (int64_t)unit_between((int32_t)-radius, (int32_t)radius) * (1 << 30) +
                         unit_between(-(1 << 29), 1 << 29);
        split_result result = split_by(&piece, &plane, &front, &back);
        if (result != SPLIT_BOTH) {
            continue;
        }
        TEST_ASSERT_TRUE(front.count >= 3 && back.count >= 3);
        TEST_ASSERT_TRUE(front.count + back.count <= piece.count + 4);
        double side = 2 * radius * sin(pi / piece.count) + 2;
        TEST_ASSERT_NEAR(area(&front) + area(&back), area(&piece), 2 * 0.75 * side + 2);
    }
}

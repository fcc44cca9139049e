/* SPDX-License-Identifier: MIT */
/* The rules of clipping in the view, worked out by hand; what a new vertex may
 * err by stands in test_clip_view_bounds.c. */
#include "clip/clip_view.h"
#include "clip_unit.h"
#include "unit.h"
#include "view/outcode.h"
#include "view/view.h"

/* World units of the view, exactly. */
#define V(units) ((fxl_q18_46)(units) * ((int64_t)1 << 46))

static fxl_q18_46 distances[FXL_POLYGON_CAPACITY];
static fxl_clip_view_work work;

/* What is cut, by itself so that small boards have the stack for the rest. */
static struct {
    fxl_view_polygon out;
    uint8_t guard[64];
} workspace;

/* Six planes through the eye: inside is x >= 0, x <= 0, y >= 0, y <= 0, z >= 0,
 * z <= 0. */
static const fxl_view_frustum walls = {FXL_Q2_30_ONE, 0, FXL_Q2_30_ONE, 0, 0, 0, 0, 0, 0};

/* The point that lies so far inside a wall, and so far along it. */
static fxl_view_point at_wall(int plane, int64_t inside, int64_t aside)
{
    switch (plane) {
    case FXL_PLANE_LEFT:
        return (fxl_view_point){inside, aside, 7};
    case FXL_PLANE_RIGHT:
        return (fxl_view_point){-inside, aside, 7};
    case FXL_PLANE_BOTTOM:
        return (fxl_view_point){aside, inside, 7};
    case FXL_PLANE_TOP:
        return (fxl_view_point){aside, -inside, 7};
    case FXL_PLANE_NEAR:
        return (fxl_view_point){7, aside, inside};
    default:
        return (fxl_view_point){7, aside, -inside};
    }
}

/* A polygon before a wall. */
static fxl_view_polygon flat(int plane, const plane_polygon *from)
{
    fxl_view_polygon polygon;
    memset(&polygon, 0, sizeof polygon);
    polygon.colour = 5;
    polygon.count = from->count;
    for (int i = 0; i < from->count; i++) {
        int inside = from->numbers[2 * i], aside = from->numbers[2 * i + 1];
        polygon.vertices[i].position = at_wall(plane, V(inside), V(aside));
    }
    return polygon;
}

static bool same_vertex(const fxl_view_vertex *a, const fxl_view_vertex *b)
{
    return a->position.x == b->position.x && a->position.y == b->position.y &&
           a->position.z == b->position.z;
}

/* Which vertex comes first is not laid down; their order is. */
static void expect_same(const char *name, const fxl_view_polygon *expected,
                        const fxl_view_polygon *actual)
{
    int first = 0;
    TEST_ASSERT_EQUAL_MESSAGE(expected->colour, actual->colour, name);
    TEST_ASSERT_EQUAL_MESSAGE(expected->count, actual->count, name);
    while (first + 1 < actual->count &&
           !same_vertex(&actual->vertices[first], &expected->vertices[0])) {
        first++;
    }
    for (int i = 0; i < expected->count; i++) {
        TEST_ASSERT_TRUE_MESSAGE(
            same_vertex(&expected->vertices[i], &actual->vertices[(first + i) % actual->count]),
            name);
    }
}

/* The same outcome at each of the six walls. What is not cut writes nothing. */
/* SPEC 4.7a, 4.7h, 4.7j, 4.7l-m */
void test_cases_of_one_plane(void)
{
    for (int i = 0; i < PLANE_CASES * FXL_PLANE_COUNT; i++) {
        const plane_case *one = &plane_cases[i / FXL_PLANE_COUNT];
        const int plane = i % FXL_PLANE_COUNT;
        fxl_view_polygon polygon = flat(plane, &one->polygon);
        memset(&workspace.out, 0x5A, sizeof workspace.out);
        TEST_ASSERT_EQUAL_MESSAGE(
            one->result, fxl_clip_view_to_plane(&polygon, &walls, plane, &workspace.out, distances),
            one->name);
        if (one->result == FXL_CLIP_CUT) {
            polygon = flat(plane, &one->left);
            expect_same(one->name, &polygon, &workspace.out);
        } else if (one->result != FXL_CLIP_DEGENERATE) {
            TEST_ASSERT_EACH_EQUAL_HEX8_MESSAGE(0x5A, &workspace.out, sizeof workspace.out,
                                                one->name);
        }
    }
}

/* 1/4 of the way from the inside end, whichever way the edge is walked. */
/* SPEC 4.7i */
void test_a_crossing_is_at_its_fraction_of_the_edge(void)
{
    for (int plane = 0; plane < FXL_PLANE_COUNT; plane++) {
        static const plane_polygon square = {4, {-3, 0, 1, 8, 1, 16, -3, 16}};
        fxl_view_polygon polygon = flat(plane, &square);
        TEST_ASSERT_EQUAL(FXL_CLIP_CUT, fxl_clip_view_to_plane(&polygon, &walls, plane,
                                                               &workspace.out, distances));
        fxl_view_vertex expected = {at_wall(plane, 0, V(6))};
        TEST_ASSERT_EQUAL(4, workspace.out.count);
        TEST_ASSERT_TRUE(same_vertex(&expected, &workspace.out.vertices[0]));
        expected = (fxl_view_vertex){at_wall(plane, 0, V(16))};
        TEST_ASSERT_TRUE(same_vertex(&expected, &workspace.out.vertices[3]));
    }
}

/* The smallest step out of a wall is a cut, and the edge's far end can be
 * anywhere: the crossing is next to the near one. */
void test_one_unit_outside_is_cut_off(void)
{
    const int64_t end = ((int64_t)1 << 61) - 1;
    fxl_view_polygon polygon = {.count = 3};
    for (int plane = 0; plane < FXL_PLANE_COUNT; plane++) {
        polygon.vertices[0].position = at_wall(plane, -1, 100);
        polygon.vertices[1].position = at_wall(plane, end, 100);
        polygon.vertices[2].position = at_wall(plane, end, 90);
        TEST_ASSERT_EQUAL(FXL_CLIP_CUT, fxl_clip_view_to_plane(&polygon, &walls, plane,
                                                               &workspace.out, distances));
        TEST_ASSERT_EQUAL(4, workspace.out.count);
        TEST_ASSERT_TRUE(fxl_view_distance(&walls, plane, &workspace.out.vertices[0].position) <=
                         1);
        polygon.vertices[0].position = at_wall(plane, 0, 100);
        TEST_ASSERT_EQUAL(FXL_CLIP_INSIDE, fxl_clip_view_to_plane(&polygon, &walls, plane,
                                                                  &workspace.out, distances));
    }
}

/* Teeth that stand out of the wall: each adds two vertices and takes one. */
/* SPEC 4.7n, 3.1q */
void test_more_than_the_capacity_is_refused(void)
{
    memset(workspace.guard, 0x5A, sizeof workspace.guard);
    for (uint8_t count = 4; count <= FXL_POLYGON_CAPACITY; count = (uint8_t)(count + 2)) {
        fxl_view_polygon polygon = {.colour = 1, .count = count};
        for (int i = 0; i < count; i++) {
            polygon.vertices[i].position = at_wall(FXL_PLANE_LEFT, i % 2 ? V(-9) : V(9), V(i));
        }
        int left = count / 2 + count;
        fxl_clip_result result =
            fxl_clip_view_to_plane(&polygon, &walls, FXL_PLANE_LEFT, &workspace.out, distances);
        expect_capacity(result, left, workspace.out.count);
    }
    TEST_ASSERT_EACH_EQUAL_HEX8(0x5A, workspace.guard, sizeof workspace.guard);
}

/* 90 degrees both ways, near 1/16, far 1000. */
static fxl_clip_result clip(const fxl_view_polygon *polygon, const fxl_view_polygon **result)
{
    fxl_lens lens = unit_lens(64, 64);
    fxl_view_frustum frustum;
    fxl_view_frustum_from_lens(&lens, &frustum);
    return fxl_clip_view_by_planes(polygon, &frustum, FXL_PLANES_ALL, &work, NULL, result);
}

static fxl_view_polygon polygon_of(const int *numbers, size_t count)
{
    fxl_view_polygon polygon = {.colour = 3, .count = (uint8_t)count};
    for (size_t i = 0; i < count; i++) {
        polygon.vertices[i].position =
            (fxl_view_point){V(numbers[3 * i]), V(numbers[3 * i + 1]), V(numbers[3 * i + 2])};
    }
    return polygon;
}

/* A square across the view at some depth. */
static fxl_view_polygon across(int left, int bottom, int right, int top, int depth)
{
    const int numbers[] = {left,  bottom, depth, left,  top,    depth,
                           right, top,    depth, right, bottom, depth};
    return polygon_of(numbers, 4);
}

/* SPEC 4.7e */
void test_frustum_inside_returns_the_input(void)
{
    fxl_view_polygon polygon = across(-5, -5, 5, 5, 10);
    const fxl_view_polygon *result = NULL;
    TEST_ASSERT_EQUAL(FXL_CLIP_INSIDE, clip(&polygon, &result));
    TEST_ASSERT_EQUAL_PTR(&polygon, result);
}

/* SPEC 4.7d */
void test_frustum_outside_returns_null(void)
{
    /* Left, bottom, right, top, depth. */
    static const int squares[][5] = {{-50, -5, -20, 5, 10}, {20, -5, 50, 5, 10},
                                     {-5, -50, 5, -20, 10}, {-5, 20, 5, 50, 10},
                                     {-5, -5, 5, 5, -10},   {-5, -5, 5, 5, 1000}};
    for (int i = 0; i < 6; i++) {
        const int *at = squares[i];
        fxl_view_polygon polygon = across(at[0], at[1], at[2], at[3], at[4]);
        const fxl_view_polygon *result = &polygon;
        TEST_ASSERT_EQUAL(FXL_CLIP_OUTSIDE, clip(&polygon, &result));
        TEST_ASSERT_NULL(result);
    }
}

/* Off one corner of the screen without being outside any one plane alone. */
void test_frustum_outside_after_a_cut_returns_null(void)
{
    const int numbers[] = {-40, 0, 10, 0, 40, 10, -40, 40, 10};
    fxl_view_polygon polygon = polygon_of(numbers, 3);
    const fxl_view_polygon *result = &polygon;
    fxl_clip_result outcome = clip(&polygon, &result);
    TEST_ASSERT_TRUE(outcome == FXL_CLIP_OUTSIDE || outcome == FXL_CLIP_DEGENERATE);
    TEST_ASSERT_NULL(result);
}

/* A vertex stays within 3 units of the plane that made it, and a later plane
 * moves along the edge to within a unit a coordinate. */
static void expect_within_frustum(const fxl_view_polygon *polygon, int count)
{
    fxl_lens lens = unit_lens(64, 64);
    fxl_view_frustum frustum;
    fxl_view_frustum_from_lens(&lens, &frustum);
    TEST_ASSERT_EQUAL(count, polygon->count);
    for (int i = 0; i < polygon->count; i++) {
        for (int plane = 0; plane < FXL_PLANE_COUNT; plane++) {
            const fxl_view_point *point = &polygon->vertices[i].position;
            TEST_ASSERT_TRUE(fxl_view_distance(&frustum, plane, point) >= -6);
        }
    }
}

static void expect_clipped(const int *numbers, size_t corners, int count)
{
    fxl_view_polygon polygon = polygon_of(numbers, corners);
    const fxl_view_polygon *result = NULL;
    TEST_ASSERT_EQUAL(FXL_CLIP_CUT, clip(&polygon, &result));
    TEST_ASSERT_TRUE(result == &work.polygons[0] || result == &work.polygons[1]);
    TEST_ASSERT_EQUAL(3, result->colour);
    expect_within_frustum(result, count);
}

/* SPEC 4.7f */
void test_corners_of_planes(void)
{
    const int two[] = {0, 0, 10, 0, 50, 10, 50, 50, 10, 50, 0, 10};
    expect_clipped(two, 4, 4);
    const int four[] = {-50, -50, 10, -50, 50, 10, 50, 50, 10, 50, -50, 10};
    expect_clipped(four, 4, 4);
}

void test_a_corner_of_right_top_and_far(void)
{
    const int tip[] = {0, 0, 900, 3000, 0, 1100, 0, 3000, 1100};
    const fxl_view_polygon *result;
    fxl_view_polygon polygon = polygon_of(tip, 3);
    TEST_ASSERT_EQUAL(FXL_CLIP_CUT, clip(&polygon, &result));
    TEST_ASSERT_TRUE(result->count >= 4);
    expect_within_frustum(result, result->count);
}

/* A ground under the eye is cut by both sides, by near and by far. */
void test_a_ground_is_cut_by_sides_near_and_far(void)
{
    const int ground[] = {-8191, -1, -8191, -8191, -1, 8191, 8191, -1, 8191, 8191, -1, -8191};
    expect_clipped(ground, 4, 4);
}

/* Cuts by each plane alone, near first or last. Null where nothing is left. */
static const fxl_view_polygon *cut_one_by_one(const fxl_view_polygon *polygon, bool is_reversed)
{
    const fxl_lens lens = unit_lens(64, 64);
    fxl_view_frustum frustum;
    fxl_view_frustum_from_lens(&lens, &frustum);
    for (int i = 0; i < FXL_PLANE_COUNT && polygon != NULL; i++) {
        const int plane = is_reversed ? FXL_PLANE_COUNT - 1 - i : i;
        fxl_clip_view_by_planes(polygon, &frustum, (fxl_planes)(1u << plane), &work, NULL,
                                &polygon);
    }
    return polygon;
}

/* The order shows in the last bits of a vertex that two planes make. */
/* SPEC 4.7f */
void test_planes_cut_in_the_order_of_their_numbers(void)
{
    uint32_t others = 0;
    for (int i = 0; i < UNIT_REPEAT / 20; i++) {
        fxl_view_polygon polygon = {.colour = 3, .count = 3};
        const fxl_view_polygon *result = NULL;
        for (int k = 0; k < 3; k++) {
            polygon.vertices[k].position =
                (fxl_view_point){unit_wide(52), unit_wide(52), unit_wide(52)};
        }
        clip(&polygon, &result);
        if (result == NULL || result == &polygon) {
            continue;
        }
        workspace.out = *result;
        result = cut_one_by_one(&polygon, false);
        TEST_ASSERT_NOT_NULL(result);
        expect_same("one by one", &workspace.out, result);
        result = cut_one_by_one(&polygon, true);
        bool is_other = result == NULL || result->count != workspace.out.count;
        for (int k = 0; k < workspace.out.count && !is_other; k++) {
            int at = 0;
            while (at < result->count &&
                   !same_vertex(&workspace.out.vertices[k], &result->vertices[at])) {
                at++;
            }
            is_other = at == result->count;
        }
        others += is_other;
    }
    TEST_ASSERT_TRUE(others > 0);
}

void test_frustum_refuses_what_exceeds_the_capacity(void)
{
    fxl_view_polygon polygon = {.colour = 1, .count = FXL_POLYGON_CAPACITY};
    for (int i = 0; i < polygon.count; i++) {
        polygon.vertices[i].position = (fxl_view_point){i % 2 ? V(-50) : 0, V(i - 16) / 2, V(10)};
    }
    const fxl_view_polygon *result = &polygon;
    TEST_ASSERT_EQUAL(FXL_CLIP_CAPACITY, clip(&polygon, &result));
    TEST_ASSERT_NULL(result);
}

/* An account has the distance of every vertex, and an intersection for every new vertex. A vertex
 * on the plane is not new, and a polygon that is not cut has none. */
void test_distances_and_new_vertices_are_counted(void)
{
    static const struct {
        plane_polygon polygon;
        fxl_clip_result result;
        uint32_t intersections;
    } cases[] = {{{3, {4, 0, -4, 4, -4, 8}}, FXL_CLIP_CUT, 2},
                 {{3, {0, 0, 4, 4, -4, 8}}, FXL_CLIP_CUT, 1},
                 {{3, {1, 0, 4, 4, 0, 8}}, FXL_CLIP_INSIDE, 0},
                 {{3, {-1, 0, -4, 4, -1, 8}}, FXL_CLIP_OUTSIDE, 0}};
    for (int plane = 0; plane < FXL_PLANE_COUNT; plane++) {
        for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
            const fxl_view_polygon polygon = flat(plane, &cases[i].polygon);
            const fxl_view_polygon *result;
            fxl_clip_stats stats = {.distances = 10, .intersections = 20};
            TEST_ASSERT_EQUAL(cases[i].result,
                              fxl_clip_view_by_planes(&polygon, &walls, (fxl_planes)(1u << plane),
                                                      &work, &stats, &result));
            TEST_ASSERT_EQUAL_UINT32(10 + 3, stats.distances);
            TEST_ASSERT_EQUAL_UINT32(20 + cases[i].intersections, stats.intersections);
        }
    }
}

/* SPDX-License-Identifier: MIT */
/* The clipper that takes all planes at once: corners, edges through two planes, and
 * against the clipper that goes plane by plane. */
#include <math.h>

#include "clip_unit.h"
#include "study/clip_once.h"

static struct {
    fxl_clip_once_workspace workspace;
    uint8_t guard[64];
} guarded;
static fxl_clip_once_workspace *const workspace = &guarded.workspace;
static fxl_clip_workspace other_workspace;

/* Of intersections: not looked at. */
#define ANY UINT32_MAX

/* 90 degrees both ways, near 1/16, far 1000, without an inset. */
static fxl_normalised square(void)
{
    fxl_camera camera;
    fxl_pose pose = {{0, 0, 0}, 0, 0, 0};
    fxl_lens lens = unit_lens(64, 64);
    fxl_normalised frustum;
    lens.inset = 0;
    TEST_ASSERT_EQUAL(FXL_OK, fxl_camera_from_pose(&pose, &camera));
    fxl_normalised_from_camera(&camera, &lens, &frustum);
    return frustum;
}

static fxl_clip_result clip(const fxl_varying_polygon *polygon, const fxl_varying_polygon **result)
{
    fxl_normalised frustum = square();
    workspace->stats = (fxl_clip_stats){0, 0, 0};
    return fxl_clip_once(polygon, &frustum, workspace, result);
}

/* The vertices in their order, from whichever on, to within rounding. */
static void expect_shape(const fxl_varying_polygon *polygon, const fxl_varying_polygon *wanted,
                         uint32_t intersections)
{
    const fxl_varying_polygon *result = NULL;
    TEST_ASSERT_EQUAL(FXL_CLIP_CUT, clip(polygon, &result));
    TEST_ASSERT_EQUAL(wanted->count, result->count);
    TEST_ASSERT_EQUAL(polygon->colour, result->colour);
    TEST_ASSERT_EQUAL(polygon->carried, result->carried);
    for (int i = 0; i < result->count; i++) { /* x rides along, in units of 2^-16 */
        TEST_ASSERT_NEAR(result->vertices[i].carried[0],
                         (double)result->vertices[i].position.x / (1 << 30), 2);
    }
    bool found = false;
    for (int first = 0; first < wanted->count; first++) {
        bool same = true;
        for (int i = 0; i < wanted->count; i++) {
            const fxl_view_point *a = &wanted->vertices[i].position;
            const fxl_view_point *b = &result->vertices[(first + i) % wanted->count].position;
            same = same && unit_near((double)a->x, (double)b->x, 4) &&
                   unit_near((double)a->y, (double)b->y, 4) &&
                   unit_near((double)a->z, (double)b->z, 4);
        }
        found = found || same;
    }
    TEST_ASSERT_TRUE_MESSAGE(found, "other vertices");
    TEST_ASSERT_TRUE(intersections == ANY || intersections == workspace->stats.intersections);
}

/* Not inlined, so that its two polygons leave the stack again. */
static __attribute__((noinline)) void expect_cut(const int *in, size_t in_count, const int *out,
                                                 size_t out_count, uint32_t intersections)
{
    fxl_varying_polygon polygon = clip_shape(in, in_count), wanted = clip_shape(out, out_count);
    expect_shape(&polygon, &wanted, intersections);
}
#define NUMBERS(...) ((const int[]){__VA_ARGS__}), sizeof((const int[]){__VA_ARGS__}) / 12

void test_inside_is_the_input_itself(void)
{
    const fxl_varying_polygon *result;
    fxl_varying_polygon polygon = SHAPE(-10, -10, 10, -10, 10, 10, 10, 10, 10, 10, -10, 10);
    TEST_ASSERT_EQUAL(FXL_CLIP_INSIDE, clip(&polygon, &result));
    TEST_ASSERT_EQUAL_PTR(&polygon, result);
}

void test_outside_is_nothing(void)
{
    const fxl_varying_polygon *result;
    fxl_varying_polygon polygon = SHAPE(50, -5, 10, 50, 5, 10, 11, 0, 10);
    TEST_ASSERT_EQUAL(FXL_CLIP_OUTSIDE, clip(&polygon, &result));
    TEST_ASSERT_NULL(result);
    /* Past a corner, outside of no one plane. */
    polygon = SHAPE(-35, 0, 10, 0, 35, 10, -35, 35, 10);
    TEST_ASSERT_EQUAL(FXL_CLIP_OUTSIDE, clip(&polygon, &result));
    TEST_ASSERT_NULL(result);
}

/* A corner or an edge on a plane is all that is left of what touches it from outside. */
void test_what_is_left_of_a_touch_is_degenerate(void)
{
    static const int numbers[2][9] = {{10, 0, 10, 20, 5, 10, 20, -5, 10},
                                      {10, -5, 10, 10, 5, 10, 20, 0, 10}};
    const fxl_varying_polygon *result;
    for (int i = 0; i < 2; i++) {
        fxl_varying_polygon polygon = clip_shape(numbers[i], 3);
        TEST_ASSERT_EQUAL(FXL_CLIP_DEGENERATE, clip(&polygon, &result));
        TEST_ASSERT_NULL(result);
        TEST_ASSERT_EQUAL_UINT32(0, workspace->stats.intersections);
    }
}

/* As many intersections as new vertices, an edge through two planes included. */
/* clippers 3.1c */
void test_edges_are_cut_once(void)
{
    expect_cut(NUMBERS(0, -5, 10, 0, 5, 10, 20, 5, 10, 20, -5, 10),
               NUMBERS(0, -5, 10, 0, 5, 10, 10, 5, 10, 10, -5, 10), 2);
    expect_cut(NUMBERS(-20, -5, 10, -20, 5, 10, 20, 5, 10, 20, -5, 10),
               NUMBERS(-10, -5, 10, -10, 5, 10, 10, 5, 10, 10, -5, 10), 4);
    /* Out through right after top and bottom, which do not matter. */
    expect_cut(NUMBERS(0, 0, 10, 40, 20, 10, 40, -20, 10), NUMBERS(0, 0, 10, 10, 5, 10, 10, -5, 10),
               2);
}

/* Through near and far. */
void test_a_ribbon_away_from_the_eye(void)
{
    const fxl_varying_polygon *result;
    fxl_varying_polygon polygon = SHAPE(-1, 0, -500, -1, 0, 3000, 1, 0, 3000, 1, 0, -500);
    TEST_ASSERT_EQUAL(FXL_CLIP_CUT, clip(&polygon, &result));
    TEST_ASSERT_TRUE(result->count == 6 || result->count == 4);
    for (int i = 0; i < result->count; i++) {
        TEST_ASSERT_TRUE(result->vertices[i].position.z >= V(1) / 16 - 4);
        TEST_ASSERT_TRUE(result->vertices[i].position.z <= V(1000) + 4);
    }
}

/* clippers 3.1d-e */
void test_a_corner_is_enclosed(void)
{
    /* The right top corner: the long side lies beyond it, and is cut to find it. */
    expect_cut(NUMBERS(0, 0, 10, 0, 40, 10, 40, 0, 10),
               NUMBERS(0, 0, 10, 0, 10, 10, 10, 10, 10, 10, 0, 10), 5);
    /* Two corners: out by the top, in again by the bottom. */
    expect_cut(NUMBERS(0, -40, 10, 0, 40, 10, 40, 40, 10, 40, -40, 10),
               NUMBERS(0, -10, 10, 0, 10, 10, 10, 10, 10, 10, -10, 10), ANY);
}

/* No edge is seen, all corners are; either way round. */
/* clippers 3.1f */
void test_a_wall_becomes_the_screen(void)
{
    expect_cut(NUMBERS(-30, -30, 10, -30, 30, 10, 30, 30, 10, 30, -30, 10),
               NUMBERS(-10, -10, 10, -10, 10, 10, 10, 10, 10, 10, -10, 10), ANY);
    expect_cut(NUMBERS(-30, -30, 10, 30, -30, 10, 30, 30, 10, -30, 30, 10),
               NUMBERS(-10, -10, 10, 10, -10, 10, 10, 10, 10, -10, 10, 10), ANY);
}

/* An edge through a corner of the frustum is not seen, and its end lies on both planes. */
/* clippers 3.1b */
void test_an_edge_through_a_corner(void)
{
    expect_cut(NUMBERS(-5, -12, 10, -15, -8, 10, -12, 2, 10),
               NUMBERS(-6, -10, 10, -10, -10, 10, -10, -2, 10), ANY);
    expect_cut(NUMBERS(-12, 2, 10, -15, -8, 10, -5, -12, 10),
               NUMBERS(-10, -2, 10, -10, -10, 10, -6, -10, 10), ANY);
    /* Every edge through one. */
    expect_cut(NUMBERS(0, -20, 10, 20, 0, 10, 0, 20, 10, -20, 0, 10),
               NUMBERS(-10, -10, 10, 10, -10, 10, 10, 10, 10, -10, 10, 10), ANY);
    expect_cut(NUMBERS(-20, 0, 10, 0, 20, 10, 20, 0, 10, 0, -20, 10),
               NUMBERS(-10, 10, 10, 10, 10, 10, 10, -10, 10, -10, -10, 10), ANY);
}

/* Two vertices on planes: they come once, and cost nothing. */
void test_vertices_on_planes_are_not_repeated(void)
{
    expect_cut(NUMBERS(10, -5, 10, 0, 0, 10, 10, 5, 10, 20, 0, 10),
               NUMBERS(10, -5, 10, 0, 0, 10, 10, 5, 10), 0);
}

void test_a_touch_is_degenerate(void)
{
    const fxl_varying_polygon *result;
    fxl_varying_polygon polygon = SHAPE(10, 0, 10, 20, 5, 10, 20, -5, 10);
    fxl_clip_result cut = clip(&polygon, &result);
    TEST_ASSERT_TRUE(cut == FXL_CLIP_DEGENERATE);
    TEST_ASSERT_NULL(result);
}

/* clippers 3.3a */
void test_a_sliver_is_refused_where_asked(void)
{
    const fxl_varying_polygon *result;
    fxl_normalised frustum = square();
    fxl_varying_polygon polygon = SHAPE(20, 5, 10, 9, 0, 10, 20, -5, 10);
    workspace->stats = (fxl_clip_stats){0, 0, 0};
    TEST_ASSERT_EQUAL(FXL_CLIP_CUT, fxl_clip_once(&polygon, &frustum, workspace, &result));
    workspace->stats.sliver = V(2);
    TEST_ASSERT_EQUAL(FXL_CLIP_OUTSIDE, fxl_clip_once(&polygon, &frustum, workspace, &result));
    /* A vertex barely inside stands for the crossing before it. */
    polygon = SHAPE(20, 5, 10, 9, 5, 10, 0, 0, 10, 9, -5, 10);
    workspace->stats = (fxl_clip_stats){V(2), 0, 0};
    TEST_ASSERT_EQUAL(FXL_CLIP_CUT, fxl_clip_once(&polygon, &frustum, workspace, &result));
    TEST_ASSERT_EQUAL(4, result->count);
    TEST_ASSERT_EQUAL(1, workspace->stats.intersections);
}

/* Outlines of every kind, also such as no face has: nothing beyond the capacity. */
void test_the_capacity_is_never_overrun(void)
{
    memset(guarded.guard, 0x5A, sizeof guarded.guard);
    fxl_normalised frustum = square();
    int refused = 0;
    for (int i = 0; i < UNIT_REPEAT / 10; i++) {
        fxl_varying_polygon polygon = clip_saw((uint8_t)unit_between(3, FXL_POLYGON_CAPACITY), 50);
        const fxl_varying_polygon *result;
        for (int k = 0; k < polygon.count && i % 8 != 0; k++) {
            polygon.vertices[k].position =
                (fxl_view_point){unit_wide(61), unit_wide(61), unit_wide(61)};
        }
        guarded.workspace.stats = (fxl_clip_stats){i % 3 == 0 ? V(1) : 0, 0, 0};
        fxl_clip_result cut = fxl_clip_once(&polygon, &frustum, &guarded.workspace, &result);
        refused += cut == FXL_CLIP_CAPACITY;
        TEST_ASSERT_EQUAL(cut == FXL_CLIP_CUT || cut == FXL_CLIP_INSIDE, result != NULL);
    }
    TEST_ASSERT_TRUE(refused > 0);
    TEST_ASSERT_EACH_EQUAL_HEX8(0x5A, guarded.guard, sizeof guarded.guard);
}

/* Twice the area on the screen, in units of 2^-32 square pixel. */
static double twice_area(const fxl_normalised *frustum, const fxl_varying_polygon *polygon)
{
    fxl_screen_point at[FXL_POLYGON_CAPACITY];
    double twice = 0;
    for (int i = 0; i < polygon->count; i++) {
        TEST_ASSERT_EQUAL(FXL_OK,
                          fxl_normalised_project(frustum, &polygon->vertices[i].position, &at[i]));
    }
    for (int i = 0; i < polygon->count; i++) {
        const fxl_screen_point *a = &at[i], *b = &at[(i + 1) % polygon->count];
        twice += (double)a->x * b->y - (double)b->x * a->y;
    }
    return twice;
}

/* Swaps and negates coordinates: one of the 8 ways in which the square screen falls on itself. */
static void turn(fxl_varying_polygon *polygon, int way)
{
    for (int i = 0; i < polygon->count; i++) {
        fxl_view_point *at = &polygon->vertices[i].position;
        const fxl_view_point was = *at;
        at->x = way & 4 ? was.y : was.x;
        at->y = way & 4 ? was.x : was.y;
        at->x = way & 1 ? -at->x : at->x;
        at->y = way & 2 ? -at->y : at->y;
    }
}

/* Edges from the middle of the screen leave exactly through its corners: an end of the line in
 * which a plane cuts the polygon then lies on the next plane. What is seen is a quarter of the
 * screen, 64 by 64 pixels. */
void test_edges_that_leave_through_corners(void)
{
    const fxl_normalised frustum = square();
    const double quarter = 64.0 * 64 / 4 * 65536 * 65536;
    for (int way = 0; way < 8; way++) {
        for (int reversed = 0; reversed < 2; reversed++) {
            const fxl_varying_polygon *result;
            fxl_varying_polygon polygon = reversed ? SHAPE(0, 0, 10, -20, 20, 10, 20, 20, 10)
                                                   : SHAPE(0, 0, 10, 20, 20, 10, -20, 20, 10);
            turn(&polygon, way);
            TEST_ASSERT_EQUAL(FXL_CLIP_CUT, clip(&polygon, &result));
            const double twice = twice_area(&frustum, result);
            TEST_ASSERT_NEAR(twice < 0 ? -twice : twice, 2 * quarter, 64 * 65536.0 * 8);
        }
    }
}

static bool has_vertex(const fxl_varying_polygon *polygon, const fxl_view_point *at)
{
    bool found = false;
    for (int i = 0; i < polygon->count; i++) {
        const fxl_view_point *vertex = &polygon->vertices[i].position;
        found = found || (vertex->x == at->x && vertex->y == at->y && vertex->z == at->z);
    }
    return found;
}

/* A quadrangle that is not flat has no one point at a corner of the screen. Whichever way round,
 * the clipper takes the same one: that on the line in which the plane of the lower number cuts. */
void test_a_corner_is_the_same_either_way_round(void)
{
    static fxl_varying_polygon forward;
    for (int way = 0; way < 8; way++) {
        const fxl_varying_polygon *result;
        fxl_varying_polygon polygon = SHAPE(1, 2, 10, 1, 40, 16, 40, 42, 10, 42, 1, 17);
        turn(&polygon, way);
        TEST_ASSERT_EQUAL(FXL_CLIP_CUT, clip(&polygon, &result));
        forward = *result;
        const fxl_varying_vertex second = polygon.vertices[1];
        polygon.vertices[1] = polygon.vertices[3];
        polygon.vertices[3] = second;
        TEST_ASSERT_EQUAL(FXL_CLIP_CUT, clip(&polygon, &result));
        TEST_ASSERT_EQUAL(4, result->count);
        TEST_ASSERT_EQUAL(4, forward.count);
        for (int i = 0; i < 4; i++) {
            TEST_ASSERT_TRUE(has_vertex(&forward, &result->vertices[i].position));
        }
    }
}

/* The same piece as plane by plane: the same number of corners, and the same area
 * to within a unit all round the screen. */
/* clippers 3.1a, 3.1g-h */
void test_it_agrees_with_plane_by_plane(void)
{
    int cuts = 0, unlike = 0, more = 0;
    fxl_normalised frustum = square();
    for (int i = 0; i < UNIT_REPEAT / 5; i++) {
        const fxl_varying_polygon *once, *each;
        fxl_varying_polygon polygon = clip_random_shape((unsigned)unit_between(50, 61));
        workspace->stats = other_workspace.stats = (fxl_clip_stats){0, 0, 0};
        fxl_clip_result a = fxl_clip_once(&polygon, &frustum, workspace, &once);
        fxl_clip_result b = fxl_clip_normalised(&polygon, &frustum, &other_workspace, &each);
        double one = once ? twice_area(&frustum, once) : 0;
        double two = each ? twice_area(&frustum, each) : 0;
        TEST_ASSERT_TRUE(a == b || (one == 0 && two == 0));
        unlike += !unit_near(one, two, 4 * 65536.0 * 256);
        cuts += a == FXL_CLIP_CUT;
        more += a == FXL_CLIP_CUT &&
                workspace->stats.intersections > other_workspace.stats.intersections;
    }
    TEST_ASSERT_TRUE(cuts > UNIT_REPEAT / 50);
    TEST_ASSERT_TRUE(unlike * 1000 < cuts);
    TEST_ASSERT_TRUE(more < cuts / 2);
}

/* Quadrangles whose four edges pass a corner each, and triangles of which two do: whether an
 * edge is seen hangs on bits that the crossings' rounding hides. */
/* clippers 3.1j */
void test_edges_that_pass_corners_closely(void)
{
    fxl_normalised frustum = square();
    int cuts = 0;
    for (int i = 0; i < UNIT_REPEAT / 10; i++) {
        fxl_varying_polygon polygon = {.colour = 1, .count = (uint8_t)unit_between(3, 4)};
        int64_t z = unit_wide(55);
        z = (z < 0 ? -z : z) + V(1);
        for (int k = 0; k < polygon.count; k++) {
            /* The middle of each edge is a corner. */
            static const int signs[4][2] = {{0, -2}, {2, 0}, {0, 2}, {-2, 0}};
            fxl_view_point *at = &polygon.vertices[k].position;
            at->x = z * signs[k][0] + unit_between(-2, 2);
            at->y = z * signs[k][1] + unit_between(-2, 2);
            at->z = z + unit_between(-2, 2);
        }
        const fxl_varying_polygon *once, *each;
        workspace->stats = other_workspace.stats = (fxl_clip_stats){0, 0, 0};
        fxl_clip_once(&polygon, &frustum, workspace, &once);
        fxl_clip_normalised(&polygon, &frustum, &other_workspace, &each);
        double one = once ? twice_area(&frustum, once) : 0;
        double two = each ? twice_area(&frustum, each) : 0;
        TEST_ASSERT_TRUE(unit_near(one, two, 4 * 65536.0 * 256));
        cuts += once != NULL;
    }
    TEST_ASSERT_EQUAL(UNIT_REPEAT / 10, cuts);
}

/* Edges that lie in a plane but for a unit, with which they cross it or do not: the left plane, and
 * the right one. */
void test_edges_that_lie_in_a_plane_but_for_a_unit(void)
{
    static const fxl_view_point shapes[2][4] = {{{V(2) + 1, V(3) - 1, V(1)},
                                                 {V(-1), V(3) - 1, V(1)},
                                                 {V(-1), V(-5) + 1, V(1) + 1},
                                                 {V(2) + 2, V(-5) - 1, V(1) + 1}},
                                                {{V(1) / 16, V(-1) / 8 - 1, V(1) / 16},
                                                 {V(1) + 1, V(-1) / 8 - 2, V(1)},
                                                 {V(1), V(1) / 8 - 2, V(1) - 1},
                                                 {V(1) / 16 + 2, V(1) / 8 - 1, V(1) / 16 + 1}}};
    fxl_normalised frustum = square();
    for (int i = 0; i < 2; i++) {
        fxl_varying_polygon polygon = {.colour = 1, .count = 4};
        const fxl_varying_polygon *once, *each;
        for (int k = 0; k < 4; k++) {
            polygon.vertices[k].position = shapes[i][k];
        }
        workspace->stats = other_workspace.stats = (fxl_clip_stats){0, 0, 0};
        fxl_clip_once(&polygon, &frustum, workspace, &once);
        fxl_clip_normalised(&polygon, &frustum, &other_workspace, &each);
        const double one = once ? twice_area(&frustum, once) : 0;
        const double two = each ? twice_area(&frustum, each) : 0;
        TEST_ASSERT_TRUE(unit_near(one, two, 4 * 65536.0 * 256));
    }
}

/* 30 vertices on a circle before the eye, one of them alone between two vertices that lie beyond
 * corners of the screen: after the second of those the capacity is reached, so its corner does not
 * fit. */
void test_the_capacity_ends_at_a_corner(void)
{
    fxl_varying_polygon polygon = {.colour = 1, .count = FXL_POLYGON_CAPACITY};
    const fxl_varying_polygon *result = NULL;
    for (int i = 0; i < FXL_POLYGON_CAPACITY; i++) {
        fxl_view_point *at = &polygon.vertices[i].position;
        /* Degrees, clockwise. The tangents from the two touch the circle 58 degrees before and
         * after them. */
        const double degrees = i == 0 ? -225 : -14 - 62.0 * (i - 2) / (FXL_POLYGON_CAPACITY - 4);
        const double angle = degrees * 3.14159265358979 / 180;
        at->x = (int64_t)(cos(angle) * 9 * (double)V(10));
        at->y = (int64_t)(sin(angle) * 9 * (double)V(10));
        at->z = V(100);
    }
    polygon.vertices[1].position = (fxl_view_point){V(120), V(120), V(100)};
    polygon.vertices[FXL_POLYGON_CAPACITY - 1].position =
        (fxl_view_point){V(-120), V(-120), V(100)};
    TEST_ASSERT_EQUAL(FXL_CLIP_CAPACITY, clip(&polygon, &result));
}

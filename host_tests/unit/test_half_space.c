/* SPDX-License-Identifier: MIT */
/* Volumes of half-spaces: their distances against exact numbers, points and
 * polygons. */
#include <stdlib.h>

#include "clip_unit.h"
#include "wide.h"
#include "study/clip_world.h"
#include "study/half_space.h"

static fxl_clip_workspace workspace;

/* The window from -2 to -1 and from 1 to 3 at depth 1: all of it up and to the
 * left; far at 100. */
static fxl_volume aside(void)
{
    fxl_volume volume;
    TEST_ASSERT_EQUAL(FXL_OK, fxl_volume_from_window(Q16(-2), Q16(-1), Q16(1), Q16(3), Q16(1),
                                                     Q16(100), &volume));
    return volume;
}

static int32_t component(void)
{
    return (int32_t)(unit_random() % 3 == 0 ? 0 : unit_wide(29));
}

/* clippers 2.1b-c */
void test_distances_are_exact_but_for_the_last_unit(void)
{
    const int64_t one = (int64_t)1 << 30;
    for (int i = 0; i < UNIT_REPEAT; i++) {
        fxl_half_space plane = {{component(), component(), component()}, unit_wide(61)};
        fxl_view_point point = {unit_wide(61), unit_wide(61), unit_wide(61)};
        if (i % 8 == 1) { /* the smallest numbers */
            plane.normal =
                (fxl_direction){unit_between(-1, 1), unit_between(-1, 1), unit_between(-1, 1)};
        }
        if (i % 8 == 0) { /* the largest sums */
            plane.normal = (fxl_direction){715827882, -715827882, 715827882};
            point.x = point.z = ((int64_t)1 << 61) - 1;
            point.y = -point.x;
        }
        fxl_q18_46 distance = fxl_half_space_distance(&plane, &point);
        wide exact =
            wide_sum(wide_product(plane.normal.x, point.x), wide_product(plane.normal.y, point.y));
        exact = wide_sum(exact, wide_product(plane.normal.z, point.z));
        exact = wide_sum(exact, wide_product(plane.offset, one));
        int64_t rest;
        TEST_ASSERT_TRUE(wide_narrow(wide_difference(exact, wide_product(distance, one)), &rest));
        TEST_ASSERT_TRUE(rest >= 0 && rest < one);
    }
}

/* clippers 2.1d-f */
void test_a_window_is_taken_exactly(void)
{
    for (int i = 0; i < UNIT_REPEAT / 50; i++) {
        fxl_q16_16 left = unit_between(-FXL_COORDINATE_MAX, FXL_COORDINATE_MAX - 1);
        fxl_q16_16 right = unit_between(left + 1, FXL_COORDINATE_MAX);
        fxl_q16_16 near = unit_between(FXL_NEAR_MIN, Q16(100));
        fxl_volume volume;
        TEST_ASSERT_EQUAL(
            FXL_OK, fxl_volume_from_window(left, right, left, right, near, Q16(200), &volume));
        for (int plane = FXL_PLANE_LEFT; plane <= FXL_PLANE_TOP; plane++) {
            bool low = plane == FXL_PLANE_LEFT || plane == FXL_PLANE_BOTTOM;
            int64_t side = low ? left : right;
            /* The point of the window at that side, and one unit beyond. */
            for (int64_t beyond = -1; beyond <= 1; beyond++) {
                fxl_view_point at = {side + (low ? -beyond : beyond),
                                     side + (low ? -beyond : beyond), near};
                at.x *= 1 << 30;
                at.y *= 1 << 30;
                at.z *= 1 << 30;
                fxl_q18_46 distance = fxl_half_space_distance(&volume.planes[plane], &at);
                TEST_ASSERT_TRUE(beyond > 0 ? distance < 0 : distance >= 0);
                TEST_ASSERT_EQUAL(beyond == 0, distance == 0);
            }
        }
    }
}

/* clippers 2.1d */
void test_windows_out_of_range_are_refused(void)
{
    static const fxl_q16_16 bad[][6] = {
        {Q16(1), Q16(1), 0, Q16(1), Q16(1), Q16(9)},
        {0, Q16(1), Q16(1), Q16(0.5), Q16(1), Q16(9)},
        {0, Q16(1), Q16(1), Q16(1), Q16(1), Q16(9)},
        {0, Q16(1), 0, Q16(1), 255, Q16(9)},
        {0, Q16(1), 0, Q16(1), Q16(9), Q16(9)},
        {0, Q16(1), 0, Q16(1), Q16(1), INT32_MAX},
        {0, Q16(8192), 0, Q16(1), Q16(1), Q16(9)},
        {0, Q16(1), INT32_MIN, Q16(1), Q16(1), Q16(9)},
        {0, Q16(1), 0, Q16(1), Q16(8192), Q16(9000)},
    };
    for (size_t i = 0; i < sizeof bad / sizeof bad[0]; i++) {
        fxl_volume volume, before;
        memset(&volume, 0x5A, sizeof volume);
        before = volume;
        const fxl_q16_16 *b = bad[i];
        TEST_ASSERT_EQUAL(FXL_E_RANGE,
                          fxl_volume_from_window(b[0], b[1], b[2], b[3], b[4], b[5], &volume));
        TEST_ASSERT_EQUAL_MEMORY(&before, &volume, sizeof volume);
    }
    TEST_ASSERT_EQUAL(FXL_E_ARGUMENT, fxl_volume_from_window(0, 1, 0, 1, 256, 512, NULL));
}

void test_windows_at_the_range_s_ends_are_taken(void)
{
    static const fxl_q16_16 good[][6] = {
        {-FXL_COORDINATE_MAX, FXL_COORDINATE_MAX, -FXL_COORDINATE_MAX, FXL_COORDINATE_MAX,
         FXL_NEAR_MIN, FXL_FAR_MAX},
        {-1, 0, 0, 1, FXL_COORDINATE_MAX, FXL_COORDINATE_MAX + 1},
    };
    static const int beyond[] = {-1, 1, -1, 1, -1, 1};
    for (size_t i = 0; i < sizeof good / sizeof good[0]; i++) {
        const fxl_q16_16 *g = good[i];
        fxl_volume volume;
        TEST_ASSERT_EQUAL(FXL_OK,
                          fxl_volume_from_window(g[0], g[1], g[2], g[3], g[4], g[5], &volume));
    }
    for (int k = 0; k < 6; k++) { /* each number of the first one further */
        fxl_q16_16 g[6];
        fxl_volume volume;
        memcpy(g, good[0], sizeof g);
        g[k] += beyond[k];
        TEST_ASSERT_EQUAL(FXL_E_RANGE,
                          fxl_volume_from_window(g[0], g[1], g[2], g[3], g[4], g[5], &volume));
    }
    fxl_volume volume;
    TEST_ASSERT_EQUAL(FXL_E_RANGE, fxl_volume_from_window(0, 1, 0, 1, FXL_COORDINATE_MAX + 1,
                                                          FXL_FAR_MAX, &volume));
}

void test_points(void)
{
    fxl_volume volume = aside();
    static const struct {
        int x, y, z;
        uint32_t outside;
    } points[] = {
        {-15, 20, 10, 0},
        {-20, 30, 10, 0}, /* on the edge of left and top */
        {-10, 10, 10, 0}, /* on that of right and bottom */
        {-21, 20, 10, 1 << FXL_PLANE_LEFT},
        {-9, 20, 10, 1 << FXL_PLANE_RIGHT},
        {-15, 9, 10, 1 << FXL_PLANE_BOTTOM},
        {-15, 31, 10, 1 << FXL_PLANE_TOP},
        {0, 0, 0, 1 << FXL_PLANE_NEAR},
        {-150, 200, 101, 1 << FXL_PLANE_FAR},
        {15, -20, -10, /* behind the eye, where left is right: x + 2 z and y - z are negative */
         1 << FXL_PLANE_NEAR | 1 << FXL_PLANE_LEFT | 1 << FXL_PLANE_RIGHT | 1 << FXL_PLANE_BOTTOM |
             1 << FXL_PLANE_TOP},
    };
    for (size_t i = 0; i < sizeof points / sizeof points[0]; i++) {
        fxl_view_point at = {V(points[i].x), V(points[i].y), V(points[i].z)};
        TEST_ASSERT_EQUAL(points[i].outside, fxl_volume_code(&volume, &at));
    }
}

/* The larger number of a side's normal has 30 bits, so that no bit of a distance is lost. */
void test_normals_of_a_window_have_all_bits(void)
{
    for (int i = 0; i < UNIT_REPEAT / 100; i++) {
        const fxl_q16_16 left = -unit_between(1, FXL_COORDINATE_MAX),
                         right = unit_between(0, -left);
        const fxl_q16_16 near = unit_between(FXL_NEAR_MIN, Q16(100)) >> unit_random() % 8;
        fxl_volume volume;
        if (near < FXL_NEAR_MIN) {
            continue;
        }
        TEST_ASSERT_EQUAL(
            FXL_OK, fxl_volume_from_window(left, right, left, right, near, Q16(200), &volume));
        for (int plane = FXL_PLANE_LEFT; plane <= FXL_PLANE_TOP; plane++) {
            const fxl_direction *normal = &volume.planes[plane].normal;
            const int32_t across = abs(normal->x + normal->y), along = abs(normal->z);
            const int32_t larger = across > along ? across : along;
            TEST_ASSERT_TRUE(larger >= 1 << 29 && larger < 1 << 30);
        }
    }
}

/* The planes near and far stand straight: how far a point lies to the side is all the same. */
void test_depths_alone_decide_near_and_far(void)
{
    const fxl_volume volume = aside(); /* depths 1 to 100 */
    const int64_t end = ((int64_t)1 << 61) - 1;
    for (int i = 0; i < 9; i++) {
        const fxl_view_point near = {end * (i % 3 - 1), end * (i / 3 - 1), V(1)};
        const fxl_view_point far = {near.x, near.y, V(100)};
        TEST_ASSERT_TRUE(fxl_half_space_distance(&volume.planes[FXL_PLANE_NEAR], &near) == 0);
        TEST_ASSERT_TRUE(fxl_half_space_distance(&volume.planes[FXL_PLANE_FAR], &near) == V(99));
        TEST_ASSERT_TRUE(fxl_half_space_distance(&volume.planes[FXL_PLANE_NEAR], &far) == V(99));
        TEST_ASSERT_TRUE(fxl_half_space_distance(&volume.planes[FXL_PLANE_FAR], &far) == 0);
    }
}

/* clippers 1.1a-b, 1.2a, 1.2c */
void test_polygons(void)
{
    fxl_volume volume = aside();
    const fxl_varying_polygon *result;
    fxl_varying_polygon inside = SHAPE(-12, 12, 10, -12, 28, 10, -18, 28, 10);
    TEST_ASSERT_EQUAL(FXL_CLIP_INSIDE, fxl_clip_to_volume(&inside, &volume, &workspace, &result));
    TEST_ASSERT_EQUAL_PTR(&inside, result);
    fxl_varying_polygon outside = SHAPE(0, 12, 10, 0, 28, 10, -9, 28, 10);
    TEST_ASSERT_EQUAL(FXL_CLIP_OUTSIDE, fxl_clip_to_volume(&outside, &volume, &workspace, &result));
    TEST_ASSERT_NULL(result);
    /* The left half hangs out. */
    fxl_varying_polygon half = SHAPE(-16, 12, 10, -24, 12, 10, -24, 28, 10, -16, 28, 10);
    fxl_varying_polygon expected = SHAPE(-16, 12, 10, -20, 12, 10, -20, 28, 10, -16, 28, 10);
    expected.vertices[1].carried[1] = Q16(0.5);
    expected.vertices[2].carried[1] = Q16(2.5);
    workspace.stats = (fxl_clip_stats){0, 0, 0};
    TEST_ASSERT_EQUAL(FXL_CLIP_CUT, fxl_clip_to_volume(&half, &volume, &workspace, &result));
    TEST_ASSERT_TRUE(clip_same(&expected, result));
    TEST_ASSERT_EQUAL(2, workspace.stats.intersections);
    /* Four outcodes of six planes, then the four vertices against the one plane. */
    TEST_ASSERT_EQUAL(4 * FXL_PLANE_COUNT + 4, workspace.stats.distances);
}

/* One half-space: early outs that write nothing, and the input may be any. */
/* clippers 1.1b */
void test_one_half_space(void)
{
    fxl_varying_polygon *const out = &workspace.polygons[0], *const before = &workspace.polygons[1];
    fxl_q18_46 distances[FXL_POLYGON_CAPACITY];
    fxl_clip_stats account = {0, 0, 0};
    fxl_half_space slanted = {{FXL_Q2_30_ONE / 4, FXL_Q2_30_ONE / 4, FXL_Q2_30_ONE / 4}, V(-1)};
    memset(out, 0x5A, sizeof *out);
    *before = *out;
    fxl_varying_polygon polygon = SHAPE(4, 0, 0, 0, 4, 0, 0, 0, 4); /* on it */
    TEST_ASSERT_EQUAL(FXL_CLIP_INSIDE,
                      fxl_clip_to_half_space(&polygon, &slanted, &account, out, distances));
    polygon = SHAPE(3, 0, 0, 0, 3, 0, 0, 0, 3);
    TEST_ASSERT_EQUAL(FXL_CLIP_OUTSIDE,
                      fxl_clip_to_half_space(&polygon, &slanted, &account, out, distances));
    TEST_ASSERT_EQUAL_MEMORY(before, out, sizeof *out);
    polygon = SHAPE(8, 0, 0, 0, 0, 0, 0, 8, 0);
    TEST_ASSERT_EQUAL(FXL_CLIP_CUT,
                      fxl_clip_to_half_space(&polygon, &slanted, &account, out, distances));
    TEST_ASSERT_TRUE(out->count == 4 && out->vertices[1].position.x == V(4));
    TEST_ASSERT_EQUAL(9, account.distances);
    TEST_ASSERT_EQUAL(2, account.intersections);
}

/* By the sliver rule a vertex on the plane is outside. It stands for the intersection, which is
 * then not computed. */
void test_a_vertex_on_the_plane_is_no_intersection(void)
{
    fxl_varying_polygon *const out = &workspace.polygons[0];
    fxl_q18_46 distances[FXL_POLYGON_CAPACITY];
    fxl_clip_stats account = {.sliver = V(1)};
    const fxl_half_space wall = {{FXL_Q2_30_ONE, 0, 0}, 0};
    fxl_varying_polygon polygon = SHAPE(4, 0, 10, 0, 4, 10, -4, 0, 10);
    fxl_varying_polygon expected = SHAPE(4, 0, 10, 0, 4, 10, 0, 0, 10);
    expected.vertices[2].carried[1] = Q16(1);
    TEST_ASSERT_EQUAL(FXL_CLIP_CUT,
                      fxl_clip_to_half_space(&polygon, &wall, &account, out, distances));
    TEST_ASSERT_EQUAL(1, account.intersections);
    TEST_ASSERT_TRUE(clip_same(&expected, out));
}

/* As many vertices as a polygon may have: the distances beyond are nobody's. */
void test_the_most_vertices(void)
{
    fxl_volume volume = aside();
    const fxl_varying_polygon *result;
    fxl_varying_polygon polygon = {.count = FXL_POLYGON_CAPACITY};
    for (int i = 0; i < FXL_POLYGON_CAPACITY; i++) { /* down one side, and back up the other */
        const bool back = i >= FXL_POLYGON_CAPACITY / 2;
        const int64_t y = back ? FXL_POLYGON_CAPACITY - 1 - i : i;
        polygon.vertices[i].position =
            (fxl_view_point){back ? V(-16) : V(-18), V(12) + y * (V(1) / 4), V(10)};
    }
    polygon.vertices[0].position.x = V(-24); /* outside of left */
    workspace.stats = (fxl_clip_stats){0, 0, 0};
    memset(workspace.distances, 0x5A, sizeof workspace.distances);
    fxl_clip_result cut = fxl_clip_to_volume(&polygon, &volume, &workspace, &result);
    TEST_ASSERT_EQUAL(FXL_CLIP_CAPACITY, cut); /* two for one */
    TEST_ASSERT_NULL(result);
    TEST_ASSERT_EQUAL(FXL_POLYGON_CAPACITY * (FXL_PLANE_COUNT + 1), workspace.stats.distances);
}

/* What the guard band leaves can be projected, from the range's ends and the
 * nearest near plane; without it, it could not. */
/* clippers 2.3a-b */
void test_the_guard_band_keeps_the_screen_in_range(void)
{
    const uint32_t depths = 1u << FXL_PLANE_NEAR | 1u << FXL_PLANE_FAR;
    int cut_count = 0, beyond = 0;
    for (int i = 0; i < UNIT_REPEAT / 20; i++) {
        fxl_lens lens = unit_any_lens();
        lens.near_z = FXL_NEAR_MIN;
        lens.inset = unit_random() % 2 ? 0 : 4;
        fxl_volume volume;
        const fxl_varying_polygon *result;
        clip_volume(&lens, depths | (unit_random() % 2 ? 1u << FXL_PLANE_LEFT : 0), &volume);
        fxl_varying_polygon polygon = clip_random_shape(61);
        polygon.vertices[0].position.z = volume.planes[FXL_PLANE_NEAR].offset * -1;
        workspace.stats = (fxl_clip_stats){0, 0, 0};
        fxl_screen_point screen;
        beyond += fxl_project_point(&lens, &polygon.vertices[0].position, &screen) != FXL_OK;
        if (fxl_clip_to_volume(&polygon, &volume, &workspace, &result) == FXL_CLIP_CUT) {
            cut_count++;
            for (int k = 0; k < result->count; k++) {
                TEST_ASSERT_EQUAL(FXL_OK,
                                  fxl_project_point(&lens, &result->vertices[k].position, &screen));
            }
        }
    }
    TEST_ASSERT_TRUE(cut_count > UNIT_REPEAT / 200 && beyond > UNIT_REPEAT / 50);
}

static fxl_q16_16 rounded(fxl_q18_46 place)
{
    return (fxl_q16_16)((place + (1 << 29)) >> 30);
}

/* In the world, against the clipper that is made for it: the same verdicts, and the same
 * vertices but for that one's rounding, which grows with the edge. */
/* clippers 2.1g, SPEC 4.7k */
void test_planes_of_the_world(void)
{
    int cuts = 0;
    for (int i = 0; i < UNIT_REPEAT / 20; i++) {
        static fxl_polygon polygon, other;
        fxl_varying_polygon *const in = &workspace.polygons[0], *const out = &workspace.polygons[1];
        fxl_q18_46 distances[FXL_POLYGON_CAPACITY];
        fxl_clip_stats account = {0, 0, 0};
        fxl_direction normal = unit_direction();
        fxl_point through = unit_point(Q16(1000));
        fxl_plane plane = fxl_plane_from_point(&through, &normal, 0);
        fxl_half_space half_space;
        fxl_half_space_from_plane(&plane, &half_space);
        polygon.count = in->count = 3;
        polygon.textured = true;
        in->carried = 1;
        for (int k = 0; k < 3; k++) {
            fxl_vertex *vertex = &polygon.vertices[k];
            vertex->position = unit_point(FXL_COORDINATE_MAX);
            vertex->u = unit_between(-Q16(16383), Q16(16383));
            in->vertices[k].position =
                (fxl_view_point){vertex->position.x * (int64_t)FXL_Q2_30_ONE,
                                 vertex->position.y * (int64_t)FXL_Q2_30_ONE,
                                 vertex->position.z * (int64_t)FXL_Q2_30_ONE};
            in->vertices[k].carried[0] = vertex->u;
        }
        fxl_clip_result cut = fxl_clip_to_half_space(in, &half_space, &account, out, distances);
        TEST_ASSERT_EQUAL(fxl_clip_world_to_plane(&polygon, &plane, &other, distances), cut);
        for (int k = 0; cut == FXL_CLIP_CUT && k < out->count; k++) {
            const fxl_view_point *at = &out->vertices[k].position;
            const fxl_vertex *expected = &other.vertices[k];
            TEST_ASSERT_NEAR(rounded(at->x), expected->position.x, 4);
            TEST_ASSERT_NEAR(rounded(at->y), expected->position.y, 4);
            TEST_ASSERT_NEAR(rounded(at->z), expected->position.z, 4);
            TEST_ASSERT_NEAR(out->vertices[k].carried[0], expected->u, 4);
        }
        cuts += cut == FXL_CLIP_CUT;
    }
    TEST_ASSERT_TRUE(cuts > UNIT_REPEAT / 100);
}

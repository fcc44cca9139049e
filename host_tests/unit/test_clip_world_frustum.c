/* SPDX-License-Identifier: MIT */
/* Polygons of the world, cut by the planes of a frustum: all of them, or some. */
#include "unit.h"
#include "study/clip_world.h"

static fxl_q18_46 distances[FXL_POLYGON_CAPACITY];
static fxl_clip_world_work work;

static fxl_frustum frustum_of(fxl_lens *lens)
{
    fxl_pose pose = {{0, 0, 0}, 0, 0, 0};
    fxl_camera camera;
    fxl_frustum frustum;
    *lens = unit_lens(64, 64);
    TEST_ASSERT_EQUAL(FXL_OK, fxl_camera_from_pose(&pose, &camera));
    fxl_frustum_from_camera(&camera, lens, &frustum);
    return frustum;
}

/* A square across the view at some depth. */
static fxl_polygon across(fxl_q16_16 left, fxl_q16_16 bottom, fxl_q16_16 right, fxl_q16_16 top,
                          fxl_q16_16 depth)
{
    return (fxl_polygon){.colour = 3,
                         .count = 4,
                         .vertices = {{{left, bottom, depth}, 0, 0},
                                      {{left, top, depth}, 0, 0},
                                      {{right, top, depth}, 0, 0},
                                      {{right, bottom, depth}, 0, 0}}};
}

static fxl_clip_result clip(const fxl_polygon *polygon, const fxl_polygon **result)
{
    fxl_lens lens;
    fxl_frustum frustum = frustum_of(&lens);
    return fxl_clip_world_to_frustum(polygon, &frustum, &work, result);
}

void test_frustum_inside_returns_the_input(void)
{
    fxl_polygon polygon = across(Q16(-5), Q16(-5), Q16(5), Q16(5), Q16(10));
    const fxl_polygon *result = NULL;
    TEST_ASSERT_EQUAL(FXL_CLIP_INSIDE, clip(&polygon, &result));
    TEST_ASSERT_EQUAL_PTR(&polygon, result);
}

void test_frustum_outside_returns_null(void)
{
    /* Left, bottom, right, top, depth. */
    static const fxl_q16_16 squares[][5] = {{Q16(-50), Q16(-5), Q16(-20), Q16(5), Q16(10)},
                                            {Q16(20), Q16(-5), Q16(50), Q16(5), Q16(10)},
                                            {Q16(-5), Q16(-50), Q16(5), Q16(-20), Q16(10)},
                                            {Q16(-5), Q16(20), Q16(5), Q16(50), Q16(10)},
                                            {Q16(-5), Q16(-5), Q16(5), Q16(5), Q16(-10)},
                                            {Q16(-5), Q16(-5), Q16(5), Q16(5), Q16(1000)}};
    for (int i = 0; i < 6; i++) {
        const fxl_q16_16 *at = squares[i];
        fxl_polygon polygon = across(at[0], at[1], at[2], at[3], at[4]);
        const fxl_polygon *result = &polygon;
        TEST_ASSERT_EQUAL(FXL_CLIP_OUTSIDE, clip(&polygon, &result));
        TEST_ASSERT_NULL(result);
    }
}

/* Off one corner of the screen without being outside any one plane alone. */
void test_frustum_outside_after_a_cut_returns_null(void)
{
    fxl_polygon polygon = {.colour = 1,
                           .count = 3,
                           .vertices = {{{Q16(-40), Q16(0), Q16(10)}, 0, 0},
                                        {{Q16(0), Q16(40), Q16(10)}, 0, 0},
                                        {{Q16(-40), Q16(40), Q16(10)}, 0, 0}}};
    const fxl_polygon *result = &polygon;
    fxl_clip_result outcome = clip(&polygon, &result);
    TEST_ASSERT_TRUE(outcome == FXL_CLIP_OUTSIDE || outcome == FXL_CLIP_DEGENERATE);
    TEST_ASSERT_NULL(result);
}

static void expect_within_frustum(const fxl_polygon *polygon, int count)
{
    fxl_lens lens;
    fxl_frustum frustum = frustum_of(&lens);
    TEST_ASSERT_EQUAL(count, polygon->count);
    for (int i = 0; i < polygon->count; i++) {
        for (int plane = 0; plane < FXL_PLANE_COUNT; plane++) {
            fxl_q18_46 d =
                fxl_plane_distance(&frustum.planes[plane], &polygon->vertices[i].position);
            TEST_ASSERT_TRUE_MESSAGE(d >= -2 * ((int64_t)1 << 30), "more than 2 units outside");
        }
    }
}

void test_two_planes_at_once(void)
{
    fxl_polygon polygon = across(0, 0, Q16(50), Q16(50), Q16(10));
    const fxl_polygon *result = NULL;
    TEST_ASSERT_EQUAL(FXL_CLIP_CUT, clip(&polygon, &result));
    TEST_ASSERT_TRUE(result == &work.polygons[0] || result == &work.polygons[1]);
    TEST_ASSERT_EQUAL(3, result->colour);
    expect_within_frustum(result, 4);
}

void test_four_planes_at_once(void)
{
    fxl_polygon polygon = across(Q16(-50), Q16(-50), Q16(50), Q16(50), Q16(10));
    const fxl_polygon *result = NULL;
    TEST_ASSERT_EQUAL(FXL_CLIP_CUT, clip(&polygon, &result));
    expect_within_frustum(result, 4);
}

/* A ground under the eye is cut by both sides, by near and by far. */
void test_a_ground_is_cut_by_sides_near_and_far(void)
{
    const fxl_q16_16 end = FXL_COORDINATE_MAX;
    fxl_polygon polygon = {.colour = 1,
                           .count = 4,
                           .vertices = {{{-end, Q16(-1), -end}, 0, 0},
                                        {{-end, Q16(-1), end}, 0, 0},
                                        {{end, Q16(-1), end}, 0, 0},
                                        {{end, Q16(-1), -end}, 0, 0}}};
    const fxl_polygon *result = NULL;
    TEST_ASSERT_EQUAL(FXL_CLIP_CUT, clip(&polygon, &result));
    expect_within_frustum(result, 4);
}

void test_three_planes_meet_in_a_corner(void)
{
    fxl_polygon polygon = {.colour = 1,
                           .count = 3,
                           .vertices = {{{Q16(0), Q16(0), Q16(900)}, 0, 0},
                                        {{Q16(3000), Q16(0), Q16(1100)}, 0, 0},
                                        {{Q16(0), Q16(3000), Q16(1100)}, 0, 0}}};
    const fxl_polygon *result = NULL;
    TEST_ASSERT_EQUAL(FXL_CLIP_CUT, clip(&polygon, &result));
    TEST_ASSERT_TRUE(result->count >= 4);
    expect_within_frustum(result, result->count);
}

void test_frustum_refuses_what_exceeds_the_capacity(void)
{
    fxl_polygon polygon = {.colour = 1, .count = FXL_POLYGON_CAPACITY};
    for (int i = 0; i < polygon.count; i++) {
        polygon.vertices[i].position =
            (fxl_point){i % 2 ? Q16(-50) : Q16(0), (i - 16) * 32768, Q16(10)};
    }
    const fxl_polygon *result = &polygon;
    TEST_ASSERT_EQUAL(FXL_CLIP_CAPACITY, clip(&polygon, &result));
    TEST_ASSERT_NULL(result);
}

/* A slanted plane whose normal has two equal parts holds (-z, y, z) exactly. */
void test_vertices_exactly_on_a_slanted_plane_stay(void)
{
    const fxl_plane left = {{759250125, 0, 759250125}, 0};
    fxl_polygon polygon = across(Q16(-10), Q16(-5), Q16(5), Q16(5), Q16(10)), out;
    TEST_ASSERT_EQUAL_INT64(0, fxl_plane_distance(&left, &polygon.vertices[0].position));
    TEST_ASSERT_EQUAL(FXL_CLIP_INSIDE, fxl_clip_world_to_plane(&polygon, &left, &out, distances));
    polygon.vertices[2].position.x = Q16(-20);
    polygon.vertices[2].position.y = Q16(6);
    polygon.vertices[3].position.x = Q16(-9);
    polygon.vertices[3].position.y = Q16(9);
    TEST_ASSERT_EQUAL(FXL_CLIP_CUT, fxl_clip_world_to_plane(&polygon, &left, &out, distances));
    TEST_ASSERT_EQUAL(4, out.count);
}

static fxl_clip_result clip_to(fxl_planes planes, const fxl_polygon *polygon,
                               const fxl_polygon **result)
{
    fxl_lens lens;
    fxl_frustum frustum = frustum_of(&lens);
    return fxl_clip_world_to_planes(polygon, &frustum, planes, &work, result);
}

/* Nearer than near and farther than far there is something to see; behind the eye there is not. */
void test_sides_without_near_and_far(void)
{
    const fxl_polygon *result;
    const fxl_polygon close = across(-300, -300, 300, 300, 2000), /* near is 4096 */
        distant = across(Q16(-5), Q16(-5), Q16(5), Q16(5), Q16(2000)),
                      behind = across(Q16(-5), Q16(-5), Q16(5), Q16(5), Q16(-10));
    TEST_ASSERT_EQUAL(FXL_CLIP_OUTSIDE, clip(&close, &result));
    TEST_ASSERT_EQUAL(FXL_CLIP_OUTSIDE, clip(&distant, &result));
    TEST_ASSERT_EQUAL(FXL_CLIP_INSIDE, clip_to(FXL_PLANES_SIDES, &close, &result));
    TEST_ASSERT_EQUAL_PTR(&close, result);
    TEST_ASSERT_EQUAL(FXL_CLIP_INSIDE, clip_to(FXL_PLANES_SIDES, &distant, &result));
    TEST_ASSERT_TRUE(clip_to(FXL_PLANES_SIDES, &behind, &result) != FXL_CLIP_CUT);
    TEST_ASSERT_NULL(result);
    TEST_ASSERT_EQUAL(FXL_CLIP_INSIDE, clip_to(0, &behind, &result));
    TEST_ASSERT_EQUAL_PTR(&behind, result);
}

/* A ground from behind the eye to beyond far: the sides leave a triangle or more that reaches past
 * far and below near. */
void test_a_ground_between_the_sides_alone(void)
{
    const fxl_q16_16 end = Q16(3000);
    const fxl_polygon ground = {.count = 4,
                                .vertices = {{{-end, Q16(-0.01), -end}, 0, 0},
                                             {{-end, Q16(-0.01), end}, 0, 0},
                                             {{end, Q16(-0.01), end}, 0, 0},
                                             {{end, Q16(-0.01), -end}, 0, 0}}};
    const fxl_polygon *result;
    fxl_q16_16 nearest = end, farthest = -end;
    TEST_ASSERT_EQUAL(FXL_CLIP_CUT, clip_to(FXL_PLANES_SIDES, &ground, &result));
    for (int i = 0; i < result->count; i++) {
        const fxl_q16_16 z = result->vertices[i].position.z;
        nearest = z < nearest ? z : nearest;
        farthest = z > farthest ? z : farthest;
    }
    TEST_ASSERT_TRUE(nearest > 0 && nearest < 4096 && farthest == end);
}

/* By some planes: what each of them, one after the other, leaves. The others are never asked. */
void test_any_planes_one_after_the_other(void)
{
    static fxl_polygon one[2];
    int cut_count = 0;
    fxl_lens lens;
    const fxl_frustum frustum = frustum_of(&lens);
    for (int i = 0; i < UNIT_REPEAT / 10; i++) {
        const fxl_planes planes = (fxl_planes)(unit_random() % (FXL_PLANES_ALL + 1u));
        const fxl_q16_16 limit = i % 2 ? Q16(20) : Q16(2000);
        fxl_polygon polygon = {.count = 3};
        for (int k = 0; k < 3; k++) {
            polygon.vertices[k].position = unit_point(limit);
        }
        const fxl_polygon *result, *wanted = &polygon;
        fxl_clip_result all = FXL_CLIP_INSIDE;
        for (int plane = 0; plane < FXL_PLANE_COUNT && wanted != NULL; plane++) {
            if ((planes >> plane & 1u) == 0) {
                continue;
            }
            fxl_polygon *out = wanted == &one[0] ? &one[1] : &one[0];
            const fxl_clip_result cut =
                fxl_clip_world_to_plane(wanted, &frustum.planes[plane], out, distances);
            wanted = cut == FXL_CLIP_CUT ? out : cut == FXL_CLIP_INSIDE ? wanted : NULL;
            all = cut == FXL_CLIP_INSIDE ? all : cut;
        }
        TEST_ASSERT_EQUAL(all,
                          fxl_clip_world_to_planes(&polygon, &frustum, planes, &work, &result));
        TEST_ASSERT_EQUAL(wanted != NULL, result != NULL);
        for (int k = 0; wanted != NULL && k < wanted->count; k++) {
            TEST_ASSERT_EQUAL(wanted->count, result->count);
            TEST_ASSERT_EQUAL_MEMORY(&wanted->vertices[k].position, &result->vertices[k].position,
                                     sizeof(fxl_point));
        }
        cut_count += all == FXL_CLIP_CUT;
    }
    TEST_ASSERT_TRUE(cut_count > UNIT_REPEAT / 100);
}

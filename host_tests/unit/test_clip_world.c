/* SPDX-License-Identifier: MIT */
/* Polygons of the world, cut by one plane, and by the planes of a frustum. */
#include <math.h>

#include "clip_unit.h"
#include "unit.h"
#include "study/clip_world.h"

static fxl_q18_46 distances[FXL_POLYGON_CAPACITY];

/* Inside is x >= 0. */
static const fxl_plane wall = {{FXL_Q2_30_ONE, 0, 0}, 0};

/* A polygon in the plane z = 0 from whole numbers x, y; u and v are the same numbers. */
static fxl_polygon flat(const plane_polygon *from)
{
    fxl_polygon polygon = {.colour = 5, .count = from->count, .textured = true};
    for (int i = 0; i < from->count; i++) {
        fxl_q16_16 x = from->numbers[2 * i] * 65536, y = from->numbers[2 * i + 1] * 65536;
        polygon.vertices[i] = (fxl_vertex){{x, y, 0}, x, y};
    }
    return polygon;
}

/* Which vertex comes first is not laid down; their order is. */
static void expect_same(const char *name, const fxl_polygon *expected, const fxl_polygon *actual)
{
    int first = 0;
    TEST_ASSERT_EQUAL_MESSAGE(expected->colour, actual->colour, name);
    TEST_ASSERT_EQUAL_MESSAGE(expected->count, actual->count, name);
    while (first + 1 < actual->count && memcmp(&actual->vertices[first], &expected->vertices[0],
                                               sizeof expected->vertices[0]) != 0) {
        first++;
    }
    for (int i = 0; i < expected->count; i++) {
        const fxl_vertex *want = &expected->vertices[i];
        const fxl_vertex *got = &actual->vertices[(first + i) % actual->count];
        TEST_ASSERT_EQUAL_INT32_MESSAGE(want->position.x, got->position.x, name);
        TEST_ASSERT_EQUAL_INT32_MESSAGE(want->position.y, got->position.y, name);
        TEST_ASSERT_EQUAL_INT32_MESSAGE(want->position.z, got->position.z, name);
        TEST_ASSERT_EQUAL_INT32_MESSAGE(want->u, got->u, name);
        TEST_ASSERT_EQUAL_INT32_MESSAGE(want->v, got->v, name);
    }
}

/* What is not cut writes nothing. */
void test_cases_of_one_plane(void)
{
    for (int i = 0; i < PLANE_CASES; i++) {
        const plane_case *one = &plane_cases[i];
        fxl_polygon polygon = flat(&one->polygon), out;
        memset(&out, 0x5A, sizeof out);
        TEST_ASSERT_EQUAL_MESSAGE(
            one->result, fxl_clip_world_to_plane(&polygon, &wall, &out, distances), one->name);
        if (one->result == FXL_CLIP_CUT) {
            polygon = flat(&one->left);
            expect_same(one->name, &polygon, &out);
        } else if (one->result != FXL_CLIP_DEGENERATE) {
            TEST_ASSERT_EACH_EQUAL_HEX8_MESSAGE(0x5A, &out, sizeof out, one->name);
        }
    }
}

/* clippers 1.2c */
void test_texture_is_cut_by_the_same_fraction(void)
{
    static const plane_polygon square = {4, {-3, 0, 1, 0, 1, 4, -3, 4}};
    fxl_polygon polygon = flat(&square), out;
    polygon.vertices[0].u = Q16(10);
    polygon.vertices[1].u = Q16(50);
    polygon.vertices[0].v = Q16(-800);
    polygon.vertices[1].v = Q16(800);
    TEST_ASSERT_EQUAL(FXL_CLIP_CUT, fxl_clip_world_to_plane(&polygon, &wall, &out, distances));
    TEST_ASSERT_EQUAL(4, out.count);
    TEST_ASSERT_EQUAL_INT32(0, out.vertices[0].position.x);
    TEST_ASSERT_EQUAL_INT32(Q16(40), out.vertices[0].u);
    TEST_ASSERT_EQUAL_INT32(Q16(400), out.vertices[0].v);
    polygon.textured = false;
    TEST_ASSERT_EQUAL(FXL_CLIP_CUT, fxl_clip_world_to_plane(&polygon, &wall, &out, distances));
    TEST_ASSERT_EQUAL_INT32(0, out.vertices[0].u);
    TEST_ASSERT_EQUAL_INT32(0, out.vertices[0].v);
}

/* Teeth that stand out of the wall: each adds two vertices and takes one. */
static fxl_polygon zigzag(uint8_t count)
{
    fxl_polygon polygon = {.colour = 1, .count = count};
    for (int i = 0; i < count; i++) {
        polygon.vertices[i].position = (fxl_point){i % 2 ? Q16(-9) : Q16(9), i * 65536, 0};
    }
    return polygon;
}

void test_more_than_the_capacity_is_refused(void)
{
    static struct {
        fxl_polygon out;
        uint8_t guard[64];
    } workspace;
    memset(workspace.guard, 0x5A, sizeof workspace.guard);
    for (uint8_t count = 4; count <= FXL_POLYGON_CAPACITY; count = (uint8_t)(count + 2)) {
        fxl_polygon polygon = zigzag(count);
        int left = count / 2 + count;
        fxl_clip_result result =
            fxl_clip_world_to_plane(&polygon, &wall, &workspace.out, distances);
        expect_capacity(result, left, workspace.out.count);
    }
    TEST_ASSERT_EACH_EQUAL_HEX8(0x5A, workspace.guard, sizeof workspace.guard);
}

static fxl_plane random_plane(fxl_q16_16 limit)
{
    fxl_point on = unit_point(limit);
    fxl_direction normal = unit_direction();
    return fxl_plane_from_point(&on, &normal, unit_between(0, FXL_INSET_MAX));
}

static fxl_vertex random_vertex(fxl_q16_16 limit)
{
    return (fxl_vertex){unit_point(limit), unit_between(-Q16(4096), Q16(4096)),
                        unit_between(-Q16(4096), Q16(4096))};
}

/* The two neighbours walk the edge a-b in opposite directions; the vertex that
 * neither had before must be one and the same. */
/* clippers 7.4 */
void test_neighbours_get_the_same_vertex(void)
{
    int cut = 0;
    for (int i = 0; i < UNIT_REPEAT; i++) {
        fxl_q16_16 limit = i % 2 ? FXL_COORDINATE_MAX : Q16(1);
        fxl_plane plane = random_plane(limit);
        fxl_vertex a = random_vertex(limit), b = random_vertex(limit);
        fxl_polygon first = {
            .count = 3, .textured = true, .vertices = {a, b, random_vertex(limit)}};
        fxl_polygon outs[2];
        fxl_polygon second = {
            .count = 3, .textured = true, .vertices = {b, a, random_vertex(limit)}};
        int64_t at_a = fxl_plane_distance(&plane, &a.position);
        int64_t at_b = fxl_plane_distance(&plane, &b.position);
        if ((at_a < 0) == (at_b < 0) || at_a == 0 || at_b == 0) {
            continue;
        }
        if (fxl_clip_world_to_plane(&first, &plane, &outs[0], distances) != FXL_CLIP_CUT ||
            fxl_clip_world_to_plane(&second, &plane, &outs[1], distances) != FXL_CLIP_CUT) {
            continue;
        }
        EXPECT_SHARED_CROSSING(outs, a, b, at_a > 0);
        cut++;
    }
    TEST_ASSERT_TRUE(cut > UNIT_REPEAT / 4);
}

/* Takes from low..high the fractions whose point of the edge lies within 0.51
 * of the vertex in one coordinate. */
static void narrow(double from, double to, double at, double *low, double *high)
{
    double span = to - from;
    if (span == 0) {
        *high = fabs(at - from) <= 0.51 ? *high : -1;
        return;
    }
    double one = (at - 0.51 - from) / span, other = (at + 0.51 - from) / span;
    *low = fmax(*low, fmin(one, other));
    *high = fmin(*high, fmax(one, other));
}

/* docs/accuracy.md, section 1. Doubles have 53 bits: fractions of an edge of 2^30 units
 * come out to 2^-23 unit, and the plane's distance of 2^61 to 2^-22 unit. */
/* accuracy 1.2b */
void test_a_new_vertex_is_within_its_bounds(void)
{
    for (int i = 0; i < UNIT_REPEAT; i++) {
        static const fxl_q16_16 limits[] = {FXL_COORDINATE_MAX, Q16(100), 3000};
        fxl_q16_16 limit = limits[i % 3];
        fxl_plane plane = random_plane(limit);
        fxl_polygon polygon = {.count = 3, .textured = true}, out;
        for (int k = 0; k < 3; k++) {
            polygon.vertices[k] = random_vertex(limit);
        }
        if (fxl_clip_world_to_plane(&polygon, &plane, &out, distances) != FXL_CLIP_CUT) {
            continue;
        }
        for (int k = 0; k < out.count; k++) {
            const fxl_vertex *v = &out.vertices[k];
            double best = 1e30;
            for (int e = 0; e < 3 && !plane_has_vertex(polygon.vertices, 3, sizeof *v, v); e++) {
                const fxl_vertex *a = &polygon.vertices[e], *b = &polygon.vertices[(e + 1) % 3];
                double low = 0, high = 1;
                narrow(a->position.x, b->position.x, v->position.x, &low, &high);
                narrow(a->position.y, b->position.y, v->position.y, &low, &high);
                narrow(a->position.z, b->position.z, v->position.z, &low, &high);
                narrow(a->u, b->u, v->u, &low, &high);
                narrow(a->v, b->v, v->v, &low, &high);
                if (low <= high) {
                    double dx = (double)b->position.x - a->position.x;
                    double dy = (double)b->position.y - a->position.y;
                    double dz = (double)b->position.z - a->position.z;
                    best = fmin(best, sqrt(dx * dx + dy * dy + dz * dz));
                }
            }
            if (best < 1e30) {
                double off = (double)fxl_plane_distance(&plane, &v->position) / 1073741824.0;
                TEST_ASSERT_NEAR(off, 0, best / 536870912.0 + 0.9);
            } else {
                TEST_ASSERT_TRUE_MESSAGE(plane_has_vertex(polygon.vertices, 3, sizeof *v, v),
                                         "a vertex off every edge");
                TEST_ASSERT_TRUE(fxl_plane_distance(&plane, &v->position) >= 0);
            }
        }
    }
}

static fxl_clip_world_work work;

static fxl_frustum frustum_of(fxl_lens *lens)
{
    fxl_pose pose = {{0, 0, 0}, 0, 0, 0};
    fxl_camera camera;
    fxl_view_frustum sides;
    fxl_frustum frustum;
    *lens = unit_lens(64, 64);
    TEST_ASSERT_EQUAL(FXL_OK, fxl_camera_from_pose(&pose, &camera));
    fxl_view_frustum_from_lens(lens, &sides);
    fxl_frustum_from_sides(&camera, lens, &sides, &frustum);
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
    return fxl_clip_world_to_planes(polygon, &frustum, FXL_PLANES_ALL, &work, result);
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

/* SPDX-License-Identifier: MIT */
/* Polygons of the world, cut by one plane. */
#include <math.h>

#include "plane_cases.h"
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

/* clippers 1.2 */
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
/* accuracy 1.2 */
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

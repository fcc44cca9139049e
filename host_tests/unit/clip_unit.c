/* SPDX-License-Identifier: MIT */
#include "clip_unit.h"

fxl_varying_polygon clip_shape(const int *numbers, size_t count)
{
    fxl_varying_polygon polygon;
    memset(&polygon, 0, sizeof polygon);
    polygon.colour = 3;
    polygon.count = (uint8_t)count;
    polygon.carried = 2;
    for (size_t i = 0; i < count; i++) {
        polygon.vertices[i].position =
            (fxl_view_point){V(numbers[3 * i]), V(numbers[3 * i + 1]), V(numbers[3 * i + 2])};
        polygon.vertices[i].carried[0] = numbers[3 * i] * 65536;
        polygon.vertices[i].carried[1] = (fxl_q16_16)i * 65536;
    }
    return polygon;
}

fxl_varying_polygon clip_saw(uint8_t count, int reach)
{
    fxl_varying_polygon polygon;
    memset(&polygon, 0, sizeof polygon);
    polygon.count = count;
    for (int i = 0; i < count; i++) {
        polygon.vertices[i].position =
            (fxl_view_point){i % 2 ? V(-reach) : 0, V(i - 16) / 2, V(10)};
    }
    return polygon;
}

static bool same_vertex(const fxl_varying_vertex *a, const fxl_varying_vertex *b, uint32_t carried)
{
    return a->position.x == b->position.x && a->position.y == b->position.y &&
           a->position.z == b->position.z &&
           memcmp(a->carried, b->carried, carried * sizeof a->carried[0]) == 0;
}

static bool same_from(const fxl_varying_polygon *a, const fxl_varying_polygon *b, uint32_t first)
{
    for (uint32_t i = 0; i < a->count; i++) {
        if (!same_vertex(&a->vertices[i], &b->vertices[(first + i) % b->count], a->carried)) {
            return false;
        }
    }
    return true;
}

bool clip_same(const fxl_varying_polygon *a, const fxl_varying_polygon *b)
{
    bool same = false;
    for (uint32_t first = 0; first < b->count; first++) {
        same = same || same_from(a, b, first);
    }
    return same && a->count == b->count && a->carried == b->carried && a->colour == b->colour;
}

/* centre + a cos + b sin, by multiples of 1/8 turn, which keep it convex and
 * clockwise or not alike. */
fxl_varying_polygon clip_random_shape(unsigned bits)
{
    static const int cosines[8] = {10, 7, 0, -7, -10, -7, 0, 7};
    fxl_varying_polygon polygon;
    memset(&polygon, 0, sizeof polygon);
    int64_t centre[3], a[3], b[3];
    for (int k = 0; k < 3; k++) {
        centre[k] = unit_wide(bits - 2);
        a[k] = unit_wide(bits - 2) / 16;
        b[k] = unit_wide(bits - 2) / 16;
    }
    centre[2] = centre[2] < 0 && unit_random() % 4 != 0 ? -centre[2] : centre[2];
    const int step = FXL_FACE_VERTICES_MAX < 8 ? 2 : 1;
    polygon.count = (uint8_t)(8 / step);
    polygon.carried = FXL_CARRIED_MAX;
    for (int i = 0; i < polygon.count; i++) {
        int64_t c = cosines[i * step], s = cosines[(i * step + 6) % 8];
        polygon.vertices[i].position =
            (fxl_view_point){centre[0] + a[0] * c + b[0] * s, centre[1] + a[1] * c + b[1] * s,
                             centre[2] + a[2] * c + b[2] * s};
        for (int k = 0; k < FXL_CARRIED_MAX; k++) {
            polygon.vertices[i].carried[k] = unit_between(-Q16(16383), Q16(16383));
        }
    }
    return polygon;
}

fxl_view clip_random_view(uint16_t width, uint16_t height)
{
    fxl_view view;
    fxl_pose pose = unit_pose();
    pose.position = unit_point(Q16(100));
    fxl_lens lens = unit_lens(width, height);
    fxl_view_set_lens(&view, &lens);
    TEST_ASSERT_EQUAL(FXL_OK, fxl_view_set_pose(&view, &pose));
    return view;
}

fxl_point clip_place(const fxl_view *view, fxl_q16_16 x, fxl_q16_16 y, fxl_q16_16 z)
{
    const fxl_camera *camera = &view->camera;
    const fxl_direction *r = &camera->axes.right, *u = &camera->axes.up, *f = &camera->axes.forward;
    return (fxl_point){
        camera->position.x +
            (fxl_q16_16)(((int64_t)r->x * x + (int64_t)u->x * y + (int64_t)f->x * z) >> 30),
        camera->position.y +
            (fxl_q16_16)(((int64_t)r->y * x + (int64_t)u->y * y + (int64_t)f->y * z) >> 30),
        camera->position.z +
            (fxl_q16_16)(((int64_t)r->z * x + (int64_t)u->z * y + (int64_t)f->z * z) >> 30)};
}

fxl_polygon clip_random_face(const fxl_view *view)
{
    static const int8_t ring[6][2] = {{8, 0}, {4, 7}, {-4, 7}, {-8, 0}, {-4, -7}, {4, -7}};
    int step = unit_random() % 2 == 0 ? 1 : 2;
    fxl_polygon polygon = {.colour = (uint8_t)unit_random(), .count = (uint8_t)(6 / step)};
    fxl_q16_16 depth = unit_between(Q16(0.5), Q16(20)), size = unit_between(Q16(0.01), Q16(1));
    fxl_q16_16 x = unit_between(-depth, depth), y = unit_between(-depth, depth);
    int lean = unit_between(-2, 2);
    for (int i = 0; i < polygon.count; i++) {
        int across = ring[i * step][0], up = ring[i * step][1];
        polygon.vertices[i].position = clip_place(view, x + across * size, y + up * size,
                                                  depth + lean * (across + up) * (size / 2));
    }
    return polygon;
}

const plane_case plane_cases[PLANE_CASES] = {
    {"wholly inside", FXL_CLIP_INSIDE, {3, {1, 0, 3, 0, 3, 2}}, {0, {0}}},
    {"wholly outside", FXL_CLIP_OUTSIDE, {3, {-1, 0, -3, 0, -3, 2}}, {0, {0}}},
    {"a vertex touches from inside", FXL_CLIP_INSIDE, {3, {0, 0, 3, 0, 3, 2}}, {0, {0}}},
    {"an edge touches from inside", FXL_CLIP_INSIDE, {3, {0, 0, 0, 5, 3, 2}}, {0, {0}}},
    {"all in the plane", FXL_CLIP_INSIDE, {3, {0, 0, 0, 5, 0, 2}}, {0, {0}}},
    {"a vertex touches from outside", FXL_CLIP_DEGENERATE, {3, {0, 0, -3, 0, -3, 2}}, {0, {0}}},
    {"an edge touches from outside", FXL_CLIP_DEGENERATE, {3, {0, 0, 0, 2, -3, 2}}, {0, {0}}},
    {"a square is halved",
     FXL_CLIP_CUT,
     {4, {-4, 0, 4, 0, 4, 4, -4, 4}},
     {4, {0, 0, 4, 0, 4, 4, 0, 4}}},
    {"a corner is cut off", FXL_CLIP_CUT, {3, {-2, 2, 2, 4, 2, 0}}, {4, {0, 1, 0, 3, 2, 4, 2, 0}}},
    /* A vertex in the plane comes once. */
    {"through two vertices",
     FXL_CLIP_CUT,
     {4, {0, 4, 4, 0, 0, -4, -4, 0}},
     {3, {0, 4, 4, 0, 0, -4}}},
    {"through one vertex", FXL_CLIP_CUT, {3, {0, 4, 4, 4, -4, -4}}, {3, {0, 4, 4, 4, 0, 0}}},
    {"along an edge's ends", FXL_CLIP_CUT, {4, {-4, 2, 0, 4, 4, 4, 0, 0}}, {3, {0, 0, 0, 4, 4, 4}}},
};

static const uint8_t *at(const void *vertices, int number, size_t size)
{
    return (const uint8_t *)vertices + (size_t)number * size;
}

bool plane_has_vertex(const void *vertices, int count, size_t size, const void *vertex)
{
    for (int i = 0; i < count; i++) {
        if (memcmp(at(vertices, i, size), vertex, size) == 0) {
            return true;
        }
    }
    return false;
}

/* What follows or precedes the inside end on the edge. */
static const void *crossing_of(const void *vertices, int count, size_t size, const void *a,
                               const void *b, bool a_is_inside)
{
    for (int k = 0; k < count; k++) {
        const void *here = at(vertices, k, size), *next = at(vertices, (k + 1) % count, size);
        if (a_is_inside && memcmp(here, a, size) == 0) {
            return next;
        }
        if (!a_is_inside && memcmp(next, b, size) == 0) {
            return here;
        }
    }
    return NULL;
}

void expect_shared_crossing(const void *const outs[2], const int counts[2], size_t size,
                            const void *a, const void *b, bool a_is_inside)
{
    const void *crossing = crossing_of(outs[0], counts[0], size, a, b, a_is_inside);
    TEST_ASSERT_NOT_NULL(crossing);
    TEST_ASSERT_TRUE_MESSAGE(plane_has_vertex(outs[1], counts[1], size, crossing),
                             "neighbours disagree");
}

void expect_capacity(fxl_clip_result result, int left, int count)
{
    if (left > FXL_POLYGON_CAPACITY) {
        TEST_ASSERT_EQUAL(FXL_CLIP_CAPACITY, result);
    } else {
        TEST_ASSERT_EQUAL(FXL_CLIP_CUT, result);
        TEST_ASSERT_EQUAL(left, count);
    }
}

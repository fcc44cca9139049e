/* SPDX-License-Identifier: MIT */
#include "plane_cases.h"

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

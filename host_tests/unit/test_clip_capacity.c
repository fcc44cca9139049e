/* SPDX-License-Identifier: MIT */
/* So many vertices and no more (C2). Outlines of any pattern of vertices inside, outside and on
 * one plane: each clipper makes exactly the vertices that the pattern asks for, or refuses, and
 * writes nothing beyond the capacity. */
#include "clip_unit.h"
#include "study/clip_once.h"
#include "study/clip_world.h"
#include "study/half_space.h"

/* x of a vertex at depth 10: inside the left plane x = -z, on it, outside it. */
enum {
    INSIDE = 0,
    ON = -10,
    OUTSIDE = -50
};

typedef struct {
    uint8_t count;
    int x[FXL_POLYGON_CAPACITY];
} pattern;

/* What is left on one side of the plane. */
typedef struct {
    fxl_clip_result result;
    uint32_t count; /* vertices of the whole result, even if it is refused */
    uint32_t intersections;
} outcome;

#define GUARD_BYTE 0x5A

/* What follows a clipper's output, which it must not write. */
typedef struct {
    uint8_t bytes[64];
} guard;

static void set_guard(guard *at)
{
    memset(at->bytes, GUARD_BYTE, sizeof at->bytes);
}

static void expect_guard(const guard *at)
{
    TEST_ASSERT_EACH_EQUAL_HEX8(GUARD_BYTE, at->bytes, sizeof at->bytes);
}

/* The y of a vertex, in halves of a unit. It stays within the planes bottom and top. */
static int height(uint32_t vertex)
{
    return (int)vertex - 16;
}

static pattern any_pattern(void)
{
    pattern of;
    const int likely = unit_between(1, 6); /* from teeth all the way to few crossings */
    of.count = (uint8_t)unit_between(FXL_POLYGON_CAPACITY / 2, FXL_POLYGON_CAPACITY);
    of.x[0] = unit_random() % 2 ? INSIDE : OUTSIDE;
    for (uint32_t i = 1; i < of.count; i++) {
        const bool changes = unit_random() % 6 < (uint32_t)likely;
        of.x[i] = (of.x[i - 1] == INSIDE) == changes ? OUTSIDE : INSIDE;
        of.x[i] = unit_random() % 32 == 0 ? ON : of.x[i];
    }
    return of;
}

static outcome expected(const pattern *of)
{
    outcome wanted = {FXL_CLIP_CUT, 0, 0};
    uint32_t inside = 0;
    for (uint32_t i = 0; i < of->count; i++) {
        const int here = of->x[i], next = of->x[i + 1 == of->count ? 0 : i + 1];
        inside += here != OUTSIDE;
        wanted.intersections +=
            (here == INSIDE && next == OUTSIDE) || (here == OUTSIDE && next == INSIDE);
    }
    wanted.count = inside + wanted.intersections;
    wanted.result = inside == of->count                   ? FXL_CLIP_INSIDE
                    : inside == 0                         ? FXL_CLIP_OUTSIDE
                    : wanted.count > FXL_POLYGON_CAPACITY ? FXL_CLIP_CAPACITY
                    : wanted.count < 3                    ? FXL_CLIP_DEGENERATE
                                                          : FXL_CLIP_CUT;
    return wanted;
}

/* How often each end was met: the tests that use it are not idle. */
static uint32_t refused, full;

static void expect_outcome(const pattern *of, fxl_clip_result result, uint32_t count)
{
    const outcome wanted = expected(of);
    TEST_ASSERT_EQUAL(wanted.result, result);
    if (result == FXL_CLIP_CUT) {
        TEST_ASSERT_EQUAL_UINT32(wanted.count, count);
    }
    refused += wanted.result == FXL_CLIP_CAPACITY && wanted.count == FXL_POLYGON_CAPACITY + 1;
    full += wanted.result == FXL_CLIP_CUT && wanted.count == FXL_POLYGON_CAPACITY;
}

/* Results of exactly the capacity, and of one vertex more, were among them. */
static void expect_both_ends(void)
{
    TEST_ASSERT_TRUE(refused > 0 && full > 0);
    refused = full = 0;
}

static fxl_varying_polygon varying(const pattern *of)
{
    fxl_varying_polygon polygon = clip_saw(of->count, 0);
    for (uint32_t i = 0; i < of->count; i++) {
        polygon.vertices[i].position = (fxl_view_point){V(of->x[i]), V(height(i)) / 2, V(10)};
    }
    return polygon;
}

enum {
    PATTERNS = UNIT_REPEAT / 10
};

/* A normal with two equal parts: its distances are 0 exactly on the plane. */
static const fxl_plane left = {{759250125, 0, 759250125}, 0};
static fxl_q18_46 distances[FXL_POLYGON_CAPACITY];

/* clippers 1.3 */
void test_in_the_world(void)
{
    static struct {
        fxl_polygon out;
        guard after;
    } room;
    set_guard(&room.after);
    for (int n = 0; n < PATTERNS; n++) {
        const pattern of = any_pattern();
        fxl_polygon polygon = {.colour = 1, .count = of.count};
        for (uint32_t i = 0; i < of.count; i++) {
            polygon.vertices[i].position = (fxl_point){of.x[i] * 65536, height(i) * 32768, Q16(10)};
        }
        fxl_clip_result result = fxl_clip_world_to_plane(&polygon, &left, &room.out, distances);
        expect_outcome(&of, result, room.out.count);
        expect_guard(&room.after);
    }
    expect_both_ends();
}

/* clippers 1.3 */
void test_in_the_view(void)
{
    static struct {
        fxl_view_polygon out;
        guard after;
    } room;
    const fxl_view_frustum frustum = {
        left.normal.x, left.normal.z, left.normal.x, left.normal.z, 0, 0, V(1), V(100), 0};
    set_guard(&room.after);
    for (int n = 0; n < PATTERNS; n++) {
        const pattern of = any_pattern();
        fxl_view_polygon polygon = {.colour = 1, .count = of.count};
        for (uint32_t i = 0; i < of.count; i++) {
            polygon.vertices[i].position = (fxl_view_point){V(of.x[i]), V(height(i)) / 2, V(10)};
        }
        fxl_clip_result result =
            fxl_clip_view_to_plane(&polygon, &frustum, FXL_PLANE_LEFT, &room.out, distances);
        expect_outcome(&of, result, room.out.count);
        expect_guard(&room.after);
    }
    expect_both_ends();
}

/* clippers 1.3 */
void test_by_half_spaces(void)
{
    static struct {
        fxl_varying_polygon out;
        guard after;
    } room;
    const fxl_half_space side = {{FXL_Q2_30_ONE / 2, 0, FXL_Q2_30_ONE / 2}, 0};
    set_guard(&room.after);
    for (int n = 0; n < PATTERNS; n++) {
        const pattern of = any_pattern();
        const fxl_varying_polygon polygon = varying(&of);
        fxl_clip_stats stats = {0, 0, 0};
        fxl_clip_result result =
            fxl_clip_to_half_space(&polygon, &side, &stats, &room.out, distances);
        expect_outcome(&of, result, room.out.count);
        if (result == FXL_CLIP_CUT) {
            TEST_ASSERT_EQUAL_UINT32(expected(&of).intersections, stats.intersections);
        }
        expect_guard(&room.after);
    }
    expect_both_ends();
}

/* After the polygon the workspace has the points where the outline crosses near, which none of
 * these outlines does. */
void test_all_planes_at_once(void)
{
    static fxl_clip_once_workspace workspace;
    const fxl_pose pose = {{0, 0, 0}, 0, 0, 0};
    fxl_camera camera;
    fxl_normalised frustum;
    fxl_lens lens = unit_lens(64, 64);
    lens.inset = 0;
    TEST_ASSERT_EQUAL(FXL_OK, fxl_camera_from_pose(&pose, &camera));
    fxl_normalised_from_camera(&camera, &lens, &frustum);
    memset(&workspace.cuts[FXL_PLANE_NEAR], GUARD_BYTE, sizeof workspace.cuts[FXL_PLANE_NEAR]);
    for (int n = 0; n < PATTERNS; n++) {
        const pattern of = any_pattern();
        const fxl_varying_polygon polygon = varying(&of);
        const fxl_varying_polygon *result;
        workspace.stats = (fxl_clip_stats){0, 0, 0};
        fxl_clip_result cut = fxl_clip_once(&polygon, &frustum, &workspace, &result);
        if (expected(&of).count > 2 && cut != FXL_CLIP_OUTSIDE) {
            expect_outcome(&of, cut, result != NULL ? result->count : 0);
        }
        TEST_ASSERT_EACH_EQUAL_HEX8(GUARD_BYTE, &workspace.cuts[FXL_PLANE_NEAR][0].vertex,
                                    sizeof workspace.cuts[FXL_PLANE_NEAR][0].vertex);
    }
    expect_both_ends();
}

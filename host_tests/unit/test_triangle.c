/* SPDX-License-Identifier: MIT */
/* Triangles by planes and by the screen's borders: the four cases, and the pieces. */
#include "clip_unit.h"
#include "study/triangle.h"

static fxl_triangle_workspace workspace;
static fxl_clip_stats stats;

/* Inside is x >= 0. */
static const fxl_half_space wall = {{FXL_Q2_30_ONE, 0, 0}, 0};

static fxl_clip_triangle solid(int x0, int y0, int x1, int y1, int x2, int y2)
{
    fxl_varying_polygon shape = SHAPE(x0, y0, 10, x1, y1, 10, x2, y2, 10);
    fxl_clip_triangle triangle = {{shape.vertices[0], shape.vertices[1], shape.vertices[2]}};
    return triangle;
}

/* x, y of each corner, in whole units, and x as it rides along. */
static void expect_corners(const fxl_clip_triangle *triangle, const int *numbers)
{
    for (int i = 0; i < 3; i++) {
        const fxl_varying_vertex *at = &triangle->corners[i];
        TEST_ASSERT_TRUE(at->position.x == V(numbers[2 * i]));
        TEST_ASSERT_NEAR(at->position.y, V(numbers[2 * i + 1]), 1);
        TEST_ASSERT_TRUE(at->position.z == V(10));
        TEST_ASSERT_EQUAL(numbers[2 * i] * 65536, at->carried[0]);
    }
}
#define EXPECT(triangle, ...) expect_corners(triangle, (const int[]){__VA_ARGS__})

void test_none_and_all(void)
{
    fxl_clip_triangle out[2], in = solid(-1, 0, -5, 0, -3, 4);
    stats.distances = 100;
    TEST_ASSERT_EQUAL(0, fxl_triangle_cut(&in, &wall, 2, &stats, out));
    TEST_ASSERT_EQUAL(100 + 3, stats.distances); /* one for each corner */
    in = solid(1, 0, 5, 0, 3, 4);
    TEST_ASSERT_EQUAL(1, fxl_triangle_cut(&in, &wall, 2, &stats, out));
    EXPECT(&out[0], 1, 0, 5, 0, 3, 4);
}

void test_one_corner_inside_leaves_one(void)
{
    fxl_clip_triangle out[2], in = solid(4, 0, -4, 8, -4, -8);
    TEST_ASSERT_EQUAL(1, fxl_triangle_cut(&in, &wall, 2, &stats, out));
    EXPECT(&out[0], 4, 0, 0, 4, 0, -4);
    in = solid(-4, -8, 4, 0, -4, 8); /* whichever it is */
    TEST_ASSERT_EQUAL(1, fxl_triangle_cut(&in, &wall, 2, &stats, out));
    EXPECT(&out[0], 4, 0, 0, 4, 0, -4);
    in = solid(-4, 8, -4, -8, 4, 0);
    TEST_ASSERT_EQUAL(1, fxl_triangle_cut(&in, &wall, 2, &stats, out));
    EXPECT(&out[0], 4, 0, 0, 4, 0, -4);
}

void test_two_corners_inside_leave_two(void)
{
    fxl_clip_triangle out[2];
    const fxl_clip_triangle in[3] = {solid(-4, 0, 4, 8, 4, -8), solid(4, -8, -4, 0, 4, 8),
                                     solid(4, 8, 4, -8, -4, 0)};
    for (int i = 0; i < 3; i++) {
        TEST_ASSERT_EQUAL(2, fxl_triangle_cut(&in[i], &wall, 2, &stats, out));
        EXPECT(&out[0], 4, 8, 4, -8, 0, -4);
        EXPECT(&out[1], 4, 8, 0, -4, 0, 4);
    }
}

/* What touches leaves nothing; a corner on the plane is its own crossing. */
void test_corners_on_the_plane(void)
{
    fxl_clip_triangle out[2], in = solid(0, 0, -4, 8, -4, -8);
    TEST_ASSERT_EQUAL(0, fxl_triangle_cut(&in, &wall, 2, &stats, out));
    in = solid(0, -4, 0, 4, -4, 0);
    TEST_ASSERT_EQUAL(0, fxl_triangle_cut(&in, &wall, 2, &stats, out));
    in = solid(0, -4, 0, 4, 4, 0);
    TEST_ASSERT_EQUAL(1, fxl_triangle_cut(&in, &wall, 2, &stats, out));
    stats.intersections = 0;
    in = solid(0, 0, 4, 4, -4, 4);
    TEST_ASSERT_EQUAL(1, fxl_triangle_cut(&in, &wall, 2, &stats, out));
    TEST_ASSERT_EQUAL(1, stats.intersections);
    in = solid(4, 4, 0, 0, -4, 4);
    TEST_ASSERT_EQUAL(1, fxl_triangle_cut(&in, &wall, 2, &stats, out));
}

/* A corner that is a single unit of 2^-46 inside is inside. */
void test_the_least_distance_counts(void)
{
    fxl_clip_triangle out[2], in = solid(0, 0, -4, 8, -4, -8);
    in.corners[0].position.x = 1;
    TEST_ASSERT_EQUAL(1, fxl_triangle_cut(&in, &wall, 2, &stats, out));
    for (int i = 0; i < 3; i++) { /* the two corners inside, by a unit or by 4, and one outside */
        in = solid(i == 0 ? -4 : 0, 0, i == 1 ? -4 : 0, 8, i == 2 ? -4 : 0, -8);
        in.corners[(i + 1) % 3].position.x = 1;
        in.corners[(i + 2) % 3].position.x = V(4);
        TEST_ASSERT_EQUAL(2, fxl_triangle_cut(&in, &wall, 2, &stats, out));
        in.corners[(i + 1) % 3].position.x = V(4);
        in.corners[(i + 2) % 3].position.x = 1;
        TEST_ASSERT_EQUAL(2, fxl_triangle_cut(&in, &wall, 2, &stats, out));
        /* On the plane instead, it leaves one triangle. */
        in.corners[(i + 2) % 3].position.x = 0;
        TEST_ASSERT_EQUAL(1, fxl_triangle_cut(&in, &wall, 2, &stats, out));
        in.corners[(i + 1) % 3].position.x = 0;
        in.corners[(i + 2) % 3].position.x = V(4);
        TEST_ASSERT_EQUAL(1, fxl_triangle_cut(&in, &wall, 2, &stats, out));
    }
}

void test_a_sliver_is_refused_where_asked(void)
{
    fxl_clip_triangle out[2], in = solid(-4, 8, 1, 0, -4, -8);
    stats.sliver = V(2);
    TEST_ASSERT_EQUAL(0, fxl_triangle_cut(&in, &wall, 2, &stats, out));
    stats.sliver = V(1);
    TEST_ASSERT_EQUAL(1, fxl_triangle_cut(&in, &wall, 2, &stats, out));
    stats.sliver = 0;
}

/* By the sliver rule a corner on the plane, after one outside, is outside. It stands for the
 * intersection. */
void test_a_corner_on_the_plane_by_the_sliver_rule(void)
{
    for (int turn = 0; turn < 3; turn++) {
        static const int x[3] = {-4, 0, 4}, y[3] = {0, 4, 0};
        fxl_clip_triangle out[2];
        const int a = turn, b = (turn + 1) % 3, c = (turn + 2) % 3;
        const fxl_clip_triangle in = solid(x[a], y[a], x[b], y[b], x[c], y[c]);
        stats = (fxl_clip_stats){.sliver = V(1)};
        TEST_ASSERT_EQUAL(1, fxl_triangle_cut(&in, &wall, 2, &stats, out));
        TEST_ASSERT_EQUAL(1, stats.intersections);
        int64_t most = 0;
        for (int i = 0; i < 3; i++) {
            const fxl_view_point *at = &out[0].corners[i].position;
            TEST_ASSERT_TRUE(at->x == 0 || at->x == V(4));
            most = at->y > most ? at->y : most;
        }
        TEST_ASSERT_TRUE(most == V(4));
        stats.sliver = 0;
    }
}

static fxl_screen_triangle flat(int x0, int y0, int x1, int y1, int x2, int y2)
{
    fxl_screen_triangle triangle;
    memset(&triangle, 0, sizeof triangle);
    triangle.corners[0].at = (fxl_screen_point){x0 * 65536, y0 * 65536};
    triangle.corners[1].at = (fxl_screen_point){x1 * 65536, y1 * 65536};
    triangle.corners[2].at = (fxl_screen_point){x2 * 65536, y2 * 65536};
    for (int i = 0; i < 3; i++) {
        triangle.corners[i].depth = V(10);
        triangle.corners[i].carried[0] = i * 65536;
    }
    return triangle;
}

/* Twice the area, in square units; positive as seen on the screen clockwise. */
static int64_t area_of(const fxl_screen_triangle *triangle)
{
    const fxl_screen_point *a = &triangle->corners[0].at, *b = &triangle->corners[1].at;
    const fxl_screen_point *c = &triangle->corners[2].at;
    return (int64_t)(b->x - a->x) * (c->y - a->y) - (int64_t)(c->x - a->x) * (b->y - a->y);
}

/* Each border halves a triangle that stands across it: 3/4 or 1/4 of it stays. */
void test_borders(void)
{
    static const int inner[4][6] = {
        {-4, 8, 4, 0, 4, 16}, {68, 8, 60, 16, 60, 0}, {8, -4, 16, 4, 0, 4}, {8, 68, 0, 60, 16, 60}};
    for (int border = 0; border < FXL_BORDER_COUNT; border++) {
        const int *n = inner[border];
        fxl_screen_triangle out[2], in = flat(n[0], n[1], n[2], n[3], n[4], n[5]);
        TEST_ASSERT_EQUAL(2, fxl_triangle_cut_screen(&in, border, 64, 1, &stats, out));
        TEST_ASSERT_TRUE(4 * (area_of(&out[0]) + area_of(&out[1])) == 3 * area_of(&in));
        TEST_ASSERT_TRUE((area_of(&out[0]) > 0) == (area_of(&in) > 0));
        /* The same with the other side inside. */
        bool sideways = border < FXL_BORDER_TOP;
        int middle = border % 2 == 0 ? 0 : 128;
        for (int i = 0; i < 3; i++) {
            fxl_screen_point *at = &in.corners[i].at;
            at->x = sideways ? middle * 65536 - at->x : at->x;
            at->y = sideways ? at->y : middle * 65536 - at->y;
        }
        TEST_ASSERT_EQUAL(1, fxl_triangle_cut_screen(&in, border, 64, 1, &stats, out));
        TEST_ASSERT_TRUE(4 * area_of(&out[0]) == area_of(&in));
    }
}

/* Each new vertex is an intersection. A vertex that is already on the border is none. */
void test_new_vertices_are_counted(void)
{
    fxl_screen_triangle out[2], in = flat(-4, 8, 4, 0, 4, 16);
    stats.intersections = 0;
    fxl_triangle_cut_screen(&in, FXL_BORDER_LEFT, 64, 1, &stats, out);
    TEST_ASSERT_EQUAL(2, stats.intersections);
    in = flat(-4, 8, 0, 0, 4, 16);
    TEST_ASSERT_EQUAL(1, fxl_triangle_cut_screen(&in, FXL_BORDER_LEFT, 64, 1, &stats, out));
    TEST_ASSERT_EQUAL(3, stats.intersections);
    TEST_ASSERT_EQUAL(4 * 65536, out[0].corners[0].at.x + out[0].corners[1].at.x +
                                     out[0].corners[2].at.x); /* 4, 0 and 0 */
}

static fxl_volume near_and_far(const fxl_lens *lens)
{
    fxl_volume volume;
    clip_volume(lens, 1u << FXL_PLANE_NEAR | 1u << FXL_PLANE_FAR, &volume);
    return volume;
}

static fxl_clip_triangle triangle_of(fxl_varying_polygon shape)
{
    return (fxl_clip_triangle){{shape.vertices[0], shape.vertices[1], shape.vertices[2]}};
}

/* A result that is null says whether it is the end or an error, whatever *status was. */
void test_next_says_how_it_ended(void)
{
    const fxl_lens lens = unit_lens(64, 48);
    fxl_volume volume = near_and_far(&lens);
    fxl_clip_triangle triangle = triangle_of(SHAPE(-1, -1, 10, 0, 2, 10, 1, -1, 10));
    workspace.stats = (fxl_clip_stats){0, 0, 0};
    TEST_ASSERT_EQUAL(FXL_CLIP_INSIDE, fxl_triangle_begin(&triangle, 2, &volume, &workspace));
    TEST_ASSERT_EQUAL(3 * FXL_PLANE_COUNT, workspace.stats.distances);
    fxl_status status = FXL_E_RANGE;
    const fxl_screen_triangle *piece = fxl_triangle_next(&volume, &lens, &workspace, &status);
    TEST_ASSERT_NOT_NULL(piece);
    TEST_ASSERT_EQUAL(FXL_OK, status);
    TEST_ASSERT_TRUE(piece->corners[1].depth == V(10) &&
                     piece->corners[1].carried[1] == triangle.corners[1].carried[1]);
    status = FXL_E_RANGE;
    TEST_ASSERT_NULL(fxl_triangle_next(&volume, &lens, &workspace, &status));
    TEST_ASSERT_EQUAL(FXL_OK, status);
    triangle.corners[0].position.x = V(-1) * 8000; /* beyond any screen, and no side to cut it */
    for (int plane = FXL_PLANE_LEFT; plane <= FXL_PLANE_TOP; plane++) {
        volume.planes[plane] = volume.planes[FXL_PLANE_NEAR];
    }
    TEST_ASSERT_EQUAL(FXL_CLIP_INSIDE, fxl_triangle_begin(&triangle, 2, &volume, &workspace));
    TEST_ASSERT_NULL(fxl_triangle_next(&volume, &lens, &workspace, &status));
    TEST_ASSERT_EQUAL(FXL_E_RANGE, status);
    TEST_ASSERT_NULL(fxl_triangle_next(&volume, &lens, &workspace, &status));
    TEST_ASSERT_EQUAL(FXL_OK, status);
}

/* clippers 3.2d */
void test_screen_touches_and_lines_are_left_out(void)
{
    fxl_screen_triangle out[2], in = flat(0, 8, -4, 0, -4, 16);
    TEST_ASSERT_EQUAL(0, fxl_triangle_cut_screen(&in, FXL_BORDER_LEFT, 64, 1, &stats, out));
    in = flat(0, 0, 0, 8, -4, 4);
    TEST_ASSERT_EQUAL(0, fxl_triangle_cut_screen(&in, FXL_BORDER_LEFT, 64, 1, &stats, out));
    in = flat(1, 1, 2, 2, 3, 3);
    TEST_ASSERT_EQUAL(0, fxl_triangle_cut_screen(&in, FXL_BORDER_LEFT, 64, 1, &stats, out));
}

/* Half way on the screen is not half way in space: with depths 10 and 30 it is a
 * quarter of the way from the nearer end. */
/* clippers 3.2b-c */
void test_what_rides_along_is_cut_as_in_space(void)
{
    fxl_screen_triangle out[2], in = flat(4, 0, -4, 0, 4, 8);
    in.corners[1].depth = V(30);
    in.corners[1].carried[0] = Q16(100);
    in.corners[1].carried[1] = Q16(-200);
    memset(out, 0x5A, sizeof out);
    TEST_ASSERT_EQUAL(2, fxl_triangle_cut_screen(&in, FXL_BORDER_LEFT, 64, 2, &stats, out));
    bool found = false;
    for (int i = 0; i < 6; i++) {
        const fxl_screen_corner *at = &out[i / 3].corners[i % 3];
        if (at->at.x == 0 && at->at.y == 0) {
            TEST_ASSERT_NEAR(at->depth, V(15), 2);
            TEST_ASSERT_NEAR(at->carried[0], Q16(25), 1);
            TEST_ASSERT_NEAR(at->carried[1], Q16(-50), 1);
            found = true;
        }
    }
    TEST_ASSERT_TRUE(found);
}

/* The largest depths, distances and ranges: the fraction stays one. */
void test_the_range_s_ends(void)
{
    const int32_t end = FXL_SCREEN_COORDINATE_MAX;
    const fxl_q18_46 depths[] = {(fxl_q18_46)1 << 37, ((fxl_q18_46)1 << 61) - 1};
    for (int i = 0; i < 8; i++) {
        fxl_screen_triangle out[2], in = flat(0, 0, 0, 0, 0, 0);
        in.corners[0].at = (fxl_screen_point){i & 4 ? 1 : end, 0};
        in.corners[1].at = (fxl_screen_point){i & 4 ? -1 : -end, end};
        in.corners[2].at = (fxl_screen_point){end, -end};
        in.corners[0].depth = depths[i & 1];
        in.corners[1].depth = depths[i >> 1 & 1];
        in.corners[1].carried[0] = Q16(16383);
        uint32_t made = fxl_triangle_cut_screen(&in, FXL_BORDER_LEFT, 1024, 1, &stats, out);
        TEST_ASSERT_EQUAL(2, made);
        for (int k = 0; k < 6; k++) {
            const fxl_screen_corner *at = &out[k / 3].corners[k % 3];
            TEST_ASSERT_TRUE(at->at.x >= 0 && at->depth >= depths[0] && at->depth <= depths[1]);
            TEST_ASSERT_TRUE(at->carried[0] >= 0 && at->carried[0] <= Q16(16383));
        }
    }
}

/* Huge triangles around the eye: every piece lies on the screen and none is turned
 * over. Near and far are those of the lens. */
/* clippers 3.2a */
void test_pieces_lie_on_the_screen(void)
{
    int pieces = 0, most = 0;
    for (int i = 0; i < UNIT_REPEAT / 20; i++) {
        fxl_lens lens = unit_any_lens();
        fxl_volume volume;
        fxl_varying_polygon shape = clip_random_shape(i % 2 ? 61 : (unsigned)unit_between(44, 61));
        fxl_clip_triangle triangle = {
            {shape.vertices[0], shape.vertices[1], shape.vertices[shape.count - 1]}};
        clip_volume(&lens, 1u << FXL_PLANE_NEAR | 1u << FXL_PLANE_FAR, &volume);
        fxl_clip_result begun = fxl_triangle_begin(&triangle, FXL_CARRIED_MAX, &volume, &workspace);
        if (begun != FXL_CLIP_INSIDE && begun != FXL_CLIP_CUT) {
            continue;
        }
        const fxl_screen_triangle *piece;
        fxl_status status;
        int made = 0, clockwise = 0;
        while ((piece = fxl_triangle_next(&volume, &lens, &workspace, &status)) != NULL) {
            made++;
            /* Slivers may be turned over by their rounding. */
            int64_t area = area_of(piece);
            clockwise += area > (int64_t)1 << 30 ? 1 : area < -((int64_t)1 << 30) ? -1000 : 0;
            for (int k = 0; k < 3; k++) {
                const fxl_screen_point *at = &piece->corners[k].at;
                TEST_ASSERT_TRUE(at->x >= 0 && at->x <= lens.width * 65536);
                TEST_ASSERT_TRUE(at->y >= 0 && at->y <= lens.height * 65536);
            }
        }
        TEST_ASSERT_EQUAL(FXL_OK, status);
        TEST_ASSERT_TRUE(clockwise >= 0 || clockwise % 1000 == 0);
        pieces += made;
        most = made > most ? made : most;
    }
    TEST_ASSERT_TRUE(pieces > UNIT_REPEAT / 100 && most >= 3);
}

/* The intersections with the borders count beside those with the planes. */
void test_the_borders_intersections_are_counted(void)
{
    fxl_lens lens = unit_lens(64, 48);
    fxl_volume volume;
    fxl_varying_polygon shape = SHAPE(-20, 0, 10, 0, 2, 10, 0, -2, 10); /* x = -10 is the border */
    fxl_clip_triangle triangle = {{shape.vertices[0], shape.vertices[1], shape.vertices[2]}};
    fxl_status status;
    uint32_t pieces = 0;
    clip_volume(&lens, 1u << FXL_PLANE_NEAR | 1u << FXL_PLANE_FAR, &volume);
    workspace.stats = (fxl_clip_stats){.intersections = 7};
    fxl_triangle_begin(&triangle, 2, &volume, &workspace);
    while (fxl_triangle_next(&volume, &lens, &workspace, &status) != NULL) {
        pieces++;
    }
    TEST_ASSERT_EQUAL(2, pieces);
    TEST_ASSERT_EQUAL(7 + 2, workspace.stats.intersections);
}

/* A wall about the whole screen: its pieces cover it, exactly. */
void test_a_wall_covers_the_screen(void)
{
    const fxl_lens lens = unit_lens(64, 48);
    const fxl_volume volume = near_and_far(&lens);
    const fxl_clip_triangle triangle =
        triangle_of(SHAPE(-100, -100, 10, 0, 200, 10, 100, -100, 10));
    TEST_ASSERT_EQUAL(FXL_CLIP_INSIDE, fxl_triangle_begin(&triangle, 2, &volume, &workspace));
    const fxl_screen_triangle *piece;
    fxl_status status;
    int64_t area = 0;
    while ((piece = fxl_triangle_next(&volume, &lens, &workspace, &status)) != NULL) {
        area += area_of(piece);
    }
    area = area < 0 ? -area : area;
    int64_t screen = (int64_t)2 * 64 * 48 * 65536 * 65536;
    TEST_ASSERT_TRUE(area == screen);
}

/* At any place and depth, all bits of both: what rides along goes by s z0 / (s z0 + (1 - s) z1). */
/* clippers 3.2b */
void test_fractions_in_space(void)
{
    for (int i = 0; i < UNIT_REPEAT / 50; i++) {
        fxl_screen_triangle out[2], in = flat(0, 0, 0, 0, 0, 0);
        const int bits = unit_between(38, 60);
        in.corners[0].at = (fxl_screen_point){unit_between(1, Q16(2000)), 0};
        in.corners[1].at = (fxl_screen_point){-unit_between(1, Q16(2000)), Q16(10)};
        in.corners[2].at = (fxl_screen_point){in.corners[1].at.x, Q16(-10)};
        for (int k = 0; k < 3; k++) {
            const int64_t more = unit_wide(36);
            in.corners[k].depth = ((int64_t)1 << bits) + (more < 0 ? -more : more);
            in.corners[k].carried[0] = unit_between(-Q16(16383), Q16(16383));
        }
        TEST_ASSERT_EQUAL(1, fxl_triangle_cut_screen(&in, FXL_BORDER_LEFT, 64, 1, &stats, out));
        for (int k = 1; k < 3; k++) {
            const fxl_screen_corner *a = &in.corners[0], *b = &in.corners[k];
            double from = (double)a->at.x * (double)a->depth;
            double to = -(double)b->at.x * (double)b->depth;
            double exact =
                a->carried[0] + ((double)b->carried[0] - a->carried[0]) * (from / (from + to));
            TEST_ASSERT_NEAR(out[0].corners[k].carried[0], exact, 0.52);
        }
    }
}

/* Draws a triangle by near, far and the borders. Returns the pieces, and in *area twice their
 * area. */
static uint32_t pieces_of(const fxl_varying_polygon *shape, fxl_q16_16 screen_sliver, int64_t *area)
{
    const fxl_lens lens = unit_lens(64, 48);
    const fxl_clip_triangle triangle = {
        {shape->vertices[0], shape->vertices[1], shape->vertices[2]}};
    fxl_volume volume;
    const fxl_screen_triangle *piece;
    fxl_status status;
    uint32_t pieces = 0;
    clip_volume(&lens, 1u << FXL_PLANE_NEAR | 1u << FXL_PLANE_FAR, &volume);
    workspace.stats = (fxl_clip_stats){0, 0, 0};
    workspace.screen_sliver = screen_sliver;
    fxl_triangle_begin(&triangle, 2, &volume, &workspace);
    *area = 0;
    while ((piece = fxl_triangle_next(&volume, &lens, &workspace, &status)) != NULL) {
        *area += area_of(piece);
        pieces++;
    }
    workspace.screen_sliver = 0;
    return pieces;
}

/* At depth 128 a pixel is 4 units. A triangle that reaches a quarter of a pixel onto the screen is
 * left out if the rule asks for more, at each border. It costs no intersection then. */
void test_a_sliver_of_the_screen_is_refused_where_asked(void)
{
    static const int numbers[4][9] = {{-128, 4, 128, -127, 0, 128, -128, -4, 128},
                                      {128, 4, 128, 127, 0, 128, 128, -4, 128},
                                      {-4, 96, 128, 0, 95, 128, 4, 96, 128},
                                      {-4, -96, 128, 0, -95, 128, 4, -96, 128}};
    for (int border = 0; border < 4; border++) {
        fxl_varying_polygon shape = clip_shape(numbers[border], 3);
        int64_t area, less;
        for (int i = 0; i < 3; i += 2) { /* outside by half a unit more */
            fxl_view_point *at = &shape.vertices[i].position;
            at->x += border == 0 ? -V(1) / 2 : border == 1 ? V(1) / 2 : 0;
            at->y += border == 2 ? V(1) / 2 : border == 3 ? -V(1) / 2 : 0;
        }
        TEST_ASSERT_EQUAL(1, pieces_of(&shape, 0, &area));
        TEST_ASSERT_EQUAL(2, workspace.stats.intersections);
        TEST_ASSERT_EQUAL(1, pieces_of(&shape, Q16(0.25), &less)); /* not less than the rule */
        TEST_ASSERT_TRUE(area != 0 && less == area);
        TEST_ASSERT_EQUAL(0, pieces_of(&shape, Q16(0.25) + 1, &less));
        TEST_ASSERT_EQUAL(0, workspace.stats.intersections);
    }
}

/* A corner that is barely on the screen stands for an intersection, which is not computed: of the
 * triangle with corners at -32, 1/4 and 32 pixels the left border leaves one piece instead of two.
 * The rule of the planes does not count for the borders. */
void test_a_corner_barely_on_the_screen_stands_for_the_crossing(void)
{
    fxl_varying_polygon shape = SHAPE(-256, 0, 128, -127, 32, 128, 0, 0, 128);
    int64_t area, less;
    TEST_ASSERT_EQUAL(2, pieces_of(&shape, 0, &area));
    TEST_ASSERT_EQUAL(2, workspace.stats.intersections);
    TEST_ASSERT_EQUAL(1, pieces_of(&shape, Q16(0.5), &less));
    TEST_ASSERT_EQUAL(1, workspace.stats.intersections);
    TEST_ASSERT_TRUE(area > 0 && less > 0 && less < area);
}

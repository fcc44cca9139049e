/* SPDX-License-Identifier: MIT */
/* What outcodes save (A10, D4, D5): a shape that crosses one plane and lies wholly outside another
 * is rejected before any intersection is computed, whichever of the two planes comes first. */
#include "clip_unit.h"
#include "polygon_face.h"
#include "clippers_list.h"
#include "study/half_space.h"

/* The lens: 90 degrees both ways, near 1, far 100, no inset. */
static fxl_lens square_lens(void)
{
    fxl_lens lens;
    TEST_ASSERT_EQUAL(FXL_OK, fxl_lens_from_fov(64, 64, DEGREES(90), Q16(1), Q16(100), 0, &lens));
    return lens;
}

/* The axis of a plane: 0 across, 1 up, 2 forward. */
static int axis_of(int plane)
{
    return plane <= FXL_PLANE_FAR ? 2 : plane <= FXL_PLANE_RIGHT ? 0 : 1;
}

/* Twice the place of a point on a plane's axis: inside the plane, or outside it. Of the side
 * planes it is a slope: 4 means twice the depth. */
static int place_of(int plane, bool outside)
{
    switch (plane) {
    case FXL_PLANE_NEAR:
        return outside ? 1 : 4;
    case FXL_PLANE_FAR:
        return outside ? 400 : 100;
    case FXL_PLANE_LEFT:
    case FXL_PLANE_BOTTOM:
        return outside ? -4 : 0;
    default:
        return outside ? 4 : 0;
    }
}

/* A flat convex quadrilateral: two vertices inside `crossed` and two outside, all outside
 * `beyond`. The planes have different axes. Along the third axis it is some size. */
static fxl_varying_polygon quadrilateral(int crossed, int beyond)
{
    static const int free_places[3][2] = {{-1, 1}, {-1, 1}, {20, 40}};
    const int across = axis_of(crossed), away = axis_of(beyond), along = 3 - across - away;
    fxl_varying_polygon polygon = clip_saw(4, 0);
    for (int i = 0; i < 4; i++) {
        int at[3];
        at[across] = place_of(crossed, i >= 2);
        at[away] = place_of(beyond, true);
        at[along] = free_places[along][i == 1 || i == 2];
        /* All coordinates are exact: the smallest is a quarter of a unit. */
        polygon.vertices[i].position =
            (fxl_view_point){V(at[0]) * at[2] / 4, V(at[1]) * at[2] / 4, V(at[2]) / 2};
    }
    return polygon;
}

typedef void visitor(const fxl_varying_polygon *polygon);

/* Visits a shape for each ordered pair of planes of different axes. */
static void visit_all(visitor *visit)
{
    int count = 0;
    for (int crossed = 0; crossed < FXL_PLANE_COUNT; crossed++) {
        for (int beyond = 0; beyond < FXL_PLANE_COUNT; beyond++) {
            if (axis_of(crossed) != axis_of(beyond)) {
                const fxl_varying_polygon polygon = quadrilateral(crossed, beyond);
                visit(&polygon);
                count++;
            }
        }
    }
    TEST_ASSERT_EQUAL(24, count);
}

/* The shapes are what they are said to be. */
static void check_shape(const fxl_varying_polygon *polygon)
{
    const fxl_lens lens = square_lens();
    fxl_volume volume;
    uint32_t any = 0, all = FXL_PLANES_ALL;
    clip_volume(&lens, FXL_PLANES_ALL, &volume);
    for (int i = 0; i < 4; i++) {
        const uint32_t code = fxl_volume_code(&volume, &polygon->vertices[i].position);
        any |= code;
        all &= code;
    }
    TEST_ASSERT_TRUE(all != 0 && (any & ~all) != 0);
}

void test_each_shape_crosses_one_plane_outside_another(void)
{
    visit_all(check_shape);
}

static void by_volume(const fxl_varying_polygon *polygon)
{
    static fxl_clip_workspace workspace;
    const fxl_lens lens = square_lens();
    const fxl_varying_polygon *result = polygon;
    fxl_volume volume;
    clip_volume(&lens, FXL_PLANES_ALL, &volume);
    workspace.stats = (fxl_clip_stats){0, 0, 0};
    TEST_ASSERT_EQUAL(FXL_CLIP_OUTSIDE, fxl_clip_to_volume(polygon, &volume, &workspace, &result));
    TEST_ASSERT_NULL(result);
    TEST_ASSERT_EQUAL_UINT32(0, workspace.stats.intersections);
    TEST_ASSERT_EQUAL_UINT32(4 * FXL_PLANE_COUNT, workspace.stats.distances); /* the outcodes */
}

void test_a_volume_rejects_by_codes(void)
{
    visit_all(by_volume);
}

static fxl_normalised normalised_frustum(void)
{
    const fxl_lens lens = square_lens();
    const fxl_pose pose = {{0, 0, 0}, 0, 0, 0};
    fxl_camera camera;
    fxl_normalised frustum;
    TEST_ASSERT_EQUAL(FXL_OK, fxl_camera_from_pose(&pose, &camera));
    fxl_normalised_from_camera(&camera, &lens, &frustum);
    return frustum;
}

/* Neither measures a distance by products: outcodes are compares there. */
static void by_normalised(const fxl_varying_polygon *polygon)
{
    static fxl_clip_workspace workspace;
    static fxl_clip_once_workspace once;
    const fxl_normalised frustum = normalised_frustum();
    const fxl_varying_polygon *result = polygon;
    workspace.stats = once.stats = (fxl_clip_stats){0, 0, 0};
    TEST_ASSERT_EQUAL(FXL_CLIP_OUTSIDE,
                      fxl_clip_normalised(polygon, &frustum, &workspace, &result));
    TEST_ASSERT_NULL(result);
    TEST_ASSERT_EQUAL_UINT32(0, workspace.stats.intersections);
    TEST_ASSERT_EQUAL_UINT32(0, workspace.stats.distances);
    result = polygon;
    TEST_ASSERT_EQUAL(FXL_CLIP_OUTSIDE, fxl_clip_once(polygon, &frustum, &once, &result));
    TEST_ASSERT_NULL(result);
    TEST_ASSERT_EQUAL_UINT32(0, once.stats.intersections);
    TEST_ASSERT_EQUAL_UINT32(0, once.stats.distances);
}

void test_the_normalised_frustum_rejects_by_codes(void)
{
    visit_all(by_normalised);
}

/* The edges that cross a plane, in either direction. By planes the same line is cut first where
 * the plane that it crosses comes first; by outcodes it never is. */
static uint32_t cut_by_planes;

static void by_line(const fxl_varying_polygon *polygon)
{
    const fxl_lens lens = square_lens();
    fxl_volume volume;
    clip_volume(&lens, FXL_PLANES_ALL, &volume);
    for (int i = 0; i < 2; i++) {
        fxl_clip_line line;
        uint32_t intersections = 0;
        memset(&line, 0, sizeof line);
        line.from = polygon->vertices[i == 0 ? 1 : 2];
        line.to = polygon->vertices[i == 0 ? 2 : 1];
        TEST_ASSERT_FALSE(fxl_line_by_codes(&line, &volume, &intersections));
        TEST_ASSERT_EQUAL_UINT32(0, intersections);
        TEST_ASSERT_FALSE(fxl_line_by_planes(&line, &volume, &cut_by_planes));
    }
}

void test_lines_are_rejected_by_codes(void)
{
    cut_by_planes = 0;
    visit_all(by_line);
    TEST_ASSERT_EQUAL_UINT32(24, cut_by_planes); /* of 48 lines, each half crosses first */
}

static void by_triangle(const fxl_varying_polygon *polygon)
{
    static fxl_triangle_workspace workspace;
    const fxl_lens lens = square_lens();
    const fxl_clip_triangle triangle = {
        {polygon->vertices[0], polygon->vertices[1], polygon->vertices[2]}};
    fxl_volume volume;
    fxl_status status;
    clip_volume(&lens, FXL_PLANES_ALL, &volume);
    memset(&workspace, 0, sizeof workspace);
    TEST_ASSERT_EQUAL(FXL_CLIP_OUTSIDE, fxl_triangle_begin(&triangle, 0, &volume, &workspace));
    TEST_ASSERT_NULL(fxl_triangle_next(&volume, &lens, &workspace, &status));
    TEST_ASSERT_EQUAL(FXL_OK, status);
    TEST_ASSERT_EQUAL_UINT32(0, workspace.stats.intersections);
    TEST_ASSERT_EQUAL_UINT32(3 * FXL_PLANE_COUNT, workspace.stats.distances);
}

void test_triangles_are_rejected_by_codes(void)
{
    visit_all(by_triangle);
}

/* Every clipper of a renderer but that of the world, which goes plane by plane. The camera stands
 * unturned at the origin, so a point of the view is a point of the world. */
static void by_face(const fxl_varying_polygon *polygon)
{
    static fxl_clipper_workspace workspace;
    static fxl_clipper_work work;
    static polygon_face face;
    const fxl_lens lens = square_lens();
    const fxl_pose pose = {{0, 0, 0}, 0, 0, 0};
    fxl_view view;
    fxl_screen_polygon screen;
    fxl_polygon in = {.colour = 1, .count = 4};
    for (int i = 0; i < 4; i++) {
        const fxl_view_point *at = &polygon->vertices[i].position;
        in.vertices[i].position =
            (fxl_point){(int32_t)(at->x >> 30), (int32_t)(at->y >> 30), (int32_t)(at->z >> 30)};
    }
    fxl_view_set_lens(&view, &lens);
    TEST_ASSERT_EQUAL(FXL_OK, fxl_view_set_pose(&view, &pose));
    for (int which = 0; which <= CLIPPERS; which++) {
        const fxl_clipper *clipper = which < CLIPPERS ? clippers[which] : &fxl_clipper_view;
        memset(&workspace, 0, sizeof workspace);
        polygon_face_set(&face, &in, &view, 4);
        face.model_view.clipper_workspace = &workspace;
        TEST_ASSERT_EQUAL(FXL_CLIP_OUTSIDE,
                          clipper->clip(&face.model_view, &face.face, &work, &screen));
        TEST_ASSERT_EQUAL_UINT32(0, workspace.stats.intersections);
        if (clipper == &fxl_clipper_view || clipper == &fxl_clipper_normalised ||
            clipper == &fxl_clipper_once) {
            TEST_ASSERT_EQUAL_UINT32(0, workspace.stats.distances);
        }
    }
}

void test_every_clipper_of_the_view_rejects_by_codes(void)
{
    visit_all(by_face);
}

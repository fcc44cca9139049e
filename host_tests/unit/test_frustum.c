/* SPDX-License-Identifier: MIT */
/* The planes of a view, and the outcodes of points and polygons about them. */
#include <math.h>

#include "unit.h"

static void make(const fxl_pose *pose, const fxl_lens *lens, fxl_camera *camera,
                 fxl_frustum *frustum)
{
    fxl_view_frustum sides;
    TEST_ASSERT_EQUAL(FXL_OK, fxl_camera_from_pose(pose, camera));
    fxl_view_frustum_from_lens(lens, &sides);
    fxl_frustum_from_sides(camera, lens, &sides, frustum);
}

/* SPEC 4.3a, 4.3c */
void test_four_sides_of_an_unturned_view(void)
{
    fxl_pose pose = {{0, 0, 0}, 0, 0, 0};
    fxl_lens lens = unit_lens(64, 64);
    fxl_camera camera;
    fxl_frustum frustum;
    make(&pose, &lens, &camera, &frustum);
    fxl_point middle = {0, 0, Q16(10)};
    const fxl_point outside[FXL_PLANE_COUNT] = {
        {0, 0, Q16(0.05)},      {0, 0, Q16(1001)},       {Q16(-11), 0, Q16(10)},
        {Q16(11), 0, Q16(10)},  {0, Q16(-11), Q16(10)},  {0, Q16(11), Q16(10)}};
    for (int outer = 0; outer < FXL_PLANE_COUNT; outer++) {
        for (int plane = 0; plane < FXL_PLANE_COUNT; plane++) {
            const fxl_plane *side = &frustum.planes[plane];
            TEST_ASSERT_TRUE(fxl_plane_distance(side, &middle) > 0);
            TEST_ASSERT_EQUAL(plane == outer, fxl_plane_distance(side, &outside[outer]) < 0);
        }
    }
}

/* The normal of a plane in the view, turned back into the world. */
static void expect_normal(const fxl_camera *camera, double x, double y, double z,
                          const fxl_plane *plane)
{
    double length = sqrt(x * x + y * y + z * z);
    x /= length;
    y /= length;
    z /= length;
    TEST_ASSERT_NEAR(plane->normal.x,
                     x * camera->axes.right.x + y * camera->axes.up.x + z * camera->axes.forward.x,
                     4.0);
    TEST_ASSERT_NEAR(plane->normal.y,
                     x * camera->axes.right.y + y * camera->axes.up.y + z * camera->axes.forward.y,
                     4.0);
    TEST_ASSERT_NEAR(plane->normal.z,
                     x * camera->axes.right.z + y * camera->axes.up.z + z * camera->axes.forward.z,
                     4.0);
}

/* SPEC 4.3e-h, 4.3m, accuracy 1.1i */
void test_normals_are_within_four_units(void)
{
    for (int i = 0; i < UNIT_REPEAT / 20; i++) {
        fxl_pose pose = unit_pose();
        fxl_lens lens = unit_any_lens();
        fxl_camera camera;
        fxl_frustum frustum;
        make(&pose, &lens, &camera, &frustum);
        double focal = lens.focal / 65536.0;
        expect_normal(&camera, focal, 0, lens.width / 2.0, &frustum.planes[FXL_PLANE_LEFT]);
        expect_normal(&camera, -focal, 0, lens.width / 2.0, &frustum.planes[FXL_PLANE_RIGHT]);
        expect_normal(&camera, 0, focal, lens.height / 2.0, &frustum.planes[FXL_PLANE_BOTTOM]);
        expect_normal(&camera, 0, -focal, lens.height / 2.0, &frustum.planes[FXL_PLANE_TOP]);
        expect_normal(&camera, 0, 0, 1, &frustum.planes[FXL_PLANE_NEAR]);
        expect_normal(&camera, 0, 0, -1, &frustum.planes[FXL_PLANE_FAR]);
    }
}

static void expect_within(int64_t bound, int64_t expected, int64_t actual)
{
    TEST_ASSERT_TRUE(actual - expected <= bound && expected - actual <= bound);
}

/* The eye lies outside each plane by as much as the plane was moved. near and
 * far may be off by their depth times the error of the normal's length, whose
 * components are off by up to 4 units of 2^-30 each. */
/* SPEC 4.3b, 4.3e-i */
void test_distances_from_the_eye(void)
{
    const int64_t unit = (int64_t)1 << 30;
    for (int i = 0; i < UNIT_REPEAT / 20; i++) {
        fxl_pose pose = unit_pose();
        fxl_lens lens = unit_any_lens();
        fxl_camera camera;
        fxl_frustum frustum;
        make(&pose, &lens, &camera, &frustum);
        for (int plane = FXL_PLANE_LEFT; plane <= FXL_PLANE_TOP; plane++) {
            int64_t at_eye = fxl_plane_distance(&frustum.planes[plane], &pose.position);
            expect_within(unit, -lens.inset * unit, at_eye);
        }
        int64_t near = fxl_plane_distance(&frustum.planes[FXL_PLANE_NEAR], &pose.position);
        int64_t far = fxl_plane_distance(&frustum.planes[FXL_PLANE_FAR], &pose.position);
        int64_t nearest = (int64_t)lens.near_z + lens.inset;
        int64_t farthest = (int64_t)lens.far_z - lens.inset;
        expect_within(unit + nearest * 7, -nearest * unit, near);
        expect_within(unit + farthest * 7, farthest * unit, far);
    }
}

/* Half a unit for rounding the quotient, and half a unit for the root. */
static void expect_unit_vector(double side, double depth, fxl_q2_30 unit_side, fxl_q2_30 unit_depth)
{
    double length = sqrt(side * side + depth * depth);
    TEST_ASSERT_NEAR(unit_side, side / length * FXL_Q2_30_ONE, 1.0);
    TEST_ASSERT_NEAR(unit_depth, depth / length * FXL_Q2_30_ONE, 1.0);
}

/* SPEC 4.3b, 4.3k, accuracy 1.1j */
void test_the_view_frustum_is_that_of_the_lens(void)
{
    const int64_t unit = (int64_t)1 << 30;
    for (int i = 0; i < UNIT_REPEAT / 20; i++) {
        fxl_lens lens = unit_any_lens();
        fxl_view_frustum frustum;
        fxl_view_frustum_from_lens(&lens, &frustum);
        expect_unit_vector(lens.focal, lens.width * 32768.0, frustum.x_side, frustum.x_depth);
        expect_unit_vector(lens.focal, lens.height * 32768.0, frustum.y_side, frustum.y_depth);
        TEST_ASSERT_EQUAL_INT64(((int64_t)lens.near_z + lens.inset) * unit, frustum.near_z);
        TEST_ASSERT_EQUAL_INT64(((int64_t)lens.far_z - lens.inset) * unit, frustum.far_z);
        TEST_ASSERT_EQUAL_INT64(lens.inset * unit, frustum.inset);
    }
}

void test_a_square_view_frustum(void)
{
    fxl_lens lens = unit_lens(64, 64);
    fxl_view_frustum frustum;
    fxl_view_frustum_from_lens(&lens, &frustum);
    /* 90 degrees: both components are 2^30 / sqrt 2 = 759250124.99. */
    TEST_ASSERT_INT32_WITHIN(1, 759250125, frustum.x_side);
    TEST_ASSERT_INT32_WITHIN(1, 759250125, frustum.x_depth);
    TEST_ASSERT_EQUAL_INT32(frustum.x_side, frustum.y_side);
    TEST_ASSERT_EQUAL_INT32(frustum.x_depth, frustum.y_depth);
}

static int64_t size_of(int64_t value)
{
    return value < 0 ? -value : value;
}

/* Both frustums say the same of a point of the world. near and far rest on the
 * same integers; a side plane was rounded once more when it was turned into the
 * world, by half a unit of 2^-30 a component of its normal. */
void test_the_view_frustum_is_the_one_in_the_world(void)
{
    for (int i = 0; i < UNIT_REPEAT / 4; i++) {
        fxl_pose pose = unit_pose();
        fxl_lens lens = unit_any_lens();
        fxl_point point = unit_point(i % 2 ? FXL_COORDINATE_MAX : Q16(40));
        fxl_camera camera;
        fxl_frustum world;
        fxl_view_frustum view;
        fxl_view_point seen;
        if (i % 2 == 0) {
            pose.position = unit_point(Q16(40));
        }
        make(&pose, &lens, &camera, &world);
        fxl_view_frustum_from_lens(&lens, &view);
        fxl_transform_point(&camera, &point, &seen);
        int64_t way = size_of((int64_t)point.x - pose.position.x) +
                      size_of((int64_t)point.y - pose.position.y) +
                      size_of((int64_t)point.z - pose.position.z);
        for (int plane = 0; plane < FXL_PLANE_COUNT; plane++) {
            bool depth = plane == FXL_PLANE_NEAR || plane == FXL_PLANE_FAR;
            int64_t bound = depth ? 0 : way / 2 + 2;
            expect_within(bound, fxl_plane_distance(&world.planes[plane], &point),
                          fxl_view_distance(&view, plane, &seen));
        }
    }
}

/* Outcodes against the distances that they stand for. */

#define LIMIT ((int64_t)1 << 61)

static fxl_planes planes_outside(const fxl_view_frustum *frustum, const fxl_view_point *point)
{
    unsigned outside = 0;
    for (int plane = 0; plane < FXL_PLANE_COUNT; plane++) {
        outside |= (unsigned)(fxl_view_distance(frustum, plane, point) < 0) << plane;
    }
    return (fxl_planes)outside;
}

static fxl_planes expect_outcode(const fxl_view_frustum *frustum, const fxl_view_point *point)
{
    fxl_planes outside = planes_outside(frustum, point);
    fxl_planes some = (fxl_planes)(unit_random() & FXL_PLANES_ALL);
    TEST_ASSERT_EQUAL_HEX8(outside, fxl_outcode(frustum, FXL_PLANES_ALL, point));
    TEST_ASSERT_EQUAL_HEX8(outside & some, fxl_outcode(frustum, some, point));
    return outside;
}

static fxl_view_frustum random_frustum(void)
{
    fxl_view_frustum frustum;
    fxl_lens lens = unit_any_lens();
    fxl_view_frustum_from_lens(&lens, &frustum);
    return frustum;
}

void test_each_plane_has_its_bit(void)
{
    fxl_view_frustum frustum;
    fxl_lens lens = unit_lens(64, 64); /* 90 degrees, near 1/16, far 1000 */
    fxl_view_frustum_from_lens(&lens, &frustum);
    static const struct {
        int x, y, z;
        unsigned outside;
    } points[] = {
        {0, 0, 10, 0},
        {-20, 0, 10, 1u << FXL_PLANE_LEFT},
        {20, 0, 10, 1u << FXL_PLANE_RIGHT},
        {0, -20, 10, 1u << FXL_PLANE_BOTTOM},
        {0, 20, 10, 1u << FXL_PLANE_TOP},
        {0, 0, 1001, 1u << FXL_PLANE_FAR},
        {20, -20, 10, 1u << FXL_PLANE_RIGHT | 1u << FXL_PLANE_BOTTOM},
        /* behind the eye, so beyond both of a pair */
        {0, 0, -10,
         1u << FXL_PLANE_NEAR | 1u << FXL_PLANE_LEFT | 1u << FXL_PLANE_RIGHT |
             1u << FXL_PLANE_BOTTOM | 1u << FXL_PLANE_TOP},
    };
    for (size_t i = 0; i < sizeof points / sizeof points[0]; i++) {
        const int64_t unit = (int64_t)1 << 46;
        fxl_view_point point = {points[i].x * unit, points[i].y * unit, points[i].z * unit};
        TEST_ASSERT_EQUAL_HEX8(points[i].outside, fxl_outcode(&frustum, FXL_PLANES_ALL, &point));
        expect_outcode(&frustum, &point);
    }
}

/* SPEC 4.7b-c, accuracy 1.1k */
void test_any_point(void)
{
    unsigned seen = 0;
    for (int i = 0; i < UNIT_REPEAT; i++) {
        fxl_view_frustum frustum = random_frustum();
        unsigned bits = (unsigned)unit_between(36, 61);
        for (int k = 0; k < 4; k++) {
            fxl_view_point point = {unit_wide(bits), unit_wide(bits), unit_wide(bits)};
            seen |= expect_outcode(&frustum, &point);
        }
    }
    TEST_ASSERT_EQUAL_HEX8(FXL_PLANES_ALL, seen);
}

/* Where a plane of this pair is, for a depth, to within 2^-20 of a unit or so. */
static int64_t side_at(fxl_q2_30 side, fxl_q2_30 depth, int64_t z, int64_t inset)
{
    double across =
        ((double)inset - (double)depth * (double)z / 1073741824.0) * 1073741824.0 / side;
    return across > -0x1p60 && across < 0x1p60 ? (int64_t)across : 0;
}

/* About the planes, by steps from one unit to beyond what the upper words tell. */
void test_points_beside_a_plane(void)
{
    int inside = 0, outside = 0;
    for (int i = 0; i < UNIT_REPEAT; i++) {
        fxl_view_frustum frustum = random_frustum();
        int64_t z = unit_wide((unsigned)unit_between(38, 59));
        int64_t x = side_at(frustum.x_side, frustum.x_depth, z, frustum.inset);
        int64_t y = side_at(frustum.y_side, frustum.y_depth, z, frustum.inset);
        fxl_view_point points[] = {{x, 0, z},  {-x, 0, z}, {0, y, z},
                                   {0, -y, z}, {x, y, z},  {x, y, frustum.near_z}};
        for (size_t k = 0; k < sizeof points / sizeof points[0]; k++) {
            fxl_view_point *point = &points[k];
            int64_t *moved = unit_random() % 3 == 0 ? &point->z : k < 2 ? &point->x : &point->y;
            *moved += unit_wide((unsigned)unit_between(1, 40));
            if (*moved<LIMIT && * moved> - LIMIT) {
                fxl_planes code = expect_outcode(&frustum, point);
                inside += code == 0;
                outside += code != 0;
            }
        }
        fxl_view_point ends[] = {{0, 0, frustum.near_z}, {0, 0, frustum.far_z}};
        for (int k = 0; k < 2; k++) {
            ends[k].z += unit_between(-1, 1);
            expect_outcode(&frustum, &ends[k]);
        }
    }
    TEST_ASSERT_TRUE(inside > UNIT_REPEAT / 4 && outside > UNIT_REPEAT / 4);
}

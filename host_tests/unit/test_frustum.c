/* SPDX-License-Identifier: MIT */
#include <math.h>

#include "unit.h"

static void make(const fxl_pose *pose, const fxl_lens *lens, fxl_camera *camera,
                 fxl_frustum *frustum)
{
    TEST_ASSERT_EQUAL(FXL_OK, fxl_camera_from_pose(pose, camera));
    fxl_frustum_from_camera(camera, lens, frustum);
}

static fxl_lens random_lens(void)
{
    fxl_lens lens;
    fxl_q16_16 near = unit_between(FXL_NEAR_MIN, Q16(100));
    fxl_angle fov = (fxl_angle)unit_between((int32_t)FXL_FOV_MIN, (int32_t)FXL_FOV_MAX);
    TEST_ASSERT_EQUAL(FXL_OK,
                      fxl_lens_from_fov((uint16_t)unit_between(1, FXL_SCREEN_MAX),
                                        (uint16_t)unit_between(1, FXL_SCREEN_MAX), fov, near,
                                        unit_between(Q16(200), FXL_FAR_MAX),
                                        unit_between(0, FXL_INSET_MAX), &lens));
    return lens;
}

void test_four_sides_of_an_unturned_view(void)
{
    fxl_pose pose = {{0, 0, 0}, 0, 0, 0};
    fxl_lens lens = unit_lens(64, 64);
    fxl_camera camera;
    fxl_frustum frustum;
    make(&pose, &lens, &camera, &frustum);
    fxl_point middle = {0, 0, Q16(10)};
    const fxl_point outside[FXL_PLANE_COUNT] = {{Q16(-11), 0, Q16(10)}, {Q16(11), 0, Q16(10)},
                                                {0, Q16(-11), Q16(10)}, {0, Q16(11), Q16(10)},
                                                {0, 0, Q16(0.05)},      {0, 0, Q16(1001)}};
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
                     x * camera->right.x + y * camera->up.x + z * camera->forward.x, 4.0);
    TEST_ASSERT_NEAR(plane->normal.y,
                     x * camera->right.y + y * camera->up.y + z * camera->forward.y, 4.0);
    TEST_ASSERT_NEAR(plane->normal.z,
                     x * camera->right.z + y * camera->up.z + z * camera->forward.z, 4.0);
}

void test_normals_are_within_four_units(void)
{
    for (int i = 0; i < UNIT_REPEAT / 20; i++) {
        fxl_pose pose = unit_pose();
        fxl_lens lens = random_lens();
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
void test_distances_from_the_eye(void)
{
    const int64_t unit = (int64_t)1 << 30;
    for (int i = 0; i < UNIT_REPEAT / 20; i++) {
        fxl_pose pose = unit_pose();
        fxl_lens lens = random_lens();
        fxl_camera camera;
        fxl_frustum frustum;
        make(&pose, &lens, &camera, &frustum);
        for (int plane = FXL_PLANE_LEFT; plane <= FXL_PLANE_TOP; plane++) {
            int64_t at_eye = fxl_plane_distance(&frustum.planes[plane], &pose.position);
            expect_within(unit, -lens.inset * unit, at_eye);
        }
        int64_t near = fxl_plane_distance(&frustum.planes[FXL_PLANE_NEAR], &pose.position);
        int64_t far = fxl_plane_distance(&frustum.planes[FXL_PLANE_FAR], &pose.position);
        int64_t nearest = (int64_t)lens.near + lens.inset;
        int64_t farthest = (int64_t)lens.far - lens.inset;
        expect_within(unit + nearest * 7, -nearest * unit, near);
        expect_within(unit + farthest * 7, farthest * unit, far);
    }
}

/* SPDX-License-Identifier: MIT */
/* The kernels that decide by an estimate, mostly where it hardly decides. */
#include "view/outcode.h"
#include "view/view.h"

#include "equality.h"
#include "sides.h"


static int32_t within(int32_t limit)
{
    return (int32_t)(any_32() % (2u * (uint32_t)limit + 1u)) - limit;
}

/* Mostly within the range of the estimates, 2^24. */
static int32_t coordinate(void)
{
    return (int32_t)any_32() >> (3 + (any_32() >> 9 & 15u));
}

/* Nearly normal to a direction: z nearly cancels the rest of the sum. */
void test_facing(uint32_t rounds)
{
    for (uint32_t i = 0; i < rounds; i++) {
        fxl_direction direction = {within(1 << 29), within(1 << 29), within(1 << 29)};
        fxl_point point = {coordinate(), coordinate(), coordinate()};
        int64_t rest = (int64_t)direction.x * point.x + (int64_t)direction.y * point.y;
        int64_t z = direction.z == 0 ? 0 : -rest / direction.z;
        if ((any_32() & 192u) != 0 && z > -(1 << 29) && z < 1 << 29) {
            point.z = (int32_t)z + (within(1 << 15) >> (any_32() >> 7 & 15u));
        }
        equality_case(core_dot_is_negative(&direction, &point) ==
                      portable_dot_is_negative(&direction, &point));
    }
}

/* The axis times length / 2^30, added to a point. */
static void add(const fxl_direction *axis, int64_t length, fxl_point *point)
{
    point->x += (int32_t)(axis->x * length >> 30);
    point->y += (int32_t)(axis->y * length >> 30);
    point->z += (int32_t)(axis->z * length >> 30);
}

/* The centre of a sphere that nearly touches a side plane from within or from without. */
static void touch_plane(const fxl_view *view, fxl_q16_16 radius, fxl_point *centre)
{
    const fxl_axes *axes = &view->camera.axes;
    const fxl_view_frustum *frustum = &view->view_frustum;
    const bool upright = (any_32() & 64u) != 0;
    int64_t side = upright ? frustum->y_side : frustum->x_side;
    int64_t depth = upright ? frustum->y_depth : frustum->x_depth;
    int64_t along = any_32() >> 9;
    int64_t inward = ((any_32() & 64u) != 0 ? radius : -radius) + within(1 << 12);
    int64_t across = (along * depth - inward * side) >> 30;
    *centre = view->camera.position;
    add(&axes->forward, (along * side + inward * depth) >> 30, centre);
    add(upright ? &axes->up : &axes->right, (any_32() & 64u) != 0 ? across : -across, centre);
}

/* The view of a camera, and spheres near it. */
void test_sphere(uint32_t rounds)
{
    static fxl_view view;
    for (uint32_t i = 0; i < rounds; i++) {
        if (i % 16 == 0) {
            fxl_pose pose = {{within(1 << 26), 0, within(1 << 20)}, any_32(), any_32(), any_32()};
            fxl_lens lens;
            fxl_angle fov = FXL_FOV_MIN + any_32() % (FXL_FOV_MAX - FXL_FOV_MIN + 1u);
            fxl_lens_from_fov(320, 240, fov, FXL_NEAR_MIN << (any_32() >> 9 & 7u),
                              FXL_FAR_MAX >> (any_32() >> 9 & 7u), 4, &lens);
            any_centre(&lens);
            fxl_view_set_lens(&view, &lens);
            fxl_view_set_pose(&view, &pose);
        }
        const fxl_point *eye = &view.camera.position;
        fxl_point centre = {eye->x + coordinate() / 4, coordinate() / 4, eye->z + coordinate() / 4};
        fxl_q16_16 radius = (fxl_q16_16)(any_32() >> (6 + (any_32() >> 7 & 15u)));
        if ((any_32() & 192u) != 0) {
            touch_plane(&view, radius >> 7, &centre);
        }
        equality_case(
            fxl_sphere_planes(&view.camera, &view.view_frustum, &centre, radius >> 7) ==
            portable_sphere_planes(&view.camera, &view.view_frustum, &centre, radius >> 7));
    }
}

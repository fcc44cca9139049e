/* SPDX-License-Identifier: MIT */
#include "clip_views.h"

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

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

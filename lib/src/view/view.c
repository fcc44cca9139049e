/* SPDX-License-Identifier: MIT */
#include "fixel/stage/view.h"

void fxl_view_set_lens(fxl_view *view, const fxl_lens *lens)
{
    view->lens = *lens;
    view->frame = 0;
    fxl_view_frustum_from_lens(lens, &view->view_frustum);
    fxl_projection_from_lens(lens, &view->projection);
}

fxl_status fxl_view_set_pose(fxl_view *view, const fxl_pose *pose)
{
    fxl_status status = fxl_camera_from_pose(pose, &view->camera);
    if (status == FXL_OK) {
        view->frame += 1;
        view->frame += view->frame == 0;
    }
    return status;
}

void fxl_view_set_world_frustum(fxl_view *view)
{
    fxl_frustum_from_camera(&view->camera, &view->lens, &view->frustum);
}

/* SPDX-License-Identifier: MIT */
#include "../scene/lens.h"
#include "project.h"
#include "view.h"

void fxl_view_set_lens(fxl_view *view, const fxl_lens *lens)
{
    view->lens = *lens;
    view->frame = 0;
    fxl_view_frustum_from_lens(lens, &view->view_frustum);
    fxl_projection_from_lens(lens, &view->projection);
    if (lens->off_centre != NULL) {
        lens->off_centre->set_lens(view);
    }
}

fxl_lens fxl_view_drawn_lens(const fxl_view *view)
{
    fxl_lens lens = view->lens;
    lens.focal = fxl_view_drawn_focal(view);
    lens.centre_x = view->projection.centre_x;
    lens.centre_y = view->projection.centre_y;
    lens.off_centre = NULL;
    return lens;
}

fxl_status fxl_view_set_pose(fxl_view *view, const fxl_pose *pose)
{
    fxl_status status = fxl_camera_from_pose(pose, &view->camera);
    if (status != FXL_OK) {
        return status;
    }
    view->frame += 1;
    view->frame += view->frame == 0;
    if (view->lens.off_centre != NULL) {
        view->lens.off_centre->set_pose(view);
    }
    return FXL_OK;
}

void fxl_view_set_world_frustum(fxl_view *view)
{
    fxl_frustum_from_sides(&view->camera, &view->lens, &view->view_frustum, &view->frustum);
}

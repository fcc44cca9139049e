/* SPDX-License-Identifier: MIT */
#include "oracle/space.h"
#include "study/normalised.h"

static void set_screen(const fxl_lens *lens, oracle_space *space)
{
    space->centre_x = (int64_t)lens->width << 15;
    space->centre_y = (int64_t)lens->height << 15;
}

oracle_space oracle_space_of_view(const fxl_view *view)
{
    const fxl_view_frustum *f = &view->view_frustum;
    oracle_space space = {.camera = view->camera,
                          .planes = {[FXL_PLANE_NEAR] = {0, 0, 1, -f->near_z, 0},
                                     [FXL_PLANE_FAR] = {0, 0, -1, f->far_z, 0},
                                     [FXL_PLANE_LEFT] = {f->x_side, 0, f->x_depth, -f->inset, 30},
                                     [FXL_PLANE_RIGHT] = {-f->x_side, 0, f->x_depth, -f->inset, 30},
                                     [FXL_PLANE_BOTTOM] = {0, f->y_side, f->y_depth, -f->inset, 30},
                                     [FXL_PLANE_TOP] = {0, -f->y_side, f->y_depth, -f->inset, 30}},
                          .x_scale = view->lens.focal,
                          .y_scale = view->lens.focal};
    set_screen(&view->lens, &space);
    return space;
}

oracle_space oracle_space_of_normalised(const fxl_view *view)
{
    fxl_normalised f;
    fxl_normalised_from_camera(&view->camera, &view->lens, &f);
    oracle_space space = {.camera = {f.eye, {f.x.direction, f.y.direction, f.z.direction}},
                          .x_shift = f.x.shift,
                          .y_shift = f.y.shift,
                          .z_shift = f.z.shift,
                          .planes = {[FXL_PLANE_NEAR] = {0, 0, 1, -f.near_z, 0},
                                     [FXL_PLANE_FAR] = {0, 0, -1, f.far_z, 0},
                                     [FXL_PLANE_LEFT] = {1, 0, 1, -f.x_inset, 0},
                                     [FXL_PLANE_RIGHT] = {-1, 0, 1, -f.x_inset, 0},
                                     [FXL_PLANE_BOTTOM] = {0, 1, 1, -f.y_inset, 0},
                                     [FXL_PLANE_TOP] = {0, -1, 1, -f.y_inset, 0}},
                          .x_scale = (int64_t)view->lens.width << 15,
                          .y_scale = (int64_t)view->lens.height << 15};
    set_screen(&view->lens, &space);
    return space;
}

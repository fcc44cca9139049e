/* SPDX-License-Identifier: MIT */
#include "clip_by_view.h"

#if !FXL_KERNELS_ARMV7M

fxl_clip_result fxl_clip_by_view(const fxl_model_view *model_view, const fxl_face *face,
                                 fxl_clipper_work *work, fxl_screen_polygon *screen)
{
    return fxl_clip_by(model_view, face, work, screen, fxl_project_inside, fxl_clip_assembled);
}

#endif

fxl_clip_result fxl_clip_assembled(const fxl_model_view *model_view, const fxl_face *face,
                                   fxl_clipper_work *workspace, fxl_screen_polygon *screen)
{
    return fxl_clip_assembled_by(model_view, face, workspace, screen, fxl_project_inside);
}

const fxl_clipper fxl_clipper_view = {.clip = fxl_clip_by_view, .by_clip_flags = true};

/* SPDX-License-Identifier: MIT */
#include "../view/project.h"
#include "clip_by_view.h"

/* fxl_projector */
static inline fxl_status project(const fxl_view *view, const fxl_view_point *point,
                                 fxl_screen_point *screen)
{
    return fxl_project_inside(&view->projection, point, screen);
}

#if !FXL_KERNELS_ARMV7M

fxl_clip_result fxl_clip_by_view(const fxl_model_view *model_view, const fxl_face *face,
                                 fxl_clipper_work *work, fxl_screen_polygon *screen)
{
    return fxl_clip_by(model_view, face, work, screen, project, fxl_clip_assembled);
}

#endif

/* fxl_corner_taker */
static inline uint32_t take(const fxl_model_view *model_view, uint32_t number,
                            const fxl_cached_vertex *vertex, fxl_view_point *place)
{
    (void)model_view;
    (void)number;
    fxl_copy_point(&vertex->position, place);
    return vertex->clip_flags;
}

fxl_clip_result fxl_clip_assembled(const fxl_model_view *model_view, const fxl_face *face,
                                   fxl_clipper_work *work, fxl_screen_polygon *screen)
{
    return fxl_clip_assembled_by(model_view, face, work, screen, take, project);
}

const fxl_clipper fxl_clipper_view = {.clip = fxl_clip_by_view, .by_clip_flags = true};

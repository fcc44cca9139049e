/* SPDX-License-Identifier: MIT */
#include "../view/project.h"
#include "clip_by_view.h"

#if !FXL_KERNELS_ARMV7M

/* fxl_projector */
static inline fxl_status project(const fxl_view *view, const fxl_view_point *point,
                                 fxl_screen_point *screen)
{
    return fxl_project_inside(&view->projection, point, screen);
}

fxl_clip_result fxl_clip_by_view(const fxl_model_view *model_view, const fxl_face *face,
                                 fxl_clipper_work *work, fxl_screen_polygon *screen)
{
    return fxl_clip_by(model_view, face, work, screen, project, fxl_clip_assembled);
}

#endif

fxl_clip_result fxl_clip_assembled(const fxl_model_view *model_view, const fxl_face *face,
                                   fxl_clipper_work *workspace, fxl_screen_polygon *screen)
{
    fxl_clip_view_work *work = &workspace->by_view;
    const uint16_t *indices = fxl_face_indices(model_view->indices, face);
    const fxl_view *view = model_view->view;
    fxl_view_polygon *assembled = &work->polygons[0];
    const fxl_view_polygon *clipped;
    unsigned of_any = 0;
    for (uint32_t i = 0; i < face->count; i++) {
        const fxl_cached_vertex *vertex = fxl_fetch_vertex(model_view, indices[i]);
        of_any |= vertex->clip_flags;
        fxl_copy_point(&vertex->position, &assembled->vertices[i].position);
    }
    assembled->colour = face->material;
    assembled->count = face->count;
    fxl_clip_result result = fxl_clip_view_by_planes(
        assembled, &view->view_frustum, (fxl_planes)(of_any & FXL_PLANES_ALL), work,
        (fxl_clip_stats *)model_view->clipper_workspace, &clipped);
    if (clipped == NULL) {
        return result;
    }
    screen->colour = clipped->colour;
    screen->count = clipped->count;
    for (uint32_t i = 0; i < clipped->count; i++) {
        fxl_screen_point *point = &screen->points[i];
        if (fxl_project_inside(&view->projection, &clipped->vertices[i].position, point) !=
            FXL_OK) {
            return FXL_CLIP_RANGE;
        }
    }
    return result;
}

const fxl_clipper fxl_clipper_view = {.clip = fxl_clip_by_view, .by_clip_flags = true};

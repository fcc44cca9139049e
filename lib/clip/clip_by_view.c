/* SPDX-License-Identifier: MIT */
#include "../math/family.h"
#include "../view/model_view.h"
#include "../view/outcode.h"
#include "../view/project.h"
#include "clip_by_view.h"

#if !FXL_KERNELS_ARMV7M

/* Whether all vertices of a face are outside of the same plane. */
static bool is_outside(const fxl_model_view *model_view, const fxl_face *face)
{
    const uint16_t *index = model_view->indices + face->first_index;
    uint32_t of_all = FXL_PLANES_ALL;
    for (const uint16_t *end = index + face->count; index < end && of_all != 0; index++) {
        of_all &= fxl_fetch_vertex(model_view, *index)->clip_flags;
    }
    return of_all != 0;
}

/* Usually all vertices are inside. Then their places on the screen are the result. */
fxl_clip_result fxl_clip_by_view(const fxl_model_view *model_view, const fxl_face *face,
                                 fxl_clipper_work *work, fxl_screen_polygon *screen)
{
    const uint16_t *index = model_view->indices + face->first_index;
    fxl_screen_point *point = screen->points;
    uint32_t of_any = 0, of_all = UINT32_MAX;
    for (const uint16_t *end = index + face->count; index < end; index++, point++) {
        fxl_cached_vertex *vertex = fxl_fetch_vertex(model_view, *index);
        uint32_t state = vertex->clip_flags;
        if ((state & FXL_VERTEX_OUTSIDE) != 0) {
            if (state != FXL_VERTEX_UNPROJECTED) {
                /* If no vertex was inside before. */
                return of_all == UINT32_MAX && is_outside(model_view, face)
                           ? FXL_CLIP_OUTSIDE
                           : fxl_clip_assembled(model_view, face, work, screen);
            }
            if (fxl_project_inside(&model_view->view->projection, &vertex->position,
                                   &vertex->screen) != FXL_OK) {
                return FXL_CLIP_RANGE;
            }
            state = fxl_vertex_place_flags(&vertex->screen);
            vertex->clip_flags = state;
        }
        of_any |= state;
        of_all &= state;
        *point = vertex->screen;
    }
    screen->colour = face->material;
    screen->count = face->count;
    uint32_t differing = of_any ^ of_all;
    return (differing & FXL_VERTEX_COLUMN) == 0 || (differing & FXL_VERTEX_ROW) == 0
               ? FXL_CLIP_BETWEEN
               : FXL_CLIP_INSIDE;
}

#endif

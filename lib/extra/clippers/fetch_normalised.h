/* SPDX-License-Identifier: MIT */
/* Fetches vertices, transformed into the normalised frustum, through the vertex cache. Internal. */
#ifndef FXL_FETCH_NORMALISED_H
#define FXL_FETCH_NORMALISED_H

#include "clip_common.h"

static inline fxl_cached_vertex *fxl_fetch_normalised(const fxl_model_view *model_view,
                                                      uint32_t number,
                                                      const fxl_normalised *frustum)
{
    bool is_new;
    fxl_cached_vertex *entry = fxl_clip_common_entry(model_view, number, &is_new);
    if (is_new) {
        fxl_point from_eye = fxl_model_view_vertex(model_view, number);
        fxl_normalised_from_eye(frustum, &from_eye, &entry->position);
        entry->clip_flags =
            (uint8_t)((fxl_normalised_code(frustum, &entry->position) & model_view->planes) |
                      FXL_VERTEX_UNPROJECTED);
    }
    return entry;
}

/* Makes the planes of a frame, when the first face of the frame needs them. */
static inline void fxl_normalised_set_up(const fxl_view *view, uint32_t *frame,
                                         fxl_normalised *frustum)
{
    if (*frame != view->frame) { /* bug: normalised-stale */
        fxl_normalised_from_camera(&view->camera, &view->lens, frustum);
        *frame = view->frame;
    }
}

#endif

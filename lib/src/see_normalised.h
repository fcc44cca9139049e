/* SPDX-License-Identifier: MIT */
/* Vertices of the normalised frustum in the cache. Internal. */
#ifndef FXL_SEE_NORMALISED_H
#define FXL_SEE_NORMALISED_H

#include "family.h"

static inline fxl_seen_vertex *fxl_see_normalised(const fxl_placed *placed, uint32_t number,
                                                  const fxl_normalised *frustum)
{
    bool is_new;
    fxl_seen_vertex *entry = fxl_family_entry(placed, number, &is_new);
    if (is_new) {
        fxl_point from_eye = fxl_placed_vertex(placed, number);
        fxl_normalised_from_eye(frustum, &from_eye, &entry->position);
        entry->state = (uint8_t)((fxl_normalised_code(frustum, &entry->position) & placed->planes) |
                                 FXL_SEEN_UNPROJECTED);
    }
    return entry;
}

/* The planes of a frame when a face first asks for them. */
static inline void fxl_normalised_set_up(const fxl_view *view, uint32_t *frame,
                                         fxl_normalised *frustum)
{
    if (*frame != view->frame) { /* bug: normalised-stale */
        fxl_normalised_from_camera(&view->camera, &view->lens, frustum);
        *frame = view->frame;
    }
}

#endif

/* SPDX-License-Identifier: MIT */
#include "fixel/placed.h"

#include "outside.h"
#include "rotate.h"

void fxl_look_at(const fxl_placed *placed, uint32_t number, fxl_seen_vertex *entry)
{
    const fxl_view *view = placed->view;
    fxl_point from_eye = fxl_placed_vertex(placed, number);
    fxl_view_point seen;
    fxl_rotate(&view->camera, &from_eye, &seen);
    entry->position = seen;
    entry->tag = placed->tag + number;
    unsigned outside = 0;
    if (placed->planes != 0) {
        outside = FXL_IS_SMALL ? fxl_outcode(&view->view_frustum, placed->planes, &entry->position)
                               : fxl_outside(&view->view_frustum, placed->planes, &entry->position);
    }
    entry->state = outside | FXL_SEEN_UNPROJECTED;
}

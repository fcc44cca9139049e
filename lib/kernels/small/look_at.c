/* SPDX-License-Identifier: MIT */
#include "fixel/placed.h"

#include "arith.h"
#include "fixel/clip_view.h"
#include "rotate.h"

/* Three exact sums, below 2^61 (fxl_dot). */
void fxl_rotate(const fxl_camera *camera, const fxl_point *point, fxl_view_point *view)
{
    view->x = fxl_dot(&camera->right, point->x, point->y, point->z);
    view->y = fxl_dot(&camera->up, point->x, point->y, point->z);
    view->z = fxl_dot(&camera->forward, point->x, point->y, point->z);
}

/* Every plane is asked by its exact distance. */
void fxl_look_at(const fxl_placed *placed, uint32_t number, fxl_seen_vertex *entry)
{
    fxl_point from_eye = fxl_placed_vertex(placed, number);
    fxl_rotate(&placed->view->camera, &from_eye, &entry->position);
    entry->tag = placed->tag + number;
    entry->state =
        (uint8_t)(fxl_outcode(&placed->view->view_frustum, placed->planes, &entry->position) |
                  FXL_SEEN_UNPROJECTED);
}

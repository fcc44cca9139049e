/* SPDX-License-Identifier: MIT */
#include "project_any.h"

/* The long way alone. */
fxl_status fxl_project_inside(const fxl_projection *projection, const fxl_view_point *view,
                              fxl_screen_point *screen)
{
    return fxl_project_any(projection, view, screen);
}

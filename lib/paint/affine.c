/* SPDX-License-Identifier: MIT */
#include "../view/project.h"
#include "../view/view.h"
#include "affine.h"

#include "../math/arith.h"

/* Differences are at most 2^26, so products are at most 2^52. */
static bool on_one_line(const fxl_screen_point points[3])
{
    const int64_t x1 = points[1].x - points[0].x, y1 = points[1].y - points[0].y;
    const int64_t x2 = points[2].x - points[0].x, y2 = points[2].y - points[0].y;
    return x1 * y2 == x2 * y1;
}

void fxl_corners_make_affine(fxl_gradient_corners *face, const fxl_view *view)
{
    const fxl_projection *projection = &view->projection;
    fxl_screen_point points[3];
    for (uint32_t i = 0; i < 3; i++) {
        if (fxl_project_visible(projection, &face->corners[i], &points[i]) != FXL_OK ||
            points[i].x < 0 || points[i].x > (int32_t)view->lens.width * 65536 || points[i].y < 0 ||
            points[i].y > (int32_t)view->lens.height * 65536) {
            return;
        }
    }
    if (on_one_line(points)) {
        return;
    }
    for (uint32_t i = 0; i < 3; i++) {
        face->corners[i].x = points[i].x - projection->centre_x;
        face->corners[i].y = projection->centre_y - points[i].y;
        face->corners[i].z = fxl_view_drawn_focal(view);
    }
}

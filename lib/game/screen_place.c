/* SPDX-License-Identifier: MIT */
/* Where a point of the world is on the screen. */
#include "../math/arith.h"
#include "../view/model_view.h"
#include "../scene/lens.h"
#include "../view/project.h"
#include "fixel/pick.h"

/* Whether a projected point lies on the screen: 0 <= x < width, 0 <= y < height. */
/* pick 1.3 */
static bool is_on_screen(const fxl_lens *lens, const fxl_screen_point *at)
{
    return at->x >= 0 && at->x < lens->width * 65536 && at->y >= 0 && at->y < lens->height * 65536;
}

/* orthographic 2.7 */
static fxl_status project(const fxl_view *view, const fxl_view_point *position, fxl_screen_point *at)
{
    const fxl_orthographic_code *code = fxl_orthographic_of(&view->lens);
    return code != NULL ? code->project(view, position, at)
                        : fxl_project_visible(&view->projection, position, at);
}

/* pick 1.1, 1.2 */
fxl_status fxl_find_on_screen(const fxl_view *view, const fxl_point *point, fxl_screen_place *place)
{
    if (view == NULL || point == NULL || place == NULL) {
        return FXL_E_ARGUMENT;
    }
    if (view->frame == 0) {
        return FXL_E_ORDER;
    }
    if (!fxl_point_in_range(point)) {
        return FXL_E_RANGE;
    }
    fxl_view_point position;
    fxl_screen_place found = {{0, 0}, 0, FXL_POINT_NEAR};
    fxl_transform_point(&view->camera, point, &position);
    found.depth = position.z;
    if (position.z >= view->view_frustum.near_z) {
        if (project(view, &position, &found.at) != FXL_OK) {
            found.place = FXL_POINT_BEYOND;
        } else if (position.z <= view->view_frustum.far_z && is_on_screen(&view->lens, &found.at)) {
            found.place = FXL_POINT_VISIBLE;
        } else {
            found.place = FXL_POINT_OFF_SCREEN;
        }
    }
    *place = found;
    return FXL_OK;
}

/* SPDX-License-Identifier: MIT */
/* The faces come near to far, and a target of its own answers that it has no room for the
 * first that covers the pixel. So the traversal stops there, and its resume point is that face.
 * The shaders of surfaces and of depth leave the faces flat, since the target is not theirs. */
#include "../draw/renderer.h"
#include "../draw/submit.h"
#include "../math/arith.h"
#include "../raster/scan.h"
#include "../view/model_view.h"
#include "../view/project.h"
#include "fixel/pick.h"

/* A band of one row, in which one pixel counts. `band` comes first, so a pointer to it is one to
 * this record. Its pixels are one byte, for the colour of that pixel. */
typedef struct {
    fxl_band band;
    int32_t column;
} pixel_probe;

/* fxl_target.flat: false where the polygon covers the pixel. */
static bool probe(fxl_workspace *workspace, const fxl_screen_point *points, uint32_t count,
                  uint8_t colour, const fxl_band *band)
{
    const pixel_probe *pixel = (const pixel_probe *)(const void *)band;
    fxl_scan *scan = &workspace->work.scan;
    fxl_span span;
    fxl_scan_outline(points, count, band, scan);
    while (fxl_scan_next(scan, &span)) {
        if (pixel->column >= span.x0 && pixel->column < span.x1) {
            *band->pixels = colour;
            return false;
        }
    }
    return true;
}

static const fxl_target probe_target = {.pixel_bits = 8, .flat = probe};

/* The face at a resume point of a traversal near to far. */
static void name_face(const fxl_renderer *renderer, const fxl_resume_point *at, fxl_picked *picked)
{
    const fxl_frame *frame = &renderer->frame;
    const fxl_scene *scene = renderer->scene;
    const fxl_workspace *workspace = &renderer->workspace;
    picked->instance = frame->order[frame->visible_count - 1 - at->instances].index;
    const fxl_model *model = &scene->models[scene->instances[picked->instance].model];
    uint32_t face = model->face_count - 1 - at->faces;
    if (model->kind == FXL_MODEL_SORTED) {
        face = workspace->face_order[workspace->sorted_count - 1 - at->faces].face;
    }
    picked->face = (uint16_t)face;
}

/* The workspace knows the order of no model's faces: it numbers instances by the direction of the
 * traversal, which is turned round for a pick. */
static void forget_faces(fxl_workspace *workspace)
{
    workspace->sorted_instance = UINT16_MAX;
    workspace->face_rows_known = false;
}

static void pick(fxl_renderer *renderer, uint16_t x, uint16_t y, fxl_picked *picked)
{
    const fxl_target *target = renderer->target;
    const bool near_first = renderer->near_first;
    fxl_picked found = {FXL_PICK_NONE, 0, 0};
    uint8_t colour = 0;
    const uint16_t width = renderer->frame.view.lens.width;
    const pixel_probe pixel = {{&colour, width, width, y, 1, NULL}, x};
    fxl_resume_point resume = {0, 0};
    fxl_counters uncounted = {0};
    const fxl_traversal on = {.renderer = renderer,
                              .clipper = renderer->clipper,
                              .workspace = &renderer->workspace,
                              .display_list = NULL,
                              .band = &pixel.band,
                              .resume = &resume,
                              .counters = &uncounted,
                              .way = FXL_SUBMIT_ANY};
    const uint8_t state = renderer->frame.state;
    forget_faces(&renderer->workspace);
    renderer->target = &probe_target;
    renderer->near_first = true;
    renderer->frame.state = FXL_FRAME_BEGUN; /* rows are known of what is not in the list alone */
    if (!renderer->order->submit(&on)) {
        name_face(renderer, &resume, &found);
        found.colour = colour;
    }
    renderer->target = target;
    renderer->near_first = near_first;
    renderer->frame.state = state;
    forget_faces(&renderer->workspace);
    *picked = found;
}

fxl_status fxl_pick_face(fxl_renderer *renderer, uint16_t x, uint16_t y, fxl_picked *picked)
{
    if (renderer == NULL) {
        return FXL_E_ARGUMENT;
    }
    fxl_workspace *workspace = &renderer->workspace;
    if (picked == NULL) {
        return fxl_refuse(workspace, FXL_E_ARGUMENT);
    }
    if (renderer->frame.state == FXL_FRAME_NONE || renderer->frame.state == FXL_FRAME_RELEASED) {
        return fxl_refuse(workspace, FXL_E_ORDER);
    }
    if (renderer->order != &fxl_by_distance) {
        return fxl_refuse(workspace, FXL_E_BSP);
    }
    const fxl_lens *lens = &renderer->frame.view.lens;
    if (x >= lens->width || y >= lens->height) {
        return fxl_refuse(workspace, FXL_E_RANGE);
    }
    pick(renderer, x, y, picked);
    return FXL_OK;
}

/* Whether a projected point lies on the screen: 0 <= x < width, 0 <= y < height. */
static bool is_on_screen(const fxl_lens *lens, const fxl_screen_point *at)
{
    return at->x >= 0 && at->x < lens->width * 65536 && at->y >= 0 && at->y < lens->height * 65536;
}

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
        if (fxl_project_visible(&view->projection, &position, &found.at) != FXL_OK) {
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

/* SPDX-License-Identifier: MIT */
#include "fixel/render.h"

#include <string.h>

#include "fixel/cull.h"
#include "fixel/fill.h"
#include "fixel/project.h"

/* scan -> fill. False where scan refused the polygon. */
static bool paint(fxl_renderer *renderer, const fxl_band *band)
{
    const fxl_trapezoid *trapezoid;
    if (fxl_scan_begin(&renderer->screen, band, &renderer->scan) != FXL_OK) {
        return false;
    }
    while ((trapezoid = fxl_scan_next_trapezoid(&renderer->scan)) != NULL) {
        fxl_fill_trapezoid(band, trapezoid, renderer->screen.colour);
    }
    return true;
}

/* clip (and transform) -> project -> scan -> fill, for a face that faces the eye. */
static void draw_face(fxl_renderer *renderer, const fxl_object *object, const fxl_face *face,
                      const fxl_band *band, fxl_counters *counters)
{
    const fxl_view_polygon *clipped;
    fxl_face_to_polygon(renderer->scene, object, face, &renderer->polygon);
    fxl_clip_result cut =
        renderer->clipper(&renderer->polygon, &renderer->view, &renderer->work, &clipped);
    switch (cut) {
    case FXL_CLIP_OUTSIDE:
        counters->outside += 1;
        return;
    case FXL_CLIP_DEGENERATE:
        counters->degenerate += 1;
        return;
    case FXL_CLIP_CAPACITY:
        counters->refused += 1;
        return;
    case FXL_CLIP_INSIDE:
    case FXL_CLIP_CUT:
        break;
    }
    if (fxl_project_polygon(&renderer->view.lens, clipped, &renderer->screen) != FXL_OK ||
        !paint(renderer, band)) {
        counters->refused += 1;
        return;
    }
    counters->drawn += 1;
    counters->clipped += cut == FXL_CLIP_CUT;
}

/* A convex object: its faces hide none of each other, so any order will do. */
static void draw_convex(fxl_renderer *renderer, const fxl_object *object, const fxl_model *model,
                        const fxl_band *band, fxl_counters *counters)
{
    for (uint32_t i = 0; i < model->face_count; i++) {
        const fxl_face *face = &renderer->scene->faces[model->first_face + i];
        if (fxl_face_is_front(renderer->scene, object, face, &renderer->view.camera.position)) {
            draw_face(renderer, object, face, band, counters);
        } else {
            counters->backfacing += 1;
        }
    }
}

static void draw_sorted(fxl_renderer *renderer, const fxl_object *object, const fxl_model *model,
                        const fxl_band *band, fxl_counters *counters)
{
    fxl_order_entry *order = renderer->order + renderer->scene->object_count;
    uint32_t count =
        fxl_order_faces(renderer->scene, object, &renderer->view.camera.position, order);
    counters->backfacing += model->face_count - count;
    for (uint32_t i = 0; i < count; i++) {
        const fxl_face *face = &renderer->scene->faces[model->first_face + order[i].index];
        draw_face(renderer, object, face, band, counters);
    }
}

static fxl_status refuse(fxl_renderer *renderer, fxl_status status)
{
    renderer->counters.refused_calls += 1;
    return status;
}

fxl_status fxl_renderer_init(fxl_renderer *renderer, const fxl_scene *scene, const fxl_lens *lens,
                             fxl_order_entry *order, uint32_t order_capacity)
{
    if (renderer == NULL || scene == NULL || lens == NULL || order == NULL) {
        return FXL_E_ARGUMENT;
    }
    if (order_capacity < scene->order_needed) {
        return FXL_E_CAPACITY;
    }
    renderer->scene = scene;
    renderer->view.lens = *lens;
    renderer->clipper = fxl_clip_by_view;
    renderer->order = order;
    renderer->ready = false;
    memset(&renderer->counters, 0, sizeof renderer->counters);
    return FXL_OK;
}

fxl_status fxl_frame_begin(fxl_renderer *renderer, const fxl_pose *pose)
{
    if (renderer == NULL) {
        return FXL_E_ARGUMENT;
    }
    fxl_status status = fxl_camera_from_pose(pose, &renderer->view.camera);
    if (status != FXL_OK) {
        return refuse(renderer, status);
    }
    fxl_frustum_from_camera(&renderer->view.camera, &renderer->view.lens, &renderer->view.frustum);
    fxl_view_frustum_from_lens(&renderer->view.lens, &renderer->view.view_frustum);
    fxl_order_objects(renderer->scene, &renderer->view.camera.position, renderer->order);
    uint32_t refused_calls = renderer->counters.refused_calls;
    memset(&renderer->counters, 0, sizeof renderer->counters);
    renderer->counters.refused_calls = refused_calls;
    renderer->ready = true;
    return FXL_OK;
}

fxl_status fxl_frame_draw(fxl_renderer *renderer, const fxl_band *band)
{
    if (renderer == NULL) {
        return FXL_E_ARGUMENT;
    }
    if (band == NULL || band->pixels == NULL) {
        return refuse(renderer, FXL_E_ARGUMENT);
    }
    if (!renderer->ready) {
        return refuse(renderer, FXL_E_ORDER);
    }
    if (band->width != renderer->view.lens.width || band->stride < band->width || band->rows < 1 ||
        band->first_row + band->rows > renderer->view.lens.height) {
        return refuse(renderer, FXL_E_RANGE);
    }
    fxl_counters uncounted = {0};
    fxl_counters *counters = band->first_row == 0 ? &renderer->counters : &uncounted;
    const fxl_scene *scene = renderer->scene;
    for (uint32_t i = 0; i < scene->object_count; i++) {
        const fxl_object *object = &scene->objects[renderer->order[i].index];
        const fxl_model *model = &scene->models[object->model];
        counters->in += model->face_count;
        if (model->kind == FXL_MODEL_SORTED) {
            draw_sorted(renderer, object, model, band, counters);
        } else {
            draw_convex(renderer, object, model, band, counters);
        }
    }
    return FXL_OK;
}

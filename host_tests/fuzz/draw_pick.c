/* SPDX-License-Identifier: MIT */
/* What a frame's pixels show, what a segment and a sphere find in its scene, and what the boxes about its
 * objects say. */
#include <string.h>

#include "answers.h"
#include "draw/submit.h"
#include "parts.h"
#include "game/exact.h"

enum {
    PIXELS = 6
};

void draw_picks(fxl_renderer *renderer, const fxl_band *band, fuzz_input *in)
{
    const fxl_scene *scene = renderer->scene;
    const fxl_lens *lens = &renderer->frame.view.lens;
    const uint32_t refused = renderer->workspace.counters.refused_calls;
    fxl_picked picked = {1, 2, 3};
    const uint8_t state = renderer->frame.state;
    renderer->frame.state = FXL_FRAME_NONE;
    DEMAND(fxl_pick_face(renderer, 0, 0, &picked) == FXL_E_ORDER);
    renderer->frame.state = state;
    DEMAND(fxl_pick_face(NULL, 0, 0, &picked) == FXL_E_ARGUMENT);
    DEMAND(fxl_pick_face(renderer, lens->width, 0, &picked) == FXL_E_RANGE);
    DEMAND(fxl_pick_face(renderer, 0, lens->height, &picked) == FXL_E_RANGE);
    DEMAND(fxl_pick_face(renderer, 0, 0, NULL) == FXL_E_ARGUMENT);
    DEMAND(picked.instance == 1 && picked.face == 2 && picked.colour == 3);
    for (uint32_t i = 0; i < PIXELS; i++) {
        const uint32_t x = fuzz_below(in, lens->width), row = fuzz_below(in, band->rows);
        const fxl_status status =
            fxl_pick_face(renderer, (uint16_t)x, (uint16_t)(band->first_row + row), &picked);
        DEMAND(status == FXL_OK);
        record_number(picked.instance);
        record_number(picked.face);
        record_number(picked.colour);
        if (picked.instance != FXL_PICK_NONE) {
            DEMAND(picked.instance < scene->instance_count);
            DEMAND(picked.face < scene->models[scene->instances[picked.instance].model].face_count);
            DEMAND(picked.colour == band->pixels[row * band->stride + x]);
        }
    }
    renderer->workspace.counters.refused_calls = refused;
}

void draw_all_picks(fxl_renderer *renderer, const void *pixels)
{
    static const uint8_t eighths[] = {1, 4, 6};
    const fxl_scene *scene = renderer->scene;
    const fxl_lens *lens = &renderer->frame.view.lens;
    for (uint32_t i = 0; i < sizeof eighths * sizeof eighths; i++) {
        const uint32_t x = lens->width * eighths[i % sizeof eighths] / 8u;
        const uint32_t y = lens->height * eighths[i / sizeof eighths] / 8u;
        const uint32_t place = y * lens->width + x;
        fxl_picked picked;
        DEMAND(fxl_pick_face(renderer, (uint16_t)x, (uint16_t)y, &picked) == FXL_OK);
        if (picked.instance == FXL_PICK_NONE) {
            continue;
        }
        DEMAND(picked.instance < scene->instance_count);
        DEMAND(picked.face < scene->models[scene->instances[picked.instance].model].face_count);
        if (pixels != NULL && renderer->target->pixel_bits == 16) {
            /* Of a lit face a part is left. */
            DEMAND(fxl_renderer_shader(renderer, FXL_SHADER_LIGHT) != NULL ||
                   ((const uint16_t *)pixels)[place] == renderer->palette[picked.colour]);
        } else if (pixels != NULL) {
            DEMAND(((const uint8_t *)pixels)[place] == picked.colour);
        }
    }
}

static void find_points(const fxl_view *view, fuzz_input *in)
{
    fxl_screen_place place = {{0, 0}, 0, 99};
    const fxl_point point = fuzz_point(in, FXL_COORDINATE_MAX);
    const fxl_point outside = {0, FXL_COORDINATE_MAX + 1, 0};
    DEMAND(fxl_find_on_screen(NULL, &point, &place) == FXL_E_ARGUMENT);
    DEMAND(fxl_find_on_screen(view, &outside, &place) == FXL_E_RANGE && place.place == 99);
    DEMAND(fxl_find_on_screen(view, &point, &place) == FXL_OK);
    DEMAND(place.place <= FXL_POINT_BEYOND);
    record_bytes(&place.at, sizeof place.at);
    record_number(place.depth);
    record_number(place.place);
    DEMAND(place.place != FXL_POINT_VISIBLE ||
           (place.at.x >> 16 < view->lens.width && place.at.y >> 16 < view->lens.height));
}

static void slide(const fxl_scene *scene, const fxl_point *from, fuzz_input *in)
{
    fxl_sphere sphere = {*from, fuzz_between(in, 0, FXL_SLIDE_RADIUS_MAX)}, before = sphere;
    fxl_point move = fuzz_point(in, 3 * (sphere.radius / 2) + 1); /* few steps */
    fxl_slide done = {0, 0, 0, 0};
    if (fuzz_below(in, 16) == 0) {
        move.z = fuzz_any(in);
        sphere.radius = before.radius = fuzz_between(in, 0, FXL_SLIDE_RADIUS_MIN);
    }
    const fxl_status status = fxl_slide_sphere(scene, &sphere, &move, &done);
    DEMAND(status == FXL_OK ||
           ((status == FXL_E_RANGE || (status == FXL_E_PLACEMENT && scene->placements != NULL)) &&
            memcmp(&before, &sphere, sizeof sphere) == 0));
    record_bytes(&sphere, sizeof sphere);
    record_bytes(&done, sizeof done);
    DEMAND(done.instance == FXL_HIT_NONE || done.instance < scene->instance_count);
    DEMAND(fxl_slide_sphere(NULL, &sphere, &move, NULL) == FXL_E_ARGUMENT);
}

void draw_hits(const fxl_scene *scene, const fxl_view *view, fuzz_input *in)
{
    const fxl_point *eye = &view->camera.position;
    fxl_point to = fuzz_point(in, FXL_COORDINATE_MAX);
    fxl_hit hit;
    find_points(view, in);
    if (fuzz_below(in, 2)) { /* to where something is */
        to = scene->instances[fuzz_below(in, scene->instance_count)].centre;
    }
    DEMAND(fxl_cast_segment(scene, eye, &to, &hit) == FXL_OK);
    DEMAND(hit.fraction <= FXL_Q1_31_ONE);
    record_bytes(&hit, sizeof hit);
    if (hit.instance == FXL_HIT_NONE) {
        DEMAND(memcmp(&hit.point, &to, sizeof to) == 0 && hit.fraction == FXL_Q1_31_ONE);
    } else {
        const fxl_instance *instance = &scene->instances[hit.instance];
        const fxl_face *face = &scene->faces[scene->models[instance->model].first_face + hit.face];
        /* Of an instance that is turned, the rounded normal decides. */
        DEMAND((scene->placements != NULL && hit.instance >= scene->first_turned) ||
               fxl_face_is_front(scene, instance, face, eye));
    }
    to.x = FXL_COORDINATE_MAX + 1;
    DEMAND(fxl_cast_segment(scene, eye, &to, &hit) == FXL_E_RANGE);
    slide(scene, eye, in);
}

/* Of an object's vertices, what its box says of the planes. */
static void check_box(const fxl_scene *scene, const fxl_instance *instance, fxl_view *view)
{
    const fxl_model *model = &scene->models[instance->model];
    uint32_t seen = 0;
    fxl_box box;
    fxl_box_of_instance(scene, instance, &box);
    fxl_view_set_world_frustum(view);
    uint32_t planes = fxl_box_planes(&view->frustum, &box);
    for (uint32_t i = 0; i < model->vertex_count; i++) {
        const fxl_point *vertex = &scene->vertices[model->first_vertex + i];
        const fxl_point at = {instance->centre.x + vertex->x, instance->centre.y + vertex->y,
                              instance->centre.z + vertex->z};
        fxl_view_point from_eye;
        fxl_transform_point(&view->camera, &at, &from_eye);
        uint32_t inside = 0;
        for (int plane = 0; plane < FXL_PLANE_COUNT; plane++) {
            bool is_inside = fxl_view_distance(&view->view_frustum, plane, &from_eye) >= 0;
            inside |= (uint32_t)is_inside << plane;
        }
        DEMAND(planes == FXL_SPHERE_OUTSIDE || (planes | inside) == FXL_SPHERE_OUTSIDE - 1);
        seen |= inside;
    }
    record_number(planes);
    DEMAND(planes != FXL_SPHERE_OUTSIDE || seen != FXL_SPHERE_OUTSIDE - 1);
}

void draw_boxes(const fxl_scene *scene, const fxl_lens *lens, const fxl_pose *pose)
{
    fxl_wire wire; /* for its view */
    DEMAND(fxl_wire_init(&wire, scene, lens, fxl_line_by_codes) == FXL_OK);
    DEMAND(fxl_wire_begin(&wire, pose) == FXL_OK);
    const uint32_t end = scene->placements != NULL && scene->first_turned < scene->instance_count
                             ? scene->first_turned /* a box is that of a still instance */
                             : scene->instance_count;
    for (uint32_t i = 0; i < end; i++) {
        check_box(scene, &scene->instances[i], &wire.view);
    }
}

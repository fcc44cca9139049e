/* SPDX-License-Identifier: MIT */
#include <string.h>

#include "answers.h"
#include "draw.h"
#include "game/exact.h"

enum {
    BACKGROUND = 0x11,
    ROWS_MAX = 16
};

/* The first rows in bands of so many; the caller frees them. */
static uint8_t *draw(fxl_wire *wire, const fxl_lens *lens, uint32_t rows, uint32_t step)
{
    uint8_t *pixels = malloc((size_t)rows * lens->width);
    DEMAND(pixels != NULL);
    for (uint32_t row = 0, count; row < rows; row += count) {
        count = step < rows - row ? step : rows - row;
        fxl_band band = {.pixels = pixels + (size_t)row * lens->width,
                         .width = lens->width,
                         .stride = lens->width,
                         .first_row = (uint16_t)row,
                         .rows = (uint16_t)count};
        fxl_fill_band(&band, BACKGROUND);
        DEMAND(fxl_wire_draw(wire, &band) == FXL_OK);
    }
    return pixels;
}

void draw_wireframe(const fxl_scene *scene, const fxl_lens *lens, const fxl_pose *pose,
                    fuzz_input *in)
{
    const uint32_t rows = lens->height < ROWS_MAX ? lens->height : ROWS_MAX;
    fxl_wire_clipper clipper = fuzz_below(in, 2) ? fxl_line_by_planes : fxl_line_by_codes;
    fxl_wire wire;
    DEMAND(fxl_wire_init(&wire, scene, lens, clipper) == FXL_OK);
    DEMAND(fxl_wire_begin(&wire, pose) == FXL_OK);
    uint8_t *whole = draw(&wire, lens, rows, rows);
    const fxl_wire_counters counters = wire.counters;
    DEMAND(counters.in == (uint64_t)counters.outside + counters.refused + counters.drawn);
    DEMAND(counters.refused == 0 && counters.clipped <= counters.drawn);
    uint8_t *bands = draw(&wire, lens, rows, 1 + fuzz_below(in, rows));
    DEMAND(memcmp(whole, bands, (size_t)rows * lens->width) == 0);
    DEMAND(memcmp(&counters, &wire.counters, sizeof counters) == 0);
    record_bytes(whole, (size_t)rows * lens->width);
    record_bytes(&counters, sizeof counters);
    free(whole);
    free(bands);
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

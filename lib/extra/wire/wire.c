/* SPDX-License-Identifier: MIT */
#include "fixel/extra/wire.h"

#include "fixel/stage/cull.h"
#include "fixel/stage/sphere.h"
#include "fixel/stage/transform.h"
#include "../../src/math/memory.h"

fxl_status fxl_wire_init(fxl_wire *wire, const fxl_scene *scene, const fxl_lens *lens,
                         fxl_wire_clipper clipper)
{
    if (wire == NULL || scene == NULL || lens == NULL || clipper == NULL) {
        return FXL_E_ARGUMENT;
    }
    memset(wire, 0, sizeof *wire);
    wire->scene = scene;
    wire->clipper = clipper;
    fxl_view_set_lens(&wire->view, lens);
    fxl_volume_from_lens(lens, FXL_PLANES_ALL, &wire->volume);
    return FXL_OK;
}

fxl_status fxl_wire_begin(fxl_wire *wire, const fxl_pose *pose)
{
    if (wire == NULL) {
        return FXL_E_ARGUMENT;
    }
    fxl_status status = fxl_view_set_pose(&wire->view, pose);
    if (status == FXL_OK) {
        wire->ready = true;
    }
    return status;
}

static void to_view(const fxl_wire *wire, const fxl_instance *instance, const fxl_point *vertex,
                    fxl_view_point *view_point)
{
    const fxl_point point = {instance->centre.x + vertex->x, instance->centre.y + vertex->y,
                             instance->centre.z + vertex->z};
    fxl_transform_point(&wire->view.camera, &point, view_point);
}

/* transform -> clip -> project -> pixels. */
static void draw_edge(fxl_wire *wire, const fxl_instance *instance, const fxl_point *from,
                      const fxl_point *to, uint8_t colour, const fxl_band *band)
{
    fxl_wire_counters *counters = &wire->counters;
    fxl_screen_point ends[2];
    fxl_clip_line line;
    const uint32_t before = counters->intersections;
    line.carried = 0;
    to_view(wire, instance, from, &line.from.position);
    to_view(wire, instance, to, &line.to.position);
    counters->in++;
    if (!wire->clipper(&line, &wire->volume, &counters->intersections)) {
        counters->outside++;
        return;
    }
    if (fxl_project_visible(&wire->view.projection, &line.from.position, &ends[0]) != FXL_OK ||
        fxl_project_visible(&wire->view.projection, &line.to.position, &ends[1]) != FXL_OK) {
        counters->refused++;
        return;
    }
    counters->drawn++;
    counters->clipped += counters->intersections != before;
    fxl_wire_line(&ends[0], &ends[1], colour, band);
}

static void draw_instance(fxl_wire *wire, const fxl_instance *instance, const fxl_band *band)
{
    const fxl_scene *scene = wire->scene;
    const fxl_model *model = &scene->models[instance->model];
    const fxl_point *vertices = &scene->vertices[model->first_vertex];
    for (uint32_t i = 0; i < model->face_count; i++) {
        const fxl_face *face = &scene->faces[model->first_face + i];
        const uint16_t *indices = &scene->indices[face->first_index];
        if (!fxl_face_is_front(scene, instance, face, &wire->view.camera.position)) {
            continue;
        }
        for (uint32_t k = 0; k < face->count; k++) {
            const uint32_t next = k + 1 == face->count ? 0 : k + 1;
            draw_edge(wire, instance, &vertices[indices[k]], &vertices[indices[next]],
                      face->material, band);
        }
    }
}

fxl_status fxl_wire_draw(fxl_wire *wire, const fxl_band *band)
{
    if (wire == NULL || band == NULL || band->pixels == NULL) {
        return FXL_E_ARGUMENT;
    }
    if (!wire->ready) {
        return FXL_E_ORDER;
    }
    if (band->width != wire->view.lens.width || band->stride < band->width || band->rows < 1 ||
        band->first_row + band->rows > wire->view.lens.height) {
        return FXL_E_RANGE;
    }
    const fxl_scene *scene = wire->scene;
    memset(&wire->counters, 0, sizeof wire->counters);
    for (uint32_t i = 0; i < scene->instance_count; i++) {
        const fxl_instance *instance = &scene->instances[i];
        const uint32_t planes =
            fxl_sphere_planes(&wire->view.camera, &wire->view.view_frustum, &instance->centre,
                              scene->models[instance->model].radius);
        if (planes != FXL_SPHERE_OUTSIDE) {
            draw_instance(wire, instance, band);
        }
    }
    return FXL_OK;
}

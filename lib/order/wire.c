/* SPDX-License-Identifier: MIT */
#include "../clip/volume.h"
#include "../math/arith.h"
#include "../math/memory.h"
#include "../raster/columns.h"
#include "../raster/draw_outline.h"
#include "../scene/lens.h"
#include "../scene/placement_code.h"
#include "../view/cull.h"
#include "../view/model_view.h"
#include "../view/outcode.h"
#include "../view/project.h"
#include "../view/view.h"
#include "fixel/wire.h"

static void find_volume(fxl_wire *wire)
{
    fxl_volume_from_sides(&wire->view.view_frustum, fxl_view_drawn_focal(&wire->view),
                          FXL_PLANES_ALL, &wire->volume);
}

/* wire 1.3 */
fxl_status fxl_wire_init(fxl_wire *wire, const fxl_scene *scene, const fxl_lens *lens,
                         fxl_wire_clipper clipper)
{
    if (wire == NULL || scene == NULL || lens == NULL || clipper == NULL) {
        return FXL_E_ARGUMENT;
    }
    if (!fxl_lens_is_valid(lens)) {
        return FXL_E_RANGE;
    }
    memset(wire, 0, sizeof *wire);
    wire->scene = scene;
    wire->clipper = clipper;
    fxl_view_set_lens(&wire->view, lens);
    find_volume(wire);
    return FXL_OK;
}

/* wire 1.3 */
fxl_status fxl_wire_begin(fxl_wire *wire, const fxl_pose *pose)
{
    if (wire == NULL) {
        return FXL_E_ARGUMENT;
    }
    const fxl_scene *scene = wire->scene;
    fxl_status status;
    if (scene == NULL) {
        return FXL_E_ORDER;
    }
    if (scene->placements != NULL) {
        wire->ready = false; /* drawing would read placements that are not checked */
        status = fxl_check_placements(scene);
        if (status != FXL_OK) {
            return status;
        }
    }
    status = fxl_view_set_pose(&wire->view, pose);
    if (status == FXL_OK) {
        if (fxl_orthographic_of(&wire->view.lens) != NULL) {
            find_volume(wire); /* an off-centre one moves near and far with the eye */
        }
        wire->ready = true;
    }
    return status;
}

/* Where an end is on the screen. */
/* orthographic 2.13 */
static bool place_end(const fxl_view *view, const fxl_view_point *from, fxl_screen_point *end)
{
    const fxl_orthographic_code *flat = fxl_orthographic_of(&view->lens);
    return (flat != NULL ? flat->project(view, from, end)
                         : fxl_project_visible(&view->projection, from, end)) == FXL_OK;
}

/* transform -> clip -> project -> pixels. */
/* wire 1.2 */
static void draw_edge(fxl_wire *wire, const fxl_point *from, const fxl_point *to, uint8_t colour,
                      const fxl_band *band)
{
    fxl_wire_counters *counters = &wire->counters;
    fxl_screen_point ends[2];
    fxl_clip_line line;
    const uint32_t before = counters->intersections;
    line.carried = 0;
    fxl_transform_point(&wire->view.camera, from, &line.from.position);
    fxl_transform_point(&wire->view.camera, to, &line.to.position);
    counters->in++;
    if (!wire->clipper(&line, &wire->volume, &counters->intersections)) {
        counters->outside++;
        return;
    }
    if (!place_end(&wire->view, &line.from.position, &ends[0]) ||
        !place_end(&wire->view, &line.to.position, &ends[1])) {
        counters->refused++;
        return;
    }
    counters->drawn++;
    counters->clipped += counters->intersections != before;
    fxl_wire_line(&ends[0], &ends[1], colour, band);
}

/* The points of a face in the world; those of a turned instance are rounded. */
static void place_face(const fxl_scene *scene, uint32_t number, const fxl_face *face,
                       fxl_point *points)
{
    const fxl_placement_code *turned = fxl_placement_code_of(scene, number);
    const fxl_instance *instance = &scene->instances[number];
    const fxl_point *vertices = &scene->vertices[scene->models[instance->model].first_vertex];
    if (turned != NULL) {
        turned->place_face(scene, number, face, points);
        return;
    }
    for (uint32_t k = 0; k < face->count; k++) {
        const fxl_point *vertex = &vertices[fxl_face_indices(scene->indices, face)[k]];
        points[k].x = instance->centre.x + vertex->x;
        points[k].y = instance->centre.y + vertex->y;
        points[k].z = instance->centre.z + vertex->z;
    }
}

/* wire 1.1, orthographic 2.13 */
static bool is_front(const fxl_wire *wire, uint32_t number, const fxl_face *face)
{
    const fxl_scene *scene = wire->scene;
    const fxl_point *eye = &wire->view.camera.position;
    const fxl_placement_code *turned = fxl_placement_code_of(scene, number);
    const fxl_orthographic_code *flat = fxl_orthographic_of(&wire->view.lens);
    return flat != NULL     ? flat->face_is_front(&wire->view, scene, number, face)
           : turned != NULL ? turned->face_is_front(scene, number, face, eye)
                            : fxl_face_is_front(scene, &scene->instances[number], face, eye);
}

/* wire 1.1 */
static void draw_instance(fxl_wire *wire, uint32_t number, const fxl_band *band)
{
    const fxl_scene *scene = wire->scene;
    const fxl_instance *instance = &scene->instances[number];
    const fxl_model *model = &scene->models[instance->model];
    fxl_point points[FXL_FACE_VERTICES_MAX];
    for (uint32_t i = 0; i < model->face_count; i++) {
        const fxl_face *face = &scene->faces[model->first_face + i];
        if (!is_front(wire, number, face)) {
            continue;
        }
        place_face(scene, number, face, points);
        for (uint32_t k = 0; k < face->count; k++) {
            const uint32_t next = k + 1 == face->count ? 0 : k + 1;
            draw_edge(wire, &points[k], &points[next], face->material, band);
        }
    }
}

/* wire 1.1 */
fxl_status fxl_wire_draw(fxl_wire *wire, const fxl_band *band)
{
    if (wire == NULL || band == NULL || band->pixels == NULL) {
        return FXL_E_ARGUMENT;
    }
    if (!wire->ready) {
        return FXL_E_ORDER;
    }
    const fxl_lens *lens = &wire->view.lens;
    if (band->width != lens->width || !fxl_band_is_within(band, lens->width, lens->height)) {
        return FXL_E_RANGE;
    }
    if (!fxl_band_is_aligned(band)) {
        return FXL_E_ALIGNMENT;
    }
    fxl_band from_0 = *band;
    fxl_band_begin_at_column_0(&from_0);
    const fxl_scene *scene = wire->scene;
    memset(&wire->counters, 0, sizeof wire->counters);
    for (uint32_t i = 0; i < scene->instance_count; i++) {
        const fxl_instance *instance = &scene->instances[i];
        const uint32_t planes =
            fxl_sphere_planes(&wire->view.camera, &wire->view.view_frustum, &instance->centre,
                              fxl_instance_radius(scene, instance));
        if (planes != FXL_SPHERE_OUTSIDE) {
            draw_instance(wire, i, &from_0);
        }
    }
    return FXL_OK;
}

/* wire 2.1 */
void fxl_wire_line(const fxl_screen_point *start, const fxl_screen_point *end, uint8_t colour,
                   const fxl_band *band)
{
    fxl_line_pixels pixels;
    const fxl_line_extent extent = fxl_find_line_pixels(start, end, band, &pixels);
    if (extent.first < extent.end) {
        fxl_draw_line_pixels(&pixels, extent.first, extent.end, colour, band);
    }
}

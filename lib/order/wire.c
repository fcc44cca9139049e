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
    if (fxl_orthographic_of(lens) != NULL) {
        return FXL_E_RESERVED;
    }
    memset(wire, 0, sizeof *wire);
    wire->scene = scene;
    wire->clipper = clipper;
    fxl_view_set_lens(&wire->view, lens);
    fxl_volume_from_sides(&wire->view.view_frustum, fxl_view_drawn_focal(&wire->view),
                          FXL_PLANES_ALL, &wire->volume);
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
        wire->ready = true;
    }
    return status;
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
    if (fxl_project_visible(&wire->view.projection, &line.from.position, &ends[0]) != FXL_OK ||
        fxl_project_visible(&wire->view.projection, &line.to.position, &ends[1]) != FXL_OK) {
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

/* wire 1.1 */
static void draw_instance(fxl_wire *wire, uint32_t number, const fxl_band *band)
{
    const fxl_scene *scene = wire->scene;
    const fxl_instance *instance = &scene->instances[number];
    const fxl_model *model = &scene->models[instance->model];
    const fxl_placement_code *turned = fxl_placement_code_of(scene, number);
    const fxl_point *eye = &wire->view.camera.position;
    fxl_point points[FXL_FACE_VERTICES_MAX];
    for (uint32_t i = 0; i < model->face_count; i++) {
        const fxl_face *face = &scene->faces[model->first_face + i];
        if (!(turned != NULL ? turned->face_is_front(scene, number, face, eye)
                             : fxl_face_is_front(scene, instance, face, eye))) {
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

/* A line, described along its major axis. */
typedef struct {
    int32_t from, to; /* along the major axis, from < to */
    int32_t across;   /* at from */
    int32_t rise;     /* change across from `from` to `to`, no larger than to - from */
} major_line;

/* place fill-rule: the pixels of a line, with a first_centre of its own */
/* The first pixel whose centre is not before a coordinate. So the pixels with centres from a
 * (included) to b (excluded) are first_centre(a) .. first_centre(b) - 1. */
/* wire 2.2 */
static int32_t first_centre(int32_t coordinate)
{
    return (coordinate + 32767) >> 16; /* ceil(c / 2^16 - 1/2) */
}

/* Returns the pixel across the line at the centre of pixel `along`. *left is the remainder, in
 * units of 1/2^16 of 1/length; a pixel is 65536 length of them. The sum is (across + 8192 *
 * 65536) length + (centre - from) rise. The first term is below 2^30 2^30; the second, between
 * two points of the line, is below 2^29 2^30. The sum is positive, because the point lies on the
 * line and no point lies beyond -4095 pixels. */
/* wire 2.2 */
static int32_t pixel_at(const major_line *line, int32_t along, int64_t *left)
{
    const int32_t length = line->to - line->from; /* below 2^30 */
    const int32_t centre = along * 65536 + 32768;
    const int64_t sum = fxl_multiply_s32(line->across + 8192 * 65536, length) +
                        fxl_multiply_s32(centre - line->from, line->rise);
    uint32_t remainder;
    FXL_ASSERT(sum >= 0);
    const uint32_t pixel = fxl_divide_u64((uint64_t)sum >> 16, (uint32_t)length, &remainder);
    *left = (int64_t)remainder * 65536 + (sum & 0xFFFF);
    return (int32_t)pixel - 8192;
}

/* Draws from pixel to pixel: across changes by rise / length, at most one pixel. The length is
 * below 2^30, so a pixel is below 2^46. */
/* wire 2.3, 2.4 */
static void draw_pixels(const major_line *line, int32_t first, int32_t end, bool upright,
                        uint8_t colour, const fxl_band *band)
{
    fxl_line_pixels pixels;
    if (first >= end) {
        return;
    }
    pixels.across = pixel_at(line, first, &pixels.left);
    pixels.pixel = (int64_t)(line->to - line->from) * 65536;
    pixels.step = (int64_t)line->rise * 65536;
    pixels.upright = upright;
    fxl_draw_line_pixels(&pixels, first, end, colour, band);
}

static int32_t greater(int32_t a, int32_t b)
{
    return a > b ? a : b;
}

static int32_t lesser(int32_t a, int32_t b)
{
    return a < b ? a : b;
}

/* wire 2.1 */
void fxl_wire_line(const fxl_screen_point *start, const fxl_screen_point *end, uint8_t colour,
                   const fxl_band *band)
{
    const int32_t width = end->x - start->x, height = end->y - start->y; /* below 2^30 */
    const bool upright = (height < 0 ? -height : height) > (width < 0 ? -width : width);
    if (upright) {
        const fxl_screen_point *top = height < 0 ? end : start;
        const major_line line = {top->y, height < 0 ? start->y : end->y, top->x,
                                 height < 0 ? -width : width};
        draw_pixels(&line, greater(first_centre(line.from), band->first_row),
                    lesser(first_centre(line.to), band->first_row + band->rows), true, colour,
                    band);
    } else {
        const fxl_screen_point *first = width < 0 ? end : start;
        const major_line line = {first->x, width < 0 ? start->x : end->x, first->y,
                                 width < 0 ? -height : height};
        draw_pixels(&line, greater(first_centre(line.from), 0),
                    lesser(first_centre(line.to), band->width), false, colour, band);
    }
}

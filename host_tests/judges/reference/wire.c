/* SPDX-License-Identifier: MIT */
#include "reference/wire.h"

#include <math.h>
#include <stdlib.h>

#include "reference/camera.h"
#include "reference/cull.h"
#include "reference/clip.h"

static bool append(ref_wire *wire, const ref_screen_line *line)
{
    ref_screen_line *lines =
        ref_grown(wire->lines, wire->count, &wire->capacity, 256, sizeof *lines);
    if (!lines) {
        return false;
    }
    wire->lines = lines;
    wire->lines[wire->count++] = *line;
    return true;
}

static ref_volume_vertex vertex_of(const ref_camera *camera, const ref_lattice_point *corner)
{
    const ref_point point = ref_point_from_lattice(corner);
    const ref_view_point view_point = ref_transform_point(camera, &point);
    return (ref_volume_vertex){.x = view_point.x, .y = view_point.y, .z = view_point.z};
}

static ref_screen_point end_of(const ref_lens *lens, const ref_volume_vertex *from,
                               const ref_volume_vertex *to, ref_wide t)
{
    ref_volume_vertex end = *to;
    if (t <= 0) {
        end = *from;
    } else if (t < 1) {
        end = ref_volume_between(from, to, t);
    }
    const ref_view_point view_point = {(long double)end.x, (long double)end.y, (long double)end.z};
    return ref_project_point(lens, &view_point);
}

bool ref_wire_frame(ref_wire *wire, const ref_scene *scene, const ref_lens *lens,
                    const ref_pose *pose)
{
    const ref_camera camera = ref_camera_from_pose(pose);
    ref_half_space planes[REF_PLANE_COUNT];
    ref_volume_from_lens(lens, planes);
    wire->count = 0;
    for (uint32_t i = 0; i < scene->instance_count; i++) {
        const ref_instance *instance = &scene->instances[i];
        const ref_model *model = &scene->models[instance->model];
        for (uint32_t f = 0; f < model->face_count; f++) {
            const ref_face *face = &scene->faces[model->first_face + f];
            if (!ref_face_is_front(scene, instance, face, &pose->position)) {
                continue;
            }
            for (int k = 0; k < face->count; k++) {
                const ref_lattice_point a = ref_face_vertex(scene, instance, face, k);
                const ref_lattice_point b =
                    ref_face_vertex(scene, instance, face, (k + 1) % face->count);
                const ref_volume_vertex from = vertex_of(&camera, &a), to = vertex_of(&camera, &b);
                ref_wide enter, leave;
                if (!ref_clip_line(&from, &to, planes, REF_PLANE_COUNT, &enter, &leave)) {
                    continue;
                }
                const ref_screen_line line = {end_of(lens, &from, &to, enter),
                                              end_of(lens, &from, &to, leave), face->material};
                if (!append(wire, &line)) {
                    return false;
                }
            }
        }
    }
    return true;
}

void ref_wire_close(ref_wire *wire)
{
    free(wire->lines);
    *wire = (ref_wire){0};
}

/* A line along its major axis: slope is the change across for each unit along. */
typedef struct {
    double from, to, across, slope;
    bool upright;
} major_line;

static bool is_upright(const ref_screen_line *line)
{
    return fabs(line->to.y - line->from.y) > fabs(line->to.x - line->from.x);
}

static major_line major_line_of(const ref_screen_line *line, bool upright)
{
    major_line of = {.upright = upright};
    const double a = of.upright ? line->from.y : line->from.x;
    const double b = of.upright ? line->to.y : line->to.x;
    const double c = of.upright ? line->from.x : line->from.y;
    const double d = of.upright ? line->to.x : line->to.y;
    of.from = fmin(a, b);
    of.to = fmax(a, b);
    of.across = a <= b ? c : d;
    of.slope = of.to > of.from ? (a <= b ? d - c : c - d) / (of.to - of.from) : 0;
    return of;
}

/* place fill-rule: definition: the pixels of a line */
void ref_wire_line(const ref_screen_line *line, const ref_band *band)
{
    const major_line of = major_line_of(line, is_upright(line));
    const int end = of.upright ? band->first_row + band->rows : band->width;
    for (int along = of.upright ? band->first_row : 0; along < end; along++) {
        const double centre = along + 0.5;
        if (centre < of.from || centre >= of.to) {
            continue;
        }
        const int across = (int)floor(of.across + (centre - of.from) * of.slope);
        const int x = of.upright ? across : along;
        const int row = (of.upright ? along : across) - band->first_row;
        if (x >= 0 && x < band->width && row >= 0 && row < band->rows) {
            band->pixels[row * band->stride + x] = line->colour;
        }
    }
}

bool ref_wire_is_near(const ref_screen_line *line, int column, int row, double d)
{
    const double width = fabs(line->to.x - line->from.x), height = fabs(line->to.y - line->from.y);
    for (int upright = 0; upright < 2; upright++) {
        const major_line of = major_line_of(line, upright);
        const bool other = upright != is_upright(line);
        /* A line that is so nearly diagonal that it may count as either kind is tested as both. */
        if (other && fabs(width - height) > 4 * d) {
            continue;
        }
        const double centre = (of.upright ? row : column) + 0.5, pixel = of.upright ? column : row;
        const double at = of.across + (centre - of.from) * of.slope;
        const bool along_ends = fabs(centre - of.from) <= d || fabs(centre - of.to) <= d;
        const bool within = centre >= of.from - d && centre < of.to + d;
        const bool touches = at >= pixel - 2 * d && at <= pixel + 1 + 2 * d;
        const bool border = fabs(at - pixel) <= 2 * d || fabs(at - pixel - 1) <= 2 * d;
        if (within && touches && (along_ends || border || fabs(width - height) <= 4 * d)) {
            return true;
        }
    }
    return false;
}

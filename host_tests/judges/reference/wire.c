/* SPDX-License-Identifier: MIT */
#include "reference/wire.h"

#include <math.h>
#include <stdlib.h>

#include "reference/camera.h"
#include "reference/cull.h"
#include "reference/clip.h"
#include "reference/placement.h"
/* place field: the reference's reader: sizes of entries, and offsets as numbers */
#include "reference/sections.h"

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
    ref_camera camera = ref_camera_from_pose(pose);
    ref_half_space planes[REF_PLANE_COUNT];
    ref_volume_from_lens(lens, planes);
    if (lens->scale != 0) {
        ref_camera_take_eye(&camera);
    }
    wire->count = 0;
    for (uint32_t i = 0; i < scene->instance_count; i++) {
        const ref_instance *instance = &scene->instances[i];
        const ref_model *model = &scene->models[instance->model];
        for (uint32_t f = 0; f < model->face_count; f++) {
            const ref_face *face = &scene->faces[model->first_face + f];
            if (!ref_face_shows_front(scene, instance, face, &pose->position, &camera)) {
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

/* --- lines and points of models -------------------------------------------------------------- */

static bool line_is_sound(const ref_line *line, const ref_model *model, uint16_t reserved)
{
    return line->from < model->vertex_count && line->to < model->vertex_count &&
           line->faces[0] <= model->face_count && line->faces[1] <= model->face_count &&
           line->width >= 1 && line->width <= 16 && reserved == 0;
}

bool ref_lines_read(const uint8_t *bytes, ref_scene *scene)
{
    uint32_t count, ends;
    const uint8_t *p = ref_section(bytes, REF_LINES, &count);
    const uint8_t *map = ref_section(bytes, REF_LINE_MAP, &ends);
    if (!p) {
        return true;
    }
    scene->lines = calloc(count, sizeof *scene->lines);
    scene->line_map = calloc(ends, sizeof *scene->line_map);
    if (!scene->lines || !scene->line_map) {
        return false;
    }
    for (uint32_t i = 0; i < ends; i++) {
        scene->line_map[i] = ref_u32(map + 4 * (size_t)i);
        if (scene->line_map[i] > count || (i > 0 && scene->line_map[i] < scene->line_map[i - 1])) {
            return false;
        }
    }
    for (uint32_t m = 0; m < scene->model_count; m++) {
        for (uint32_t i = scene->line_map[m]; i < scene->line_map[m + 1]; i++) {
            const uint8_t *at = p + 12 * (size_t)i;
            scene->lines[i] = (ref_line){ref_u16(at), ref_u16(at + 2),
                                         {ref_u16(at + 4), ref_u16(at + 6)}, at[8], at[9]};
            if (!line_is_sound(&scene->lines[i], &scene->models[m], ref_u16(at + 10))) {
                return false;
            }
        }
    }
    return scene->line_map[0] == 0 && scene->line_map[scene->model_count] == count;
}

static ref_point vertex_in_world(const ref_scene *scene, const ref_instance *instance,
                                 uint32_t number)
{
    const ref_placement *placement = ref_placement_of(scene, instance);
    const ref_lattice_point vertex = ref_model_vertex(scene, instance, number);
    if (placement) {
        return ref_placement_point(placement, &instance->centre, &vertex);
    }
    const ref_lattice_point placed = ref_instance_vertex(scene, instance, number);
    return ref_point_from_lattice(&placed);
}

/* The part of a line that the frustum leaves, with near and far moved apart. Returns false where
 * nothing is left. */
static bool clip_ends(const ref_line_view *view, const ref_view_point ends[2], double moved,
                      ref_view_point left[2])
{
    ref_view_frustum frustum = *view->frustum;
    ref_half_space planes[REF_PLANE_COUNT];
    ref_volume_vertex from = {.x = ends[0].x, .y = ends[0].y, .z = ends[0].z};
    ref_volume_vertex to = {.x = ends[1].x, .y = ends[1].y, .z = ends[1].z};
    ref_wide enter, leave;
    ref_depth_move_view_frustum(&frustum, moved);
    for (int i = 0; i < REF_PLANE_COUNT; i++) {
        const ref_view_plane *plane = &frustum.planes[i];
        planes[i] = (ref_half_space){plane->upright ? 0 : plane->across,
                                     plane->upright ? plane->across : 0, plane->along,
                                     -plane->distance};
    }
    if (!ref_clip_line(&from, &to, planes, REF_PLANE_COUNT, &enter, &leave)) {
        return false;
    }
    for (int i = 0; i < 2; i++) {
        const ref_wide t = i == 0 ? enter : leave;
        const ref_volume_vertex at = t <= 0 ? from : t >= 1 ? to : ref_volume_between(&from, &to, t);
        left[i] = (ref_view_point){(long double)at.x, (long double)at.y, (long double)at.z};
    }
    return true;
}

/* The pixels whose centres lie in the outline: from half the width above each end of a line to half
 * below, or to both sides if it is steep. Of two centres exactly on the borders the fill rule takes
 * the first, and the rule of lines the last: so the outline is moved by less than an end is off. */
#define LAST_OF_TWO 0x1p-40

static void outline_of(const ref_screen_point ends[2], bool is_point, bool upright, double width,
                       ref_screen_polygon *outline)
{
    const double half = width / 2, x = upright || is_point ? half : 0,
                 y = upright && !is_point ? 0 : half;
    const double right = x > 0 ? LAST_OF_TWO : 0, down = y > 0 ? LAST_OF_TWO : 0;
    const ref_screen_point a = {ends[0].x + right, ends[0].y + down};
    const ref_screen_point b = {ends[1].x + right, ends[1].y + down};
    outline->count = 4;
    if (is_point) {
        outline->points[0] = (ref_screen_point){a.x - x, a.y - y};
        outline->points[1] = (ref_screen_point){a.x + x, a.y - y};
        outline->points[2] = (ref_screen_point){a.x + x, a.y + y};
        outline->points[3] = (ref_screen_point){a.x - x, a.y + y};
        return;
    }
    outline->points[0] = (ref_screen_point){a.x - x, a.y - y};
    outline->points[1] = (ref_screen_point){b.x - x, b.y - y};
    outline->points[2] = (ref_screen_point){b.x + x, b.y + y};
    outline->points[3] = (ref_screen_point){a.x + x, a.y + y};
}

/* All that a line may cover which is so nearly diagonal that rounding decides whether it is steep:
 * its ends with a square about each. */
static void hull_of(const ref_screen_point ends[2], double width, ref_screen_polygon *outline)
{
    const double half = width / 2;
    const bool rises = (ends[1].x - ends[0].x) * (ends[1].y - ends[0].y) < 0;
    const ref_screen_point a = ends[0].x <= ends[1].x ? ends[0] : ends[1];
    const ref_screen_point b = ends[0].x <= ends[1].x ? ends[1] : ends[0];
    const double first = rises ? half : -half;
    outline->count = 6;
    outline->points[0] = (ref_screen_point){a.x - half, a.y + first};
    outline->points[1] = (ref_screen_point){a.x + half, a.y + first};
    outline->points[2] = (ref_screen_point){b.x + half, b.y + first};
    outline->points[3] = (ref_screen_point){b.x + half, b.y - first};
    outline->points[4] = (ref_screen_point){b.x - half, b.y - first};
    outline->points[5] = (ref_screen_point){a.x - half, a.y - first};
}

/* The outline of what is left of a line; no points: nothing is. left: the ends in the view. */
static bool project_line(const ref_line_view *view, const ref_view_point ends[2], bool is_point,
                         double width, double moved, ref_screen_point screen[2],
                         ref_screen_polygon *outline)
{
    ref_view_point left[2];
    outline->count = 0;
    if (!clip_ends(view, ends, moved, left)) {
        return false;
    }
    screen[0] = ref_project_point(view->lens, &left[0]);
    screen[1] = ref_project_point(view->lens, &left[1]);
    const bool upright = fabs(screen[1].y - screen[0].y) > fabs(screen[1].x - screen[0].x);
    outline_of(screen, is_point, upright, width, outline);
    return true;
}

/* Rounding may make a steep line of a diagonal one, by as much as a judge allows. */
#define DIAGONAL (4.0 / 8192)

/* The nearness of a line on no face. An end that was clipped has that of where it is. */
static void find_own_depth(const ref_line_view *view, const ref_view_point ends[2],
                           const ref_screen_point screen[2], ref_drawn *drawn)
{
    ref_view_point left[2];
    ref_line_look *line = &drawn->line;
    (void)clip_ends(view, ends, 0, left);
    for (int i = 0; i < 2; i++) {
        line->nearness[i] = (double)ref_nearness_of_point(view->lens, left[i].z);
    }
    line->upright = fabs(screen[1].y - screen[0].y) > fabs(screen[1].x - screen[0].x);
    line->from = line->upright ? screen[0].y : screen[0].x;
    line->to = line->upright ? screen[1].y : screen[1].x;
}

/* How thin a face of a line is on the screen, and one of its corners. */
static void find_thinness(const ref_line_view *view, const ref_instance *instance,
                          const ref_face *face, ref_line_look *look)
{
    ref_polygon world;
    ref_view_polygon in_view;
    ref_screen_point at[UINT8_MAX];
    double area = 0, longest = 0, nearest = 0, farthest = INFINITY;
    if (view->lens->scale != 0) {
        return; /* none is small */
    }
    ref_face_to_polygon(view->scene, instance, face, false, &world);
    ref_transform_polygon(view->camera, &world, &in_view);
    for (int i = 0; i < in_view.count; i++) {
        if (in_view.vertices[i].position.z < view->lens->near_z) {
            return; /* it is not small */
        }
        at[i] = ref_project_point(view->lens, &in_view.vertices[i].position);
        nearest = fmax(nearest, view->lens->near_z / (double)in_view.vertices[i].position.z);
        farthest = fmin(farthest, view->lens->near_z / (double)in_view.vertices[i].position.z);
    }
    for (int i = 0; i < in_view.count; i++) {
        const ref_screen_point a = at[i], b = at[(i + 1) % in_view.count];
        area += (a.x - at[0].x) * (b.y - at[0].y) - (a.y - at[0].y) * (b.x - at[0].x);
        longest = fmax(longest, hypot(a.x - at[0].x, a.y - at[0].y));
        longest = fmax(longest, hypot(a.x - b.x, a.y - b.y));
    }
    look->octaves[look->plane_count][0] = pow(2, floor(log2(farthest)) + 1);
    look->octaves[look->plane_count][1] = pow(2, floor(log2(nearest)) + 1);
    look->corners[look->plane_count] = at[0];
    look->heights[look->plane_count] = longest > 0 ? fabs(area) / in_view.count / longest : 0;
}

/* The depth whose code the linear function of a face has where its plane has a depth. */
static double linear_depth(double depth, const double octaves[2])
{
    if (depth > octaves[1]) {
        return 2 * depth - octaves[1];
    }
    return depth < octaves[0] / 2 ? (2 * depth + octaves[0]) / 4 : depth;
}

double ref_drawn_nearness_most(const ref_drawn *drawn, const ref_lens *lens, double x, double y)
{
    const ref_line_look *line = &drawn->line;
    double most = ref_drawn_nearness(drawn, lens, x, y);
    for (int i = 0; i < line->plane_count; i++) {
        const double depth = lens->near_z * ref_nearness(&line->planes[i], lens, x, y);
        if (line->heights[i] > 0) {
            most = fmax(most, linear_depth(depth, line->octaves[i]) / lens->near_z);
        }
    }
    return most;
}

double ref_drawn_slack(const ref_drawn *drawn, const ref_lens *lens, double x, double y)
{
    const ref_line_look *line = &drawn->line;
    double slack = drawn->depth.slack;
    for (int i = 0; i < line->plane_count; i++) {
        const ref_depth_plane *plane = &line->planes[i];
        const double here = ref_nearness(plane, lens, x, y);
        const double steep = hypot(ref_nearness(plane, lens, x + 1, y) - here,
                                   ref_nearness(plane, lens, x, y + 1) - here);
        const double away = hypot(x - line->corners[i].x, y - line->corners[i].y);
        if (line->heights[i] > 0 && here > 0) {
            slack = fmax(slack, plane->slack + steep / here / REF_ONE *
                                                   (1 + 2 * away / line->heights[i]));
        }
    }
    return slack;
}

bool ref_line_find(const ref_line_view *view, const ref_line *line, ref_drawn *drawn)
{
    const ref_scene *scene = view->scene;
    const ref_instance *instance = &scene->instances[drawn->instance];
    const bool is_point = line->from == line->to, has_faces = line->faces[0] || line->faces[1];
    ref_line_look *look = &drawn->line;
    ref_polygon world = {.count = 2};
    ref_view_point ends[2];
    ref_screen_point screen[2] = {{0, 0}, {0, 0}};
    for (int i = 0; i < 2; i++) {
        world.vertices[i].position = vertex_in_world(scene, instance, i ? line->to : line->from);
        ends[i] = ref_transform_point(view->camera, &world.vertices[i].position);
        const uint32_t number = line->faces[i];
        const ref_face *face = number ? ref_face_of(scene, instance, number - 1) : NULL;
        if (face && ref_face_shows_front(scene, instance, face, view->eye, view->camera)) {
            ref_depth_plane_find(scene, view->camera, instance, face,
                                 &look->planes[look->plane_count]);
            if (view->lens->scale != 0) {
                ref_depth_plane_take_eye(&look->planes[look->plane_count], view->lens);
            }
            drawn->depth.slack = fmax(drawn->depth.slack, look->planes[look->plane_count].slack);
            find_thinness(view, instance, face, look);
            look->faces[look->plane_count++] = number;
        }
    }
    if (has_faces && look->plane_count == 0) {
        return false;
    }
    look->is_line = true;
    const bool shown = project_line(view, ends, is_point, line->width, 0, screen, &drawn->polygon);
    drawn->polygon.colour = drawn->least.colour = drawn->most.colour = line->colour;
    if (shown && look->plane_count == 0) {
        find_own_depth(view, ends, screen, drawn);
        drawn->depth.slack = 0x1p-24;
    }
    const double bound = ref_depth_bound(&world, &view->camera->position, view->lens) +
                         ref_placement_depth_bound(scene, instance);
    if (view->keeps_doubt &&
        ref_depth_is_in_doubt(view->frustum, view->camera, &world, bound)) {
        ref_screen_point other[2];
        drawn->in_doubt = true;
        project_line(view, ends, is_point, line->width, -bound, other, &drawn->least);
        project_line(view, ends, is_point, line->width, bound, other, &drawn->most);
    } else if (view->keeps_doubt && shown && !is_point &&
               fabs(fabs(screen[1].x - screen[0].x) - fabs(screen[1].y - screen[0].y)) < DIAGONAL) {
        drawn->in_doubt = true;
        drawn->least.count = 0;
        hull_of(screen, line->width, &drawn->most);
    }
    return drawn->polygon.count > 0 || drawn->most.count > 0;
}

double ref_drawn_nearness(const ref_drawn *drawn, const ref_lens *lens, double x, double y)
{
    const ref_line_look *line = &drawn->line;
    if (!line->is_line) {
        return ref_nearness(&drawn->depth, lens, x, y);
    }
    if (line->plane_count > 0) {
        double nearness = ref_nearness(&line->planes[0], lens, x, y);
        for (int i = 1; i < line->plane_count; i++) {
            nearness = fmax(nearness, ref_nearness(&line->planes[i], lens, x, y));
        }
        return nearness;
    }
    const double length = line->to - line->from;
    const double t = length != 0 ? ((line->upright ? y : x) - line->from) / length : 0;
    const double within = fmin(fmax(t, 0), 1);
    return line->nearness[0] + within * (line->nearness[1] - line->nearness[0]);
}

bool ref_lies_on(const ref_drawn *line, const ref_drawn *face)
{
    bool lies = false;
    for (int i = 0; i < line->line.plane_count; i++) {
        lies = lies || line->line.faces[i] == face->face + 1;
    }
    return lies && !face->line.is_line && line->instance == face->instance;
}

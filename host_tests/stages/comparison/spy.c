/* SPDX-License-Identifier: MIT */
#include "comparison/spy.h"

#include <math.h>
#include <string.h>

#include "clippers/measure.h"

#define CLAIMED 1.25

enum {
    PIECES_MAX = 128,
    WORKSPACE_BYTES = 131072
};

/* The clipper's, which begins with its account. */
static uint64_t workspace[WORKSPACE_BYTES / 8];

static const fxl_clipper *asked;
static fxl_clipper spy;
static spy_sides cut_to;
static spy_findings found;

/* The face under way: what it is, and what came of it. */
static struct {
    bool open;
    fxl_lens lens;
    ref_volume_polygon seen;
    int count;
    outline pieces[PIECES_MAX];
} current;

/* Whether the planes of the lens cut the face under way and leave something of it. */
static bool is_crossing(void)
{
    ref_half_space planes[REF_PLANE_COUNT];
    ref_lens lens = bridge_lens(&current.lens);
    ref_volume_polygon left;
    ref_volume_from_lens(&lens, planes);
    return ref_clip_to_volume(&current.seen, planes, REF_PLANE_COUNT, &left) && left.count >= 3;
}

static void planes_of(const fxl_lens *lens, ref_half_space planes[REF_PLANE_COUNT])
{
    ref_lens wide = bridge_lens(lens);
    ref_volume_from_lens(&wide, planes);
    for (int i = REF_PLANE_LEFT; i < REF_PLANE_COUNT; i++) {
        bool upright = i >= REF_PLANE_BOTTOM;
        double sign = i == REF_PLANE_LEFT || i == REF_PLANE_BOTTOM ? 1 : -1;
        double across = sign * wide.focal, half = (upright ? wide.height : wide.width) / 2.0;
        if (cut_to == SIDES_LENS || (cut_to == SIDES_LEFT && i == REF_PLANE_LEFT)) {
            continue;
        }
        planes[i] = (ref_half_space){upright ? 0 : across, upright ? across : 0,
                                     cut_to == SIDES_BORDER ? half : FXL_GUARD_PIXELS, 0};
    }
}

/* The largest distance between an outline and the pieces that are to fill it: how far a
 * piece reaches beyond it, and how far a corner of it is from the nearest piece. */
static double distance_of_pieces(const outline *expected)
{
    double worst = 0;
    for (int i = 0; i < expected->count; i++) {
        double nearest = INFINITY;
        for (int k = 0; k < current.count; k++) {
            nearest =
                fmin(nearest, outline_beyond(&current.pieces[k], expected->x[i], expected->y[i]));
        }
        worst = fmax(worst, nearest);
    }
    for (int k = 0; k < current.count; k++) {
        for (int i = 0; i < current.pieces[k].count; i++) {
            worst = fmax(worst,
                         outline_beyond(expected, current.pieces[k].x[i], current.pieces[k].y[i]));
        }
    }
    return worst;
}

/* Rounding to 1/65536 pixel may leave nothing of what is thinner than 2 of them. */
static bool is_something(const outline *of)
{
    return fabs(outline_area(of)) > outline_length(of) / 65536;
}

/* All that came of the face is there. */
static void close_face(void)
{
    if (!current.open) {
        return;
    }
    current.open = false;
    ref_half_space planes[REF_PLANE_COUNT];
    outline expected;
    bool parallel;
    planes_of(&current.lens, planes);
    bool seen = case_expected_of(&current.seen, &current.lens, planes, &expected, &parallel);
    if (current.count == 0) { /* beside the screen there is nothing to miss */
        ref_lens lens = bridge_lens(&current.lens);
        ref_volume_from_lens(&lens, planes);
        seen = case_expected_of(&current.seen, &current.lens, planes, &expected, &parallel);
        found.missed += seen && is_something(&expected);
        return;
    }
    if (!seen) {
        for (int k = 0; k < current.count; k++) {
            found.missed += is_something(&current.pieces[k]);
        }
        return;
    }
    double distance = current.count == 1 ? outline_distance(&current.pieces[0], &expected)
                                         : distance_of_pieces(&expected);
    found.error_at_all = fmax(found.error_at_all, distance);
    if (!parallel) {
        found.error = fmax(found.error, distance);
        found.beyond += distance > CLAIMED;
    }
}

/* The vertices of a face in the view, exact. Of a turned instance whose points the clipper does not
 * round they are what its matrix makes of those of the model (SPEC.md, section 8.2). */
static ref_volume_polygon seen_of(const fxl_model_view *model_view, const fxl_face *face)
{
    const fxl_camera *camera = &model_view->view->camera;
    clipper_case of = {.camera = *camera};
    if (model_view->axes == &camera->axes) {
        fxl_face_to_polygon(model_view, face, &of.polygon);
        return case_seen(&of);
    }
    ref_volume_polygon seen = {.count = face->count};
    for (int i = 0; i < seen.count; i++) {
        fxl_cached_vertex vertex;
        fxl_transform_vertex(model_view, fxl_face_indices(model_view->indices, face)[(uint32_t)i],
                             &vertex);
        ref_view_point at = bridge_view_point(&vertex.position);
        seen.vertices[i] = (ref_volume_vertex){.x = at.x, .y = at.y, .z = at.z};
    }
    return seen;
}

static void open_face(const fxl_model_view *model_view, const fxl_face *face)
{
    current.open = true;
    current.count = 0;
    current.lens = model_view->view->lens;
    current.seen = seen_of(model_view, face);
    found.faces++;
    found.crossing += is_crossing();
    for (int i = 0; i < current.seen.count; i++) {
        const ref_volume_vertex *at = &current.seen.vertices[i];
        found.view = fmax(
            found.view, fmax(fabs((double)at->x), fmax(fabs((double)at->y), fabs((double)at->z))));
    }
}

static void add_piece(const fxl_screen_polygon *screen)
{
    const fxl_lens *lens = &current.lens;
    found.pieces++;
    found.vertices = screen->count > found.vertices ? screen->count : found.vertices;
    for (int i = 0; i < screen->count; i++) {
        found.screen =
            fmax(found.screen, fmax(fabs(screen->points[i].x / 65536.0 - lens->width / 2.0),
                                    fabs(screen->points[i].y / 65536.0 - lens->height / 2.0)));
    }
    if (current.count < PIECES_MAX) {
        current.pieces[current.count++] = outline_of_screen(screen->points, screen->count);
    }
}

static fxl_clip_result ask(const fxl_model_view *model_view, const fxl_face *face,
                           fxl_clipper_work *work, fxl_screen_polygon *screen)
{
    close_face();
    open_face(model_view, face);
    fxl_clip_result result = asked->clip(model_view, face, work, screen);
    switch (result) {
    case FXL_CLIP_INSIDE:
        found.inside++;
        add_piece(screen);
        break;
    case FXL_CLIP_CUT:
        found.cut++;
        add_piece(screen);
        break;
    case FXL_CLIP_OUTSIDE:
        found.outside++;
        break;
    case FXL_CLIP_DEGENERATE:
        found.degenerate++;
        break;
    case FXL_CLIP_BETWEEN:
        found.between++;
        current.open = false;
        break;
    default:
        found.refused++;
        current.open = false;
    }
    return result;
}

static fxl_clip_result ask_next(const fxl_model_view *model_view, fxl_clipper_work *work,
                                fxl_screen_polygon *screen)
{
    fxl_clip_result result = asked->next(model_view, work, screen);
    if (result == FXL_CLIP_INSIDE || result == FXL_CLIP_CUT) {
        add_piece(screen);
    }
    return result;
}

bool spy_begin(fxl_renderer *renderer, spy_sides sides)
{
    uint32_t wanted = renderer->clipper->workspace_size;
    wanted = wanted > sizeof(fxl_clip_stats) ? wanted : (uint32_t)sizeof(fxl_clip_stats);
    cut_to = sides;
    asked = renderer->clipper;
    spy = (fxl_clipper){.clip = ask,
                        .next = asked->next != NULL ? ask_next : NULL,
                        .workspace_size = wanted,
                        .begin = asked->begin,
                        .by_points = asked->by_points};
    found = (spy_findings){.error = 0};
    return fxl_renderer_set_clipper(renderer, &spy, workspace, sizeof workspace) == FXL_OK;
}

void spy_watch(fxl_renderer *renderer, bool watching)
{
    renderer->clipper = watching ? &spy : asked;
}

const spy_findings *spy_end(void)
{
    fxl_clip_stats stats;
    memcpy(&stats, workspace, sizeof stats);
    close_face();
    found.intersections = stats.intersections;
    found.distances = stats.distances;
    return &found;
}

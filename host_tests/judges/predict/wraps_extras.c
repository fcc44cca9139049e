/* SPDX-License-Identifier: MIT */
/* Counts of what a scene may ask for: a depth buffer, billboards, beams of light; and of turned
 * faces that are placed in the world for those and for light. */
#include <math.h>

#include "clip/split.h"
#include "draw/depth_plane.h"
#include "draw/line_view.h"
#include "draw/surface_polygon.h"
#include "draw/submit.h"
#include "math/plane.h"
#include "paint/billboard_paint.h"
#include "paint/billboard_walk.h"
#include "paint/depth_cells.h"
#include "paint/depth_row.h"
#include "paint/lit_pieces.h"
#include "predict/counts.h"
#include "raster/scan.h"
#include "scene/scene_check.h"
#include "view/model_view.h"
#include "view/placement.h"

/* --- depth buffer --------------------------------------------------------------------------- */

bool has_depth_buffer, paints_surface, keeps_less, draws_depth_outline, begins_smooth, draws_smooth,
    begins_listed, draws_listed;

/* The band under way is drawn far to near, by loops that stand in the callers: each pixel of a
 * polygon is compared, and counted by area. */
bool compares_each;

/* Of the band under way, with cells of 16 bits; else null. */
static const fxl_depth_head *cells_of_16;

bool is_listed(const fxl_depth_plane *plane)
{
    return cells_of_16 != NULL && !compares_each &&
           plane->one >= 32 + (int32_t)cells_of_16->scale.octaves;
}

WRAPPED_COUNT_VOID(void, fxl_corner_planes_depth,
                   (fxl_corner_planes * planes, fxl_depth_plane *plane), (planes, plane),
                   counted.small_depths += !planes->has_weight)

/* It begins planes in its own file, and on Armv7-M in one kernel. */
WRAPPED(bool, fxl_find_smooth_planes,
        (const fxl_screen_corners *corners, const fxl_lens *lens, const int32_t light[3],
         fxl_gradients *gradients, fxl_depth_plane *depth))
{
    fxl_corner_planes planes;
    counted.small_linear += fxl_corner_planes_begin(corners, lens, FXL_WORDS_SIDE_MAX, &planes);
    return __real_fxl_find_smooth_planes(corners, lens, light, gradients, depth);
}

WRAPPED_COUNT_VOID(void, fxl_find_depth_plane,
                   (const fxl_direction *normal, const fxl_axes *axes,
                    const fxl_view_point *corner, const fxl_view *view, fxl_depth_plane *plane),
                   (normal, axes, corner, view, plane), counted.depth_planes += 1)

WRAPPED(void, fxl_depth_draw_parts,
        (const fxl_renderer *renderer, fxl_workspace *workspace, const fxl_band *band))
{
    const bool is_narrow = renderer->target->depth_bits == 16;
    has_depth_buffer = true;
    compares_each = !renderer->near_first;
    cells_of_16 = is_narrow ? (const fxl_depth_head *)workspace->target_memory : NULL;
    __real_fxl_depth_draw_parts(renderer, workspace, band);
    has_depth_buffer = draws_depth_outline = draws_smooth = draws_listed = false;
    cells_of_16 = NULL;
}

WRAPPED(void, fxl_scan_outline,
        (const fxl_screen_point *points, uint32_t count, const fxl_band *band, fxl_scan *scan))
{
    const double top = band->first_row, bottom = top + band->rows;
    const bool may_be_listed = begins_listed && has_depth_buffer;
    draws_smooth = begins_smooth;
    begins_smooth = begins_listed = draws_listed = false;
    if (draws_smooth) {
        counted.smooth_outlines += 1;
        counted.smooth_edges += count;
        counted.smooth_rows += rows_between(points, count, top, bottom);
        paints_surface = keeps_less = draws_depth_outline = false;
        __real_fxl_scan_outline(points, count, band, scan);
        return;
    }
    if (paints_surface) {
        counted.painted_edges += count;
        counted.painted_rows += rows_between(points, count, top, bottom);
    }
    if (has_depth_buffer && compares_each) {
        counted.depth_each_rows += rows_between(points, count, top, bottom);
        *(keeps_less ? &counted.depth_each_unkept : &counted.depth_each) +=
            area_between(points, count, top, bottom);
    }
    draws_depth_outline = has_depth_buffer && !compares_each && !paints_surface;
    if (draws_depth_outline) {
        counted.depth_outlines += 1;
        counted.depth_outline_edges += count;
        counted.depth_outline_rows += rows_between(points, count, top, bottom);
    }
    paints_surface = keeps_less = false;
    __real_fxl_scan_outline(points, count, band, scan);
    draws_listed = may_be_listed && scan->by_chains;
    if (draws_listed) {
        counted.listed_polygons += 1;
        counted.listed_rows += rows_between(points, count, top, bottom);
    }
}

/* A run of a row whose pixels are all visible, or all hidden. */
static void count_run(double pixels, bool is_visible)
{
    if (draws_smooth) {
        *(is_visible ? &counted.smooth_kept : &counted.smooth_hidden) += pixels;
    } else if (draws_depth_outline) {
        counted.depth_outline_runs += 1;
        *(is_visible ? &counted.depth_outline_kept : &counted.depth_outline_hidden) += pixels;
    } else if (draws_listed || is_visible) { /* a surface with holes keeps no run of depths */
        counted.listed_runs += 1;
        *(is_visible ? &counted.listed_kept : &counted.listed_hidden) += pixels;
    } else {
        counted.depth_hidden_runs += 1;
        counted.depth_hidden += pixels;
    }
}

WRAPPED(uint32_t, fxl_depth_keep_visible,
        (uint16_t * cells, uint32_t count, uint32_t code, uint32_t step))
{
    const uint32_t kept = __real_fxl_depth_keep_visible(cells, count, code, step);
    count_run(kept, true);
    return kept;
}

WRAPPED(uint32_t, fxl_depth_skip_hidden,
        (const uint16_t *cells, uint32_t count, uint32_t code, uint32_t step))
{
    const uint32_t hidden = __real_fxl_depth_skip_hidden(cells, count, code, step);
    count_run(hidden, false);
    return hidden;
}

/* --- billboards ----------------------------------------------------------------------------- */

WRAPPED_COUNT_VOID(void, fxl_transform_point,
                   (const fxl_camera *camera, const fxl_point *point, fxl_view_point *view),
                   (camera, point, view), counted.points_transformed += 1)

/* fxl_billboard_row_painter, which paints nothing. */
static void count_row(fxl_billboard_row *row, const void *with)
{
    double drawn = 0;
    (void)with;
    for (uint32_t x = row->columns.first; x < row->columns.end; x++) {
        drawn += fxl_sprite_value(row->sprite, row->texels, row->along.texel, row->shift) !=
                 row->sprite->key;
        fxl_take_step(&row->along);
    }
    counted.billboard_rows += 1;
    *(has_depth_buffer    ? &counted.billboard_tested
      : row->is_repeated ? &counted.billboard_repeated
                         : &counted.billboard_texels) += row->columns.end - row->columns.first;
    *(has_depth_buffer ? &counted.billboard_compared : &counted.billboard_drawn) += drawn;
    counted.wide_billboard_drawn += is_wide ? drawn : 0;
}

static bool is_passed_over(const fxl_workspace *workspace)
{
    return has_depth_buffer &&
           ((const fxl_depth_head *)workspace->target_memory)->pass == FXL_DEPTH_BLENDED;
}

static void count_billboard(const fxl_renderer *renderer, const fxl_workspace *workspace,
                            const fxl_screen_point *points, const fxl_band *band)
{
    const fxl_rows columns = {0, band->width};
    counted.billboards += 1;
    if (!is_passed_over(workspace)) {
        fxl_billboard_walk_rows(fxl_billboard_sprite(renderer, (uint32_t)points[2].x), &points[0],
                                &points[1], band, columns, count_row, NULL);
    }
}

/* The painter of the billboards' target. */
static const fxl_sprite_painter *joined;

static void paint_joined(const fxl_renderer *renderer, fxl_workspace *workspace,
                         const fxl_screen_point *points, const fxl_band *band)
{
    count_billboard(renderer, workspace, points, band);
    joined->paint(renderer, workspace, points, band);
}

WRAPPED(fxl_status, fxl_attach_billboards,
        (fxl_renderer * renderer, fxl_billboards *billboards, const fxl_billboard_set *set,
         const fxl_sprite_painter *painter))
{
    static fxl_sprite_painter counting;
    joined = painter;
    counting = (fxl_sprite_painter){painter->target, paint_joined, painter->points};
    return __real_fxl_attach_billboards(renderer, billboards, set, &counting);
}

/* --- beams of light ------------------------------------------------------------------------- */

WRAPPED_COUNT(bool, fxl_beam_reaches,
              (const fxl_beam *beam, const fxl_point *centre, fxl_q16_16 radius),
              (beam, centre, radius), counted.instances_in_beams += 1)

WRAPPED_COUNT(fxl_q18_46, fxl_plane_distance, (const fxl_plane *plane, const fxl_point *point),
              (plane, point), counted.plane_distances += 1)

WRAPPED_COUNT(fxl_point, fxl_split_edge,
              (const fxl_point *front, const fxl_point *behind, fxl_q18_46 front_distance,
               fxl_q18_46 behind_distance),
              (front, behind, front_distance, behind_distance), counted.lit_cuts += 1)

/* For each cut, the corners that the face has so far are looked through. */
WRAPPED(bool, fxl_lit_split,
        (fxl_lit_pieces * to, const fxl_beam *beams, uint32_t beam_count,
         const fxl_direction *normal, const fxl_point *points, uint32_t count))
{
    const double cuts = counted.lit_cuts;
    const bool done = __real_fxl_lit_split(to, beams, beam_count, normal, points, count);
    counted.lit_pieces += to->piece_count;
    counted.lit_corners += to->corner_count;
    counted.lit_searched += (counted.lit_cuts - cuts) * to->corner_count;
    return done;
}

WRAPPED_COUNT_VOID(void, fxl_placement_direction,
                   (const fxl_placement *placement, const fxl_direction *direction,
                    fxl_direction *turned),
                   (placement, direction, turned), counted.turned_normals += 1)

/* --- lines and points ------------------------------------------------------------------------ */

bool draws_lines;

static const fxl_lines *attached;

/* Lines of the instances in sight from a place of their order on: each of them is looked at. */
static double lines_in_sight(const fxl_renderer *renderer, uint32_t first)
{
    double lines = 0;
    for (uint32_t i = first; i < renderer->frame.visible_count; i++) {
        const uint32_t number = renderer->frame.draw_list[i].index;
        const uint32_t *map = &attached->set.line_map[renderer->scene->instances[number].model];
        lines += map[1] - map[0];
    }
    return lines;
}

WRAPPED_COUNT(fxl_line_outcome, fxl_place_model_line,
              (const fxl_line_instance *of, const fxl_line *line, fxl_painted_line *painted),
              (of, line, painted), counted.lines_placed += 1)

WRAPPED_COUNT(bool, fxl_line_by_codes,
              (fxl_clip_line * line, const fxl_volume *volume, uint32_t *intersections),
              (line, volume, intersections), counted.lines_cut += 1)

/* The places along a line, on the average: its length along its longer side. in_band: those in the
 * rows of the band. */
static double places_of(const fxl_painted_line *line, const fxl_band *band, bool in_band)
{
    const double top = band->first_row, bottom = top + band->rows, half = line->width / 2.0;
    const double ay = line->ends[0].y / 65536.0;
    const double by = line->is_point ? ay : line->ends[1].y / 65536.0;
    const double width = fabs((line->ends[1].x - line->ends[0].x) / 65536.0), height = fabs(by - ay);
    const double rows = fmin(fmax(ay, by) + half, bottom) - fmax(fmin(ay, by) - half, top);
    const double share = rows <= 0 ? 0 : fmin(1, rows / (height + line->width));
    const double length = line->is_point ? line->width : fmax(width, height);
    return length * (in_band || line->is_point || height > width ? share : 1);
}

WRAPPED(void, fxl_paint_wide_line, (fxl_line_canvas * canvas, const fxl_painted_line *line))
{
    const double pixels = line->width * places_of(line, canvas->band, true);
    counted.lines_painted += 1;
    counted.lines_with_depth += canvas->head != NULL && line->plane_count == 0;
    counted.line_faces += line->plane_count;
    counted.line_places +=
        places_of(line, canvas->band, false) * (canvas->head != NULL ? line->width : 1);
    if (canvas->head == NULL) {
        counted.line_pixels += pixels;
    } else if (line->plane_count == 0) {
        counted.line_depth_pixels += pixels;
    } else {
        counted.line_face_pixels += pixels * line->plane_count;
    }
    __real_fxl_paint_wide_line(canvas, line);
}

/* What draws over the faces of a band. */
static void (*draw_lines_over)(const fxl_renderer *renderer, fxl_workspace *workspace,
                               const fxl_band *band);

static void draw_over(const fxl_renderer *renderer, fxl_workspace *workspace, const fxl_band *band)
{
    counted.lines += lines_in_sight(renderer, 0);
    draws_lines = true;
    draw_lines_over(renderer, workspace, band);
    draws_lines = false;
}

WRAPPED(fxl_status, fxl_attach_lines,
        (fxl_renderer * renderer, fxl_lines *lines, const fxl_line_set *set))
{
    const fxl_status status = __real_fxl_attach_lines(renderer, lines, set);
    if (status == FXL_OK && set != NULL) {
        attached = lines;
        draw_lines_over = lines->overdraw.draw_over;
        lines->overdraw.draw_over = draw_over;
    }
    return status;
}

/* Without a depth buffer lines come with the faces of their instances, and once more in a band that
 * looks at instances beside the list. */
static const fxl_order *order_of_lines;

static bool submit_with_lines(const fxl_traversal *traversal)
{
    counted.lines += lines_in_sight(traversal->renderer, traversal->resume->instances);
    return order_of_lines->submit(traversal);
}

void count_lines_in_order(fxl_renderer *renderer)
{
    static fxl_order counting;
    if (attached != NULL && renderer->target->depth_bits == 0) {
        order_of_lines = renderer->order;
        counting = *order_of_lines;
        counting.submit = submit_with_lines;
        renderer->order = &counting;
    }
}

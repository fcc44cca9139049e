/* SPDX-License-Identifier: MIT */
/* Counts of what every scene may have: instances, faces and polygons. */
#include <math.h>

#include "clip/clip_by_view.h"
#include "clip/clip_view.h"
#include "clip/intersection.h"
#include "draw/display_list.h"
#include "draw/submit.h"
#include "predict/wrapped.h"
#include "raster/draw_outline.h"
#include "raster/fill.h"
#include "raster/scan.h"
#include "scene/placement_code.h"
#include "view/model_view.h"
#include "view/order.h"
#include "view/project.h"
#include "view/placement.h"

predict_counts counted;
bool is_wide;

/* Under way is a band that looks at those faces alone of which it knows that they reach it. */
static bool passes_over;

/* --- instances and faces ------------------------------------------------------------------ */

/* Faces of an instance of which is asked whether they face the eye. */
static uint32_t faces_to_test(const fxl_model *model)
{
    return model->kind == FXL_MODEL_CONVEX && !passes_over ? model->face_count : 0;
}

WRAPPED(void, fxl_model_view_of_instance,
        (fxl_model_view * model_view, const fxl_scene *scene, const fxl_instance *instance,
         const fxl_view *view, fxl_vertex_cache *cache))
{
    counted.instances_viewed += 1;
    counted.faces_tested += faces_to_test(&scene->models[instance->model]);
    __real_fxl_model_view_of_instance(model_view, scene, instance, view, cache);
}

WRAPPED(const fxl_model *, fxl_turned_view_of_instance,
        (fxl_turned_view * turned, const fxl_scene *scene, uint32_t number, const fxl_view *view,
         fxl_vertex_cache *cache, uint32_t planes))
{
    const fxl_model *model =
        __real_fxl_turned_view_of_instance(turned, scene, number, view, cache, planes);
    counted.turned_viewed += 1;
    counted.faces_tested += faces_to_test(model);
    return model;
}

WRAPPED(bool, fxl_is_rotation, (const fxl_orientation *rows))
{
    counted.turned_checked += 1;
    return __real_fxl_is_rotation(rows);
}

WRAPPED(uint32_t, fxl_list_front_faces,
        (const fxl_scene *scene, const fxl_model *model, const fxl_point *eye,
         fxl_draw_entry *entries))
{
    counted.faces_facing += model->face_count;
    return __real_fxl_list_front_faces(scene, model, eye, entries);
}

WRAPPED(void, fxl_sort_faces, (fxl_draw_entry * entries, uint32_t count, fxl_sort_work *work))
{
    counted.faces_sorted += count;
    __real_fxl_sort_faces(entries, count, work);
}

WRAPPED(bool, fxl_extents_submit, (const fxl_traversal *traversal))
{
    counted.spilled_faces += traversal->renderer->workspace.counters.spilled;
    counted.instances_passed += traversal->renderer->frame.visible_count;
    passes_over = true;
    const bool done = __real_fxl_extents_submit(traversal);
    passes_over = false;
    return done;
}

/* --- clip ----------------------------------------------------------------------------------- */

static fxl_clip_result clip_by_view(const fxl_model_view *model_view, const fxl_face *face,
                                    fxl_clipper_work *work, fxl_screen_polygon *screen)
{
    counted.faces_clipped += 1;
    counted.corners += face->count;
    const fxl_clip_result result = fxl_clip_by_view(model_view, face, work, screen);
    counted.faces_outside += result == FXL_CLIP_OUTSIDE;
    counted.faces_between += result == FXL_CLIP_BETWEEN;
    return result;
}

WRAPPED_RECORD(fxl_clipper, fxl_clipper_view) = {.clip = clip_by_view, .by_clip_flags = true};

WRAPPED(void, fxl_transform_vertex,
        (const fxl_model_view *model_view, uint32_t number, fxl_cached_vertex *entry))
{
    counted.vertices += 1;
    __real_fxl_transform_vertex(model_view, number, entry);
}

WRAPPED(fxl_status, fxl_project_inside,
        (const fxl_projection *projection, const fxl_view_point *view, fxl_screen_point *screen))
{
    counted.projections += 1;
    return __real_fxl_project_inside(projection, view, screen);
}

WRAPPED(fxl_clip_result, fxl_clip_view_by_planes,
        (const fxl_view_polygon *in, const fxl_view_frustum *frustum, fxl_planes planes,
         fxl_clip_view_work *work, fxl_clip_stats *stats, const fxl_view_polygon **result))
{
    counted.assembled += 1;
    return __real_fxl_clip_view_by_planes(in, frustum, planes, work, stats, result);
}

WRAPPED(void, fxl_intersect_edge,
        (const fxl_view_point *from, const fxl_view_point *to, const fxl_q18_46 *from_distance,
         const fxl_q18_46 *to_distance, fxl_view_point *result))
{
    counted.cut_edges += 1;
    __real_fxl_intersect_edge(from, to, from_distance, to_distance, result);
}

/* --- display list --------------------------------------------------------------------------- */

WRAPPED(bool, fxl_display_list_append,
        (fxl_display_list * list, const fxl_screen_polygon *polygon, fxl_rows rows))
{
    counted.list_polygons += 1;
    counted.list_words += 2 + 2 * polygon->count;
    return __real_fxl_display_list_append(list, polygon, rows);
}

WRAPPED(const fxl_screen_polygon *, fxl_display_list_next,
        (const fxl_display_list *list, fxl_rows rows, uint32_t *place))
{
    const fxl_screen_polygon *found = __real_fxl_display_list_next(list, rows, place);
    counted.list_reads += found != NULL;
    counted.list_scanned += found != NULL ? 0 : list->used; /* at the end of each band's pass */
    return found;
}

/* --- raster --------------------------------------------------------------------------------- */

double area_between(const fxl_screen_point *points, uint32_t count, double top, double bottom)
{
    double twice = 0;
    for (uint32_t i = 0; i < count; i++) {
        const fxl_screen_point *a = &points[i], *b = &points[i + 1 < count ? i + 1 : 0];
        const double ay = a->y / 65536.0, by = b->y / 65536.0;
        const double ax = a->x / 65536.0, bx = b->x / 65536.0;
        const double from = fmin(fmax(ay, top), bottom), to = fmin(fmax(by, top), bottom);
        if (from != to) { /* the strip between the edge and x = 0 */
            const double slope = (bx - ax) / (by - ay);
            twice += (to - from) * (2 * ax + slope * (from + to - 2 * ay));
        }
    }
    return fabs(twice) / 2;
}

/* place fill-rule: definition: the rows that an outline has, ⌈y − 1/2⌉ */
double rows_between(const fxl_screen_point *points, uint32_t count, double top, double bottom)
{
    double first = bottom, end = top;
    for (uint32_t i = 0; i < count; i++) {
        const double row = ceil(points[i].y / 65536.0 - 0.5);
        first = fmin(first, row);
        end = fmax(end, row);
    }
    return fmax(0, fmin(end, bottom) - fmax(first, top));
}

WRAPPED(bool, fxl_draw_outline,
        (fxl_scan * scan, const fxl_screen_polygon *polygon, const fxl_band *band, uint32_t colour))
{
    const double top = band->first_row, bottom = top + band->rows;
    const double rows = rows_between(polygon->points, polygon->count, top, bottom);
    counted.polygons += 1;
    counted.edges += polygon->count;
    counted.polygons_drawn += rows > 0;
    counted.rows += rows;
    counted.pixels += area_between(polygon->points, polygon->count, top, bottom);
    return __real_fxl_draw_outline(scan, polygon, band, colour);
}

/* place pixel-format: what is counted */
/* Is under way: fxl_draw_outline_rgb565, which fills by fxl_fill_trapezoid_rgb565. */
static bool draws_outline;

WRAPPED(bool, fxl_draw_outline_rgb565,
        (fxl_scan * scan, const fxl_screen_polygon *polygon, const fxl_band *band, uint32_t colour))
{
    const double top = band->first_row, bottom = top + band->rows;
    counted.wide_polygons += 1;
    counted.wide_edges += polygon->count;
    counted.wide_outline_rows += rows_between(polygon->points, polygon->count, top, bottom);
    counted.wide_outline_pixels += area_between(polygon->points, polygon->count, top, bottom);
    draws_outline = true;
    const bool reaches_band = __real_fxl_draw_outline_rgb565(scan, polygon, band, colour);
    draws_outline = false;
    return reaches_band;
}

WRAPPED(const fxl_trapezoid *, fxl_scan_next_trapezoid, (fxl_scan * scan))
{
    *(draws_smooth          ? &counted.smooth_trapezoids
      : draws_depth_outline ? &counted.depth_outline_trapezoids
      : draws_listed        ? &counted.listed_trapezoids
                            : &counted.trapezoids) += 1;
    return __real_fxl_scan_next_trapezoid(scan);
}

WRAPPED(fxl_rows, fxl_scan_rows, (const fxl_screen_polygon *polygon, uint16_t height))
{
    counted.row_searches += 1;
    return __real_fxl_scan_rows(polygon, height);
}

WRAPPED(void, fxl_fill_band, (const fxl_band *band, uint8_t colour))
{
    counted.bands += !has_depth_buffer; /* its cells are cleared by this too */
    counted.cleared += (double)band->rows * band->width;
    __real_fxl_fill_band(band, colour);
}

/* A band that is cleared: a pixel of 16 bits takes as long as two of 8. */
WRAPPED(void, fxl_fill_trapezoid_rgb565,
        (const fxl_band *band, const fxl_trapezoid *trapezoid, uint16_t colour))
{
    if (!draws_outline) {
        counted.bands += 1;
        counted.cleared += 2.0 * band->rows * band->width;
    }
    __real_fxl_fill_trapezoid_rgb565(band, trapezoid, colour);
}

/* A row of a polygon with depth. */
WRAPPED(void, fxl_fill_row_rgb565, (uint16_t * pixel, uint16_t *end, uint16_t colour))
{
    if (!draws_depth_outline) { /* else it is a visible pixel of one */
        counted.wide_rows += 1;
        counted.wide_pixels += (double)(end - pixel);
    }
    __real_fxl_fill_row_rgb565(pixel, end, colour);
}

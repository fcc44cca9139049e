/* SPDX-License-Identifier: MIT */
/* Counts of what every scene may have: instances, faces, polygons, light and surfaces. */
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

#include "draw/surface_polygon.h"
#include "paint/corner_planes.h"
#include "paint/light_level.h"
#include "paint/light_row.h"
#include "paint/paint_divided.h"
#include "paint/rgb565_colour.h"
#include "paint/plain_rows.h"
#include "paint/texture_level.h"

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

/* --- light and surfaces --------------------------------------------------------------------- */

/* A lamp that lights a face takes a root and a division; one behind it, or out of range, none. */
static void count_lamp(const fxl_point_light *lamp, const fxl_lit_place *place)
{
    const double x = lamp->position.x - place->middle.x / 2.0;
    const double y = lamp->position.y - place->middle.y / 2.0;
    const double z = lamp->position.z - place->middle.z / 2.0;
    const double range = lamp->range;
    if (place->normal.x * x + place->normal.y * y + place->normal.z * z <= 0) {
        counted.lamps_behind += 1;
    } else if (x * x + y * y + z * z >= range * range) {
        counted.lamps_beyond += 1;
    } else {
        counted.lamps += 1;
    }
}

/* Fog takes a division between its two distances. */
static bool is_in_fog(const fxl_light_settings *settings, const fxl_camera *camera,
                      const fxl_lit_place *place)
{
    const fxl_direction *forward = &camera->axes.forward;
    const double depth = (forward->x * (place->middle.x / 2.0 - camera->position.x) +
                          forward->y * (place->middle.y / 2.0 - camera->position.y) +
                          forward->z * (place->middle.z / 2.0 - camera->position.z)) /
                         FXL_Q2_30_ONE;
    return settings->fog_far != 0 && depth > settings->fog_near && depth < settings->fog_far;
}

WRAPPED(fxl_q2_30, fxl_light_brightness,
        (const fxl_light_settings *settings, const fxl_camera *camera, const fxl_lit_place *place))
{
    counted.brightnesses += 1;
    for (uint32_t i = 0; i < settings->point_count; i++) {
        count_lamp(&settings->points[i], place);
    }
    counted.in_fog += is_in_fog(settings, camera, place);
    return __real_fxl_light_brightness(settings, camera, place);
}

WRAPPED(void, fxl_gradients_find,
        (const fxl_gradient_corners *face, const fxl_view *view, fxl_gradients *gradients))
{
    counted.surfaces_found += 1;
    counted.attributes_found += face->count;
    __real_fxl_gradients_find(face, view, gradients);
}

WRAPPED(bool, fxl_find_screen_corners,
        (const fxl_model_view *model_view, const fxl_face *face, const uint16_t *vertices,
         const fxl_traversal *traversal, fxl_screen_corners *corners))
{
    const uint32_t count = face->whole_count != 0 ? face->whole_count : face->count;
    counted.corners_on_screen += count;
    return __real_fxl_find_screen_corners(model_view, face, vertices, traversal, corners);
}

WRAPPED(bool, fxl_corner_planes_begin,
        (const fxl_screen_corners *corners, const fxl_lens *lens, fxl_corner_planes *planes))
{
    const bool is_small = __real_fxl_corner_planes_begin(corners, lens, planes);
    counted.small_faces += is_small;
    return is_small;
}

/* A small face whose weight is not constant has it as one plane more. */
WRAPPED(void, fxl_corner_planes_find,
        (fxl_corner_planes * planes, int32_t (*values)[3], uint32_t count, bool is_affine,
         fxl_gradients *gradients))
{
    __real_fxl_corner_planes_find(planes, values, count, is_affine, gradients);
    const bool is_constant = fxl_weight_is_constant(gradients);
    counted.small_surfaces += 1;
    counted.small_attributes += count;
    counted.small_weights += !is_constant;
    counted.small_divided += is_constant ? 0 : count;
}

WRAPPED(bool, fxl_surface_polygon_append,
        (fxl_display_list * list, const fxl_screen_polygon *screen, fxl_rows rows,
         const fxl_surface_polygon *polygon))
{
    const uint32_t used = list->used;
    const bool done = __real_fxl_surface_polygon_append(list, screen, rows, polygon);
    counted.surfaces_listed += 1;
    counted.list_words += list->used - used;
    return done;
}

WRAPPED(uint32_t, fxl_surface_polygon_read,
        (const fxl_screen_polygon *record, fxl_surface_polygon *polygon))
{
    counted.surfaces_read += 1;
    return __real_fxl_surface_polygon_read(record, polygon);
}

/* A surface that may leave out pixels: a depth buffer paints it twice, over two backgrounds. */
static bool has_holes(const fxl_paint *paint)
{
    return paint->opacity < 16 || (paint->level.flags & FXL_TEXTURE_KEYED) != 0;
}

WRAPPED(void, fxl_surface_paint_of,
        (const fxl_surfaces *surfaces, const fxl_surface_polygon *polygon, fxl_paint *paint))
{
    __real_fxl_surface_paint_of(surfaces, polygon, paint);
    begins_smooth = paint->is_light_linear && polygon->has_depth &&
                    polygon->depth.one == FXL_DEPTH_IS_LINEAR && !compares_each;
    counted.surfaces_painted += !begins_smooth;
    paints_surface = true;
    keeps_less = paint->blend != NULL || has_holes(paint);
}

static double sixteens(int32_t x0, int32_t x1)
{
    return (x1 + 15) / 16 - x0 / 16;
}

/* Opaque pixels that paint_pixels.c paints by a loop of their own: repeated texels of 8 bits, and
 * the face's own colour, lit. */
static bool has_loop(const fxl_paint *paint)
{
    if (paint->opacity != 16 || paint->blend != NULL) {
        return false;
    }
    return paint->level.texels == NULL
               ? paint->ramp != NULL
               : paint->level.colours == NULL && (paint->level.flags & FXL_TEXTURE_CLAMP) == 0;
}

/* The count of pixels that the kernel does not paint. */
static double *pixels_of(const fxl_paint *paint, bool linear)
{
    if (!linear) {
        return &counted.divided_pixels;
    }
    if (!has_loop(paint)) {
        return &counted.slow_pixels;
    }
    return paint->level.texels == NULL ? &counted.level_pixels : &counted.loop_pixels;
}

/* The weight at a column, as what is beside the kernel has it. */
static uint32_t weight_of(const fxl_paint *paint, const fxl_paint_row *row, int32_t x)
{
    const int64_t weight = (row->weight + paint->gradients->weight.along * x) >> 32;
    return weight < 1 ? 1 : (uint32_t)weight;
}

/* Opaque texels of RGB565 that repeat have a loop of their own. */
static bool is_repeated(const fxl_paint *paint)
{
    return paint->opacity >= 16 && paint->of_565.sixteenths == 0 && !paint->of_565.adds &&
           paint->level.flags == FXL_LEVEL_565;
}

/* Pixels of 16 bits that are painted, and what each of them takes. */
static void count_wide(const fxl_paint *paint, double pixels, bool linear)
{
    if (linear && paint->has_light_rows) {
        counted.wide_segments += 1;
        counted.wide_levels += pixels;
        return;
    }
    if (linear && is_repeated(paint)) {
        counted.wide_segments += 1;
        *(paint->of_565.part_of_level != 0 ? &counted.wide_repeated_lit : &counted.wide_repeated) +=
            pixels;
        return;
    }
    *(linear ? &counted.wide_painted : &counted.wide_divided) += pixels;
    counted.wide_segments += linear;
    counted.wide_values += pixels * paint->gradients->count;
    counted.wide_texels += paint->level.texels != NULL ? pixels : 0;
    counted.wide_lit += paint->of_565.part_of_level != 0 ? pixels : 0;
    counted.wide_blended += paint->of_565.sixteenths != 0 || paint->of_565.adds ? pixels : 0;
}

/* The pixels x0 <= x < x1 of a row, which the kernel does not paint: how often they are divided. */
static void count_slow(const fxl_paint *paint, const fxl_paint_row *row, int32_t x0, int32_t x1)
{
    if (paint->is_light_linear) {
        counted.level_rows += 1;
        *(is_wide ? &counted.wide_levels : &counted.level_pixels) += x1 - x0;
        return;
    }
    uint32_t least[3];
    fxl_find_least_weights(paint->gradients, paint->division, least);
    while (x0 < x1) {
        const int32_t first = x0 & ~15;
        const uint32_t log =
            fxl_segment_log(least, weight_of(paint, row, first), weight_of(paint, row, first + 16));
        const int32_t size = log != 0 ? 1 << log : 16, border = (x0 & -size) + size;
        const int32_t end = border < x1 ? border : x1;
        if (is_wide) {
            count_wide(paint, end - x0, log != 0);
        } else {
            counted.slow_segments += log != 0;
            *pixels_of(paint, log != 0) += end - x0;
        }
        counted.slow_attributes += log != 0 ? paint->gradients->count : 0;
        x0 = end;
    }
}

/* Within fxl_paint_pixels: the column up to which is counted, and what it was given. */
static int32_t counted_to;
static const fxl_paint *slow_paint;

/* Segments of a part of a row without light: of 16, 8 or 4 columns, or pixels that are divided; in
 * a row of constant weight 16 columns are a part of a line. */
static double kernel_segments(const fxl_segment_face *face, const fxl_paint_row *row, int32_t x0,
                              int32_t x1)
{
    double segments = 0;
    for (int32_t x = x0; x < x1; x = (x & ~15) + 16) {
        const uint32_t first = (uint32_t)x >> 4;
        const uint32_t log =
            fxl_segment_log(face->least, (uint32_t)fxl_segment_weight(face, row, first),
                            (uint32_t)fxl_segment_weight(face, row, first + 1));
        const int32_t end = (x & ~15) + 16 < x1 ? (x & ~15) + 16 : x1;
        segments += ((end - 1) >> log) - (x >> log) + 1;
    }
    return segments;
}

/* A row, or a part of one, that the kernel of plain rows paints. */
static void count_kernel(const fxl_segment_face *face, const fxl_paint_row *row, int32_t x0,
                         int32_t x1)
{
    double *lines = is_wide ? &counted.wide_line_segments : &counted.line_segments;
    double *segments = is_wide ? &counted.wide_kernel_segments : &counted.segments;
    *(is_wide ? &counted.wide_kernel_rows : &counted.segment_rows) += 1;
    *(is_wide ? &counted.wide_kernel_pixels : &counted.segment_pixels) += x1 - x0;
    if (face->is_constant) {
        *lines += sixteens(x0, x1);
    } else {
        *segments += kernel_segments(face, row, x0, x1);
    }
}

static void count_before_kernel(const fxl_paint_row *row, int32_t x0, int32_t x1)
{
    if (slow_paint != NULL) {
        count_slow(slow_paint, row, counted_to, x0);
        counted_to = x1;
    }
}

WRAPPED(void, fxl_paint_segments,
        (const fxl_segment_face *face, const fxl_paint_row *row, int32_t x0, int32_t x1))
{
    count_before_kernel(row, x0, x1);
    if (face->ramp != NULL) {
        counted.segment_rows += 1;
        counted.lit_segments += sixteens(x0, x1);
        counted.lit_segment_pixels += x1 - x0;
    } else {
        count_kernel(face, row, x0, x1);
    }
    __real_fxl_paint_segments(face, row, x0, x1);
}

WRAPPED(void, fxl_paint_segments_565,
        (const fxl_segment_face *face, const fxl_paint_row *row, int32_t x0, int32_t x1))
{
    count_before_kernel(row, x0, x1);
    count_kernel(face, row, x0, x1);
    __real_fxl_paint_segments_565(face, row, x0, x1);
}

WRAPPED(bool, fxl_paint_rows, (fxl_plain_rows * rows))
{
    fxl_plain_rows copy = *rows;
    (void)fxl_paint_rows_by(&copy, count_kernel);
    return __real_fxl_paint_rows(rows);
}

WRAPPED(bool, fxl_paint_rows_565, (fxl_plain_rows * rows))
{
    fxl_plain_rows copy = *rows;
    (void)fxl_paint_rows_by(&copy, count_kernel);
    return __real_fxl_paint_rows_565(rows);
}

WRAPPED(int32_t, fxl_paint_divided,
        (const fxl_divided_face *face, const fxl_paint_row *row, int32_t x0, int32_t x1))
{
    const int32_t end = __real_fxl_paint_divided(face, row, x0, x1);
    count_slow(slow_paint, row, counted_to, x0);
    counted_to = end;
    counted.each_rows += 1;
    counted.each_segments += end > x0 ? sixteens(x0, end) : 0;
    counted.each_pixels += end - x0;
    return end;
}

WRAPPED(void, fxl_paint_pixels,
        (const fxl_paint *paint, const fxl_paint_row *row, int32_t x0, int32_t x1))
{
    if (draws_smooth) {
        __real_fxl_paint_pixels(paint, row, x0, x1);
        return;
    }
    counted.slow_rows += !paint->is_light_linear;
    if (has_depth_buffer && has_holes(paint)) {
        counted.depth_holes += x1 - x0;
    }
    counted_to = x0;
    slow_paint = paint;
    __real_fxl_paint_pixels(paint, row, x0, x1);
    slow_paint = NULL;
    count_slow(paint, row, counted_to, x1);
}

WRAPPED(void, fxl_paint_pixels_565,
        (const fxl_paint *paint, const fxl_paint_row *row, int32_t x0, int32_t x1))
{
    if (draws_smooth) {
        __real_fxl_paint_pixels_565(paint, row, x0, x1);
        return;
    }
    counted.wide_texture_rows += !paint->is_light_linear;
    if (has_depth_buffer && has_holes(paint)) {
        counted.depth_holes += x1 - x0;
    }
    counted_to = x0;
    slow_paint = paint;
    __real_fxl_paint_pixels_565(paint, row, x0, x1);
    slow_paint = NULL;
    count_slow(paint, row, counted_to, x1);
}

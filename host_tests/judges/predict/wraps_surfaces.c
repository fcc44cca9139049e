/* SPDX-License-Identifier: MIT */
/* Counts of light, and of surfaces: those that are found, listed and read, and how their rows are
 * painted. */
#include "draw/surface_polygon.h"
#include "scene/face_bounds.h"
#include "draw/submit.h"
#include "paint/colour_run.h"
#include "paint/corner_colours.h"
#include "paint/corner_planes.h"
#include "paint/light_level.h"
#include "paint/light_row.h"
#include "paint/paint_divided.h"
#include "paint/plain_rows.h"
#include "paint/rgb565_colour.h"
#include "paint/smooth_outline.h"
#include "paint/texture_level.h"
#include "predict/counts.h"

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

WRAPPED_COUNT_VOID(void, fxl_gradients_find,
                   (const fxl_gradient_corners *face, const fxl_view *view,
                    fxl_gradients *gradients),
                   (face, view, gradients), counted.surfaces_found += 1,
                   counted.attributes_found += face->count)

WRAPPED(bool, fxl_find_screen_corners,
        (const fxl_model_view *model_view, const fxl_face *face, const fxl_corner *const of[3],
         const fxl_traversal *traversal, fxl_screen_corners *corners))
{
    counted.corners_on_screen += fxl_whole_face(traversal->renderer->scene, face).count;
    return __real_fxl_find_screen_corners(model_view, face, of, traversal, corners);
}

WRAPPED(bool, fxl_corner_planes_begin,
        (const fxl_screen_corners *corners, const fxl_lens *lens, int32_t side_max,
         fxl_corner_planes *planes))
{
    const bool is_begun = __real_fxl_corner_planes_begin(corners, lens, side_max, planes);
    counted.small_faces += is_begun && (side_max != FXL_WORDS_SIDE_MAX || !planes->is_for_words);
    return is_begun;
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

WRAPPED(bool, fxl_find_texels,
        (const fxl_corner_planes *planes, int32_t (*values)[3], uint32_t count, bool is_affine,
         fxl_gradients *gradients, fxl_depth_plane *depth))
{
    const bool is_found =
        __real_fxl_find_texels(planes, values, count, is_affine, gradients, depth);
    counted.small_surfaces += is_found;
    counted.small_attributes += is_found ? count : 0;
    return is_found;
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

WRAPPED_COUNT(uint32_t, fxl_surface_polygon_read,
              (const fxl_screen_polygon *record, fxl_surface_polygon *polygon), (record, polygon),
              counted.surfaces_read += 1)

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
                    fxl_depth_is_in_words(&polygon->depth) && !polygon->is_in_beam &&
                    !compares_each;
    counted.surfaces_painted += !begins_smooth;
    paints_surface = true;
    keeps_less = paint->blend != NULL || has_holes(paint);
    begins_listed =
        !begins_smooth && !keeps_less && polygon->has_depth && is_listed(&polygon->depth);
}

/* A triangle in words: as a smooth one, and its pixels, of which all count as visible, show texels. */
WRAPPED(bool, fxl_draw_texels,
        (const fxl_paint *paint, const fxl_depth_plane *depth, const void *memory,
         const fxl_screen_point *points, uint32_t count, const fxl_band *band, fxl_scan *scan))
{
    const double top = band->first_row, bottom = top + band->rows;
    *(paint->of_565.part_of_level != 0 ? &counted.wide_repeated_lit : &counted.wide_repeated) +=
        area_between(points, count, top, bottom);
    begins_smooth = true;
    return __real_fxl_draw_texels(paint, depth, memory, points, count, band, scan);
}

/* Whether a run of a listed polygon is painted by the kernel of runs. */
static bool is_run_of_kernel(const fxl_paint *paint, const fxl_paint_row *row)
{
    return draws_listed && row->segments != NULL &&
           (is_wide ? paint->ramp == NULL && !paint->is_evenly_lit : paint->in_beam == NULL);
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

/* place stipple: a blend: which pixels are counted as blended */
/* place pixel-format: the painters whose pixels are counted */
/* Opaque texels of RGB565 that repeat have a loop of their own. */
static bool is_repeated(const fxl_paint *paint)
{
    return paint->opacity >= 16 && paint->of_565.sixteenths == 0 && !paint->of_565.adds &&
           paint->level.flags == FXL_LEVEL_565;
}

/* Texels of a palette whose light is an attribute: a core may have a kernel for them. */
static bool has_lit_texels(const fxl_paint *paint)
{
    return paint->of_565.part_of_level != 0 && !paint->is_evenly_lit && paint->opacity == 16 &&
           paint->level.texels != NULL && paint->level.colours == NULL && paint->level.flags == 0;
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
    if (linear && has_lit_texels(paint)) {
        counted.wide_segments += 1;
        counted.wide_lit_texels += pixels;
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
    if (paint->colours != NULL) {
        return; /* fxl_paint_colours_565 counts them */
    }
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

/* --- colours at corners -------------------------------------------------------------------- */

WRAPPED(bool, fxl_find_colours,
        (const fxl_surfaces *surfaces, const fxl_corner *const mapped[3],
         const fxl_corner_planes *planes, bool is_affine, bool is_coarse,
         fxl_gradient_corners *corners, fxl_gradients *gradients))
{
    counted.wide_colours_found += corners->count != 0 ? 2 : 1; /* light takes as much again */
    return __real_fxl_find_colours(surfaces, mapped, planes, is_affine, is_coarse, corners,
                                   gradients);
}

/* The segments of a row whose weight is not constant. Pixels that are no part of a run are each
 * shown by themselves. */
WRAPPED(void, fxl_paint_colours_565,
        (const fxl_paint *paint, const fxl_paint_row *row, int32_t x0, int32_t x1))
{
    const double before = counted.wide_colour_pixels;
    counted.wide_colour_rows += 1;
    if (!fxl_has_colour_words(paint->gradients)) {
        uint32_t least[3];
        fxl_find_least_weights(paint->gradients, paint->division, least);
        for (int32_t x = x0; x < x1;) {
            const int32_t first = x & ~15;
            const uint32_t log = fxl_segment_log(least, weight_of(paint, row, first),
                                                 weight_of(paint, row, first + 16));
            const int32_t size = log != 0 ? 1 << log : 16, border = (x & -size) + size;
            counted.wide_segments += log != 0;
            counted.slow_attributes += log != 0 ? paint->gradients->count : 0;
            counted.wide_divided += log != 0 ? 0 : (border < x1 ? border : x1) - x;
            x = border;
        }
    }
    __real_fxl_paint_colours_565(paint, row, x0, x1);
    counted.wide_colour_shown += x1 - x0 - (counted.wide_colour_pixels - before);
}

WRAPPED_COUNT_VOID(void, fxl_paint_colour_run,
                   (const fxl_colour_words *words, uint16_t *pixels, uint32_t count),
                   (words, pixels, count), counted.wide_colour_runs += 1,
                   counted.wide_colour_pixels += count)

/* --- rows ---------------------------------------------------------------------------------- */

/* Within fxl_paint_pixels: the column up to which is counted, and what it was given. */
static int32_t counted_to;
static const fxl_paint *slow_paint;

/* A part of a row: segments of 16, 8 or 4 columns, and pixels that are divided; without light in a
 * row of constant weight 16 columns are a part of a line. */
static void count_kernel_segments(const fxl_segment_face *face, const fxl_paint_row *row,
                                  int32_t x0, int32_t x1)
{
    double *segments = face->ramp != NULL ? &counted.lit_segments
                       : is_wide          ? &counted.wide_kernel_segments
                                          : &counted.segments;
    double *divided = is_wide ? &counted.wide_kernel_divided : &counted.segment_divided;
    for (int32_t x = x0; x < x1; x = (x & ~15) + 16) {
        const uint32_t first = (uint32_t)x >> 4;
        const uint32_t log =
            fxl_segment_log(face->least, (uint32_t)fxl_segment_weight(face, row, first),
                            (uint32_t)fxl_segment_weight(face, row, first + 1));
        const int32_t end = (x & ~15) + 16 < x1 ? (x & ~15) + 16 : x1;
        *(log == 0 ? divided : segments) += ((end - 1) >> log) - (x >> log) + 1;
    }
}

/* Plain pixels that take as long as one of a kind of texels. */
static double weight_of_kind(const fxl_segment_face *face)
{
    static const double weights[] = {1, 2.25, 1.75, 1.8, 1.6};
    return weights[face->kind];
}

/* A row, or a part of one, that the kernel of plain rows paints. */
static void count_kernel(const fxl_segment_face *face, const fxl_paint_row *row, int32_t x0,
                         int32_t x1)
{
    double *lines = is_wide ? &counted.wide_line_segments : &counted.line_segments;
    *(draws_listed ? &counted.listed_kernel_runs
      : is_wide    ? &counted.wide_kernel_rows
                   : &counted.segment_rows) += 1;
    *(is_wide ? &counted.wide_kernel_pixels : &counted.segment_pixels) +=
        (x1 - x0) * weight_of_kind(face);
    if (face->is_constant) {
        *lines += sixteens(x0, x1);
    } else {
        count_kernel_segments(face, row, x0, x1);
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
        *(draws_listed ? &counted.listed_kernel_runs : &counted.segment_rows) += 1;
        count_kernel_segments(face, row, x0, x1);
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
    counted.wide_evenly_lit += slow_paint != NULL && slow_paint->is_evenly_lit ? x1 - x0 : 0;
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

/* The same of divided pixels. */
static double divided_weight(const fxl_divided_face *face)
{
    static const double weights[] = {1, 1.55, 1.2, 1.65, 1.4, 1.25};
    return weights[face->kind];
}

WRAPPED(int32_t, fxl_paint_divided,
        (const fxl_divided_face *face, const fxl_paint_row *row, int32_t x0, int32_t x1))
{
    const int32_t end = __real_fxl_paint_divided(face, row, x0, x1);
    count_slow(slow_paint, row, counted_to, x0);
    counted_to = end;
    counted.each_rows += 1;
    counted.each_segments += end > x0 ? sixteens(x0, end) : 0;
    counted.each_pixels += (end - x0) * divided_weight(face);
    return end;
}

WRAPPED(void, fxl_paint_pixels,
        (const fxl_paint *paint, const fxl_paint_row *row, int32_t x0, int32_t x1))
{
    if (draws_smooth) {
        __real_fxl_paint_pixels(paint, row, x0, x1);
        return;
    }
    counted.slow_rows += !paint->is_light_linear && !is_run_of_kernel(paint, row);
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
    counted.wide_texture_rows += !paint->is_light_linear && !is_run_of_kernel(paint, row);
    if (has_depth_buffer && has_holes(paint)) {
        counted.depth_holes += x1 - x0;
    }
    counted_to = x0;
    slow_paint = paint;
    __real_fxl_paint_pixels_565(paint, row, x0, x1);
    slow_paint = NULL;
    count_slow(paint, row, counted_to, x1);
}

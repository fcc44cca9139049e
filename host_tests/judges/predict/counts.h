/* SPDX-License-Identifier: MIT */
/* What is counted, and the functions that count. */
#ifndef PREDICT_COUNTS_H
#define PREDICT_COUNTS_H

#include "fixel/order.h"
#include "fixel/render.h"
#include "paint/depth_code.h"
#include "fixel/types.h"

/* What the library did in a frame: calls of its functions, and how much each was given. */

#define PREDICT_COUNTS(X) \
    X(frames) \
    X(instances) \
    X(instances_seen) \
    X(instances_viewed) \
    X(instances_passed) \
    X(turned_checked) \
    X(turned_viewed) \
    X(faces_tested) \
    X(faces_facing) \
    X(faces_sorted) \
    X(faces_clipped) \
    X(faces_outside) \
    X(faces_between) \
    X(corners) \
    X(vertices) \
    X(projections) \
    X(assembled) \
    X(cut_edges) \
    X(parallel_instances) \
    X(parallel_sorted) \
    X(parallel_vertices) \
    X(parallel_clipped) \
    X(parallel_corners) \
    X(parallel_flat) \
    X(parallel_depths) \
    X(list_polygons) \
    X(list_words) \
    X(list_reads) \
    X(list_scanned) \
    X(spilled_faces) \
    X(row_searches) \
    X(polygons) \
    X(polygons_drawn) \
    X(trapezoids) \
    X(edges) \
    X(rows) \
    X(pixels) \
    X(bands) \
    X(cleared) \
    X(horizon_searched) \
    X(horizon_rows) \
    X(horizon_changes) \
    X(lines) \
    X(lines_placed) \
    X(lines_cut) \
    X(lines_painted) \
    X(lines_with_depth) \
    X(line_faces) \
    X(line_places) \
    X(line_pixels) \
    X(line_depth_pixels) \
    X(line_face_pixels) \
    X(brightnesses) \
    X(lamps) \
    X(lamps_behind) \
    X(lamps_beyond) \
    X(in_fog) \
    X(surfaces_found) \
    X(attributes_found) \
    X(corners_on_screen) \
    X(small_faces) \
    X(small_surfaces) \
    X(small_attributes) \
    X(small_weights) \
    X(small_divided) \
    X(small_depths) \
    X(small_linear) \
    X(surfaces_listed) \
    X(surfaces_read) \
    X(surfaces_painted) \
    X(painted_edges) \
    X(painted_rows) \
    X(segment_rows) \
    X(segments) \
    X(segment_divided) \
    X(segment_pixels) \
    X(line_segments) \
    X(lit_segments) \
    X(lit_segment_pixels) \
    X(slow_rows) \
    X(slow_segments) \
    X(slow_attributes) \
    X(slow_pixels) \
    X(loop_pixels) \
    X(level_pixels) \
    X(level_rows) \
    X(divided_pixels) \
    X(each_rows) \
    X(each_segments) \
    X(each_pixels) \
    X(depth_planes) \
    X(depth_hidden_runs) \
    X(depth_hidden) \
    X(listed_polygons) \
    X(listed_trapezoids) \
    X(listed_rows) \
    X(listed_runs) \
    X(listed_kept) \
    X(listed_hidden) \
    X(listed_kernel_runs) \
    X(depth_each) \
    X(depth_each_unkept) \
    X(depth_each_rows) \
    X(depth_holes) \
    X(depth_outlines) \
    X(depth_outline_edges) \
    X(depth_outline_trapezoids) \
    X(depth_outline_rows) \
    X(depth_outline_runs) \
    X(depth_outline_kept) \
    X(depth_outline_hidden) \
    X(smooth_outlines) \
    X(smooth_edges) \
    X(smooth_trapezoids) \
    X(smooth_rows) \
    X(smooth_kept) \
    X(smooth_hidden) \
    X(points_transformed) \
    X(billboards) \
    X(billboard_rows) \
    X(billboard_texels) \
    X(billboard_repeated) \
    X(billboard_drawn) \
    X(billboard_tested) \
    X(billboard_compared) \
    X(instances_in_beams) \
    X(plane_distances) \
    X(lit_pieces) \
    X(lit_corners) \
    X(lit_cuts) \
    X(lit_searched) \
    X(turned_normals) \
    X(tree_nodes) \
    X(tree_spheres) \
    X(tree_faces) \
    X(tree_leaves) \
    X(tree_pieces) \
    X(tree_vertices) \
    X(wide_polygons) \
    X(wide_edges) \
    X(wide_outline_rows) \
    X(wide_outline_pixels) \
    X(wide_rows) \
    X(wide_pixels) \
    X(wide_texture_rows) \
    X(wide_segments) \
    X(wide_kernel_rows) \
    X(wide_kernel_segments) \
    X(wide_kernel_divided) \
    X(wide_kernel_pixels) \
    X(wide_line_segments) \
    X(wide_painted) \
    X(wide_divided) \
    X(wide_values) \
    X(wide_texels) \
    X(wide_lit) \
    X(wide_lit_texels) \
    X(wide_evenly_lit) \
    X(wide_levels) \
    X(wide_blended) \
    X(wide_repeated) \
    X(wide_repeated_lit) \
    X(wide_colours_found) \
    X(wide_colour_rows) \
    X(wide_colour_runs) \
    X(wide_colour_pixels) \
    X(wide_colour_shown) \
    X(wide_billboard_drawn)

typedef struct {
#define X(name) double name;
    PREDICT_COUNTS(X)
#undef X
} predict_counts;

/* Of the frame under way. */
extern predict_counts counted;

/* Under way is a band with a depth buffer; and a surface of which it keeps not every depth: a
 * blended one, or one with holes. */
extern bool has_depth_buffer, paints_surface, keeps_less, draws_depth_outline;

/* A smooth polygon in words, near to far, is about to be scanned; it is drawn. */
extern bool begins_smooth, draws_smooth, compares_each;

/* Lines are drawn: a model view is made for them, not for faces. */
extern bool draws_lines;

/* Of a renderer that is set up: counts its lines where they are drawn in the turn of their instances. */
void count_lines_in_order(fxl_renderer *renderer);

/* So of a surface whose runs a core with that kernel lists: depth_rows.h. */
extern bool begins_listed, draws_listed;

/* Whether one with such a plane is listed, if its scan is by chains. */
bool is_listed(const fxl_depth_plane *plane);

/* place pixel-format: what is counted */
/* The frame is of RGB565: its pixels are wide. */
extern bool is_wide;

/* The lens is orthographic. */
extern bool is_parallel;

/* The order by tree, which counts what it visits. */
extern const fxl_order counting_tree;

/* A polygon between two rows: its area in pixels, which is on the average the pixels whose centres
 * it covers; and its rows. */
double area_between(const fxl_screen_point *points, uint32_t count, double top, double bottom);
double rows_between(const fxl_screen_point *points, uint32_t count, double top, double bottom);

/* Functions that count calls of the library's functions. The linker's --wrap puts them in their
 * place for callers in other files, so nothing in the library knows of it. */

/* The declarations of a function that is wrapped, under both names. */
#define WRAPPED(result, name, parameters) \
    result __real_##name parameters; \
    result __wrap_##name parameters; \
    _Static_assert(__builtin_types_compatible_p(__typeof__(name), __typeof__(__real_##name)), \
                   #name " is declared otherwise"); \
    result __wrap_##name parameters

/* One that counts, and is then what it stands for; and one without a result. */
#define WRAPPED_COUNT(result, name, parameters, arguments, ...) \
    WRAPPED(result, name, parameters) \
    { \
        (void)(__VA_ARGS__); \
        return __real_##name arguments; \
    }
#define WRAPPED_COUNT_VOID(result, name, parameters, arguments, ...) \
    WRAPPED(result, name, parameters) \
    { \
        (void)(__VA_ARGS__); \
        __real_##name arguments; \
    }

/* A record of the library in whose place another is, for callers of a function in its own file. */
#define WRAPPED_RECORD(type, name) \
    extern const type __wrap_##name; \
    const type __wrap_##name

#endif

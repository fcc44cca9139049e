/* SPDX-License-Identifier: MIT */
/* Both sides under different names: core_ as this core's build has them, portable_ as
 * the portable C has them. sides.c is compiled once for each. equality.mk
 * renames what is not inline. */
#ifndef SIDES_H
#define SIDES_H

#include "draw/depth_plane.h"
#include "paint/corner_planes.h"
#include "draw/stages.h"
#include "paint/colour_run.h"
#include "paint/paint_divided.h"
#include "paint/plain_rows.h"
#include "paint/smooth_outline.h"
#include "raster/draw_outline.h"

#define SIDES(side) \
    uint64_t side##multiply_u32(uint32_t a, uint32_t b); \
    int64_t side##multiply_s32(int32_t a, int32_t b); \
    int64_t side##multiply_s31(int32_t a, int32_t b); \
    int64_t side##multiply_su32(int32_t a, uint32_t b); \
    uint32_t side##divide_u32(uint32_t numerator, uint32_t denominator, uint32_t *rest); \
    uint32_t side##divide_half(uint32_t numerator, uint32_t denominator); \
    int64_t side##multiply_s64(int64_t a, int64_t b); \
    int64_t side##multiply_s64_u16(int64_t a, uint32_t b); \
    uint64_t side##multiply_high(uint64_t a, uint64_t b); \
    uint32_t side##edge_height_max(void); \
    int32_t side##edge_dividend_max(void); \
    unsigned side##edge_divide(uint32_t height, int32_t dividend, int32_t *whole, \
                               uint32_t *fraction); \
    unsigned side##leading_zeros(uint32_t value); \
    bool side##dot_is_negative(const fxl_direction *direction, const fxl_point *point);

SIDES(core_)
SIDES(portable_)

uint32_t portable_divide_u64(uint64_t numerator, uint32_t denominator, uint32_t *rest);
uint32_t portable_sphere_planes(const fxl_camera *camera, const fxl_view_frustum *frustum,
                                const fxl_point *centre, fxl_q16_16 radius);
uint64_t portable_fraction(uint64_t part, uint64_t whole);
const fxl_trapezoid *portable_scan_next_trapezoid(fxl_scan *scan);
bool portable_draw_outline(fxl_scan *scan, const fxl_screen_polygon *polygon, const fxl_band *band,
                           uint32_t colour);
bool portable_draw_outline_rgb565(fxl_scan *scan, const fxl_screen_polygon *polygon,
                                  const fxl_band *band, uint32_t colour);
void portable_fill_trapezoid(const fxl_band *band, const fxl_trapezoid *trapezoid, uint8_t colour);
void portable_fill_trapezoid_rgb565(const fxl_band *band, const fxl_trapezoid *trapezoid,
                                    uint16_t colour);
void portable_transform_vertex(const fxl_model_view *placed, uint32_t number,
                               fxl_cached_vertex *entry);
fxl_clip_result portable_clip_by_view(const fxl_model_view *placed, const fxl_face *face,
                                      fxl_clipper_work *work, fxl_screen_polygon *screen);
fxl_draw_entry *portable_front_faces(const fxl_face *faces, const fxl_face_bounds *keys,
                                     const fxl_point *from, fxl_draw_entry *entry, uint32_t count,
                                     uint32_t end);
const fxl_face *portable_next_front_face(const fxl_model_view *placed, fxl_face_walk *walk);
void portable_row_to_16(const uint8_t *pixels, uint32_t count, const uint16_t *table,
                        uint16_t *out);
void portable_paint_segments(const fxl_segment_face *face, const fxl_paint_row *row, int32_t x0,
                             int32_t x1);
void portable_paint_segments_565(const fxl_segment_face *face, const fxl_paint_row *row, int32_t x0,
                                 int32_t x1);
bool portable_paint_rows(fxl_plain_rows *rows);
bool portable_paint_rows_565(fxl_plain_rows *rows);
int32_t portable_paint_divided(const fxl_divided_face *face, const fxl_paint_row *row, int32_t x0,
                               int32_t x1);
void portable_paint_pixels_565(const fxl_paint *paint, const fxl_paint_row *row, int32_t x0,
                               int32_t x1);
void portable_paint_colour_run(const fxl_colour_words *words, uint16_t *pixels, uint32_t count);
bool portable_draw_texels(const fxl_paint *paint, const fxl_depth_plane *depth, const void *memory,
                          const fxl_screen_point *points, uint32_t count, const fxl_band *band,
                          fxl_scan *scan);
uint32_t portable_depth_keep_visible(uint16_t *cells, uint32_t count, uint32_t code, uint32_t step);
uint32_t portable_depth_skip_hidden(const uint16_t *cells, uint32_t count, uint32_t code,
                                    uint32_t step);
fxl_status portable_project_inside(const fxl_projection *projection, const fxl_view_point *view,
                                   fxl_screen_point *screen);

void portable_intersect_edge(const fxl_view_point *from, const fxl_view_point *to,
                             const fxl_q18_46 *inside, const fxl_q18_46 *outside,
                             fxl_view_point *point);

void portable_placement_rows(const fxl_axes *view, const fxl_orientation *of, fxl_axes *matrix);

void portable_find_depth_plane(const fxl_direction *normal, const fxl_axes *axes,
                               const fxl_view_point *point, const fxl_view *view,
                               fxl_depth_plane *plane);

bool portable_find_smooth_planes(const fxl_screen_corners *corners, const fxl_lens *lens,
                                 const int32_t light[3], fxl_gradients *gradients,
                                 fxl_depth_plane *depth);

int32_t portable_find_texel_planes(const fxl_screen_corners *corners, const fxl_words_lens *lens,
                                   const fxl_corner *const of[3], fxl_texel_planes *planes,
                                   const int32_t *light, bool is_affine, uint32_t v_drop);

void portable_light_corners_of(const fxl_light_settings *settings, const fxl_direction *normals,
                               const fxl_corner *const corners[3], int32_t values[3]);

void portable_projection_from_lens(const fxl_lens *lens, fxl_projection *projection);

/* Stages that have a different path with FXL_SMALL. */
void portable_sort_faces(fxl_draw_entry *entries, uint32_t count, fxl_sort_work *work);
void portable_scan_outline(const fxl_screen_point *points, uint32_t count, const fxl_band *band,
                           fxl_scan *scan);
bool portable_scan_next(fxl_scan *scan, fxl_span *span);

#endif

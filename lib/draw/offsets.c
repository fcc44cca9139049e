/* SPDX-License-Identifier: MIT */
/* Asserts what offsets.h says of the records. No code. */
#include "../math/offsets.h"
#include "../view/cull.h"
#include "../view/model_view.h"
#include "../view/outcode.h"

#include "../math/family.h"
#include "../paint/colour_run.h"
#include "../paint/corner_planes.h"
#include "../paint/depth_rows.h"
#include "../paint/paint_divided.h"
#include "../paint/plain_rows.h"
#include "../paint/smooth_outline.h"
#include "fixel/render.h"

#if FXL_KERNELS_ARMV6M || FXL_KERNELS_ARMV7M

#define AT(type, member, offset) \
    FXL_STATIC_ASSERT(offsetof(type, member) == (offset), #type "." #member)
#define SIZE(type, size)   FXL_STATIC_ASSERT(sizeof(type) == (size), #type)
#define VALUE(name, value) FXL_STATIC_ASSERT((name) == (value), #name)

AT(fxl_band, pixels, BAND_PIXELS);
AT(fxl_band, width, BAND_WIDTH);
AT(fxl_band, stride, BAND_STRIDE);
AT(fxl_band, first_row, BAND_FIRST_ROW);
AT(fxl_band, rows, BAND_ROWS);
AT(fxl_band, columns, BAND_COLUMNS);

AT(fxl_edge, x, EDGE_X);
AT(fxl_edge, fraction, EDGE_FRACTION);
AT(fxl_edge, step, EDGE_STEP);
AT(fxl_edge, step_fraction, EDGE_STEP_FRACTION);
SIZE(fxl_edge, EDGE_SIZE);

AT(fxl_trapezoid, first_row, TRAPEZOID_FIRST_ROW);
AT(fxl_trapezoid, end_row, TRAPEZOID_END_ROW);
AT(fxl_trapezoid, edges, TRAPEZOID_EDGES);

AT(fxl_chain, vertex, CHAIN_VERTEX);
AT(fxl_chain, onward, CHAIN_ONWARD);
AT(fxl_chain, end_row, CHAIN_END_ROW);
SIZE(fxl_chain, CHAIN_SIZE);

AT(fxl_scan, points, SCAN_POINTS);
AT(fxl_scan, count, SCAN_COUNT);
AT(fxl_scan, by_chains, SCAN_BY_CHAINS);
AT(fxl_scan, end_row, SCAN_END_ROW);
AT(fxl_scan, chains, SCAN_CHAINS);
AT(fxl_scan, trapezoid, SCAN_TRAPEZOID);

AT(fxl_view_point, x, VIEW_POINT_X);
AT(fxl_view_point, y, VIEW_POINT_Y);
AT(fxl_view_point, z, VIEW_POINT_Z);

AT(fxl_screen_point, x, SCREEN_POINT_X);
AT(fxl_screen_point, y, SCREEN_POINT_Y);

AT(fxl_screen_polygon, colour, SCREEN_POLYGON_COLOUR);
AT(fxl_screen_polygon, count, SCREEN_POLYGON_COUNT);
AT(fxl_screen_polygon, points, SCREEN_POLYGON_POINTS);

AT(fxl_face, normal, FACE_NORMAL);
AT(fxl_face, count, FACE_COUNT);
AT(fxl_face, material, FACE_MATERIAL);
AT(fxl_face, indices, FACE_INDICES);
SIZE(fxl_face, FACE_SIZE);

AT(fxl_face_bounds, height_low, FACE_BOUNDS_HEIGHT_LOW);
AT(fxl_face_bounds, height_high, FACE_BOUNDS_HEIGHT_HIGH);
AT(fxl_face_bounds, box_x, FACE_BOUNDS_BOX_X);
AT(fxl_face_bounds, box_y, FACE_BOUNDS_BOX_Y);
AT(fxl_face_bounds, box_z, FACE_BOUNDS_BOX_Z);
SIZE(fxl_face_bounds, FACE_BOUNDS_SIZE);

AT(fxl_face_walk, face, FACE_WALK_FACE);
AT(fxl_face_walk, step, FACE_WALK_FACE + 4);
AT(fxl_face_walk, left, FACE_WALK_LEFT);
AT(fxl_face_walk, outside, FACE_WALK_OUTSIDE);
AT(fxl_face_walk, drops, FACE_WALK_DROPS);

AT(fxl_draw_entry, distance_low, ORDER_DISTANCE_LOW);
AT(fxl_draw_entry, distance_high, ORDER_DISTANCE_HIGH);
AT(fxl_draw_entry, index, ORDER_INDEX);
SIZE(fxl_draw_entry, ORDER_SIZE);

AT(fxl_cached_vertex, tag, CACHED_VERTEX_TAG);
AT(fxl_cached_vertex, clip_flags, CACHED_VERTEX_CLIP_FLAGS);
AT(fxl_cached_vertex, screen, CACHED_VERTEX_SCREEN);
AT(fxl_cached_vertex, position, CACHED_VERTEX_POSITION);
SIZE(fxl_cached_vertex, CACHED_VERTEX_SIZE);

AT(fxl_model_view, view, MODEL_VIEW_VIEW);
AT(fxl_model_view, entries, MODEL_VIEW_ENTRIES);
AT(fxl_model_view, mask, MODEL_VIEW_MASK);
AT(fxl_model_view, tag, MODEL_VIEW_TAG);
AT(fxl_model_view, vertices, MODEL_VIEW_VERTICES);
AT(fxl_model_view, indices, MODEL_VIEW_INDICES);
AT(fxl_model_view, planes, MODEL_VIEW_PLANES);
AT(fxl_model_view, axes, MODEL_VIEW_AXES);
AT(fxl_model_view, translation, MODEL_VIEW_TRANSLATION);
AT(fxl_model_view, offset, MODEL_VIEW_OFFSET);
AT(fxl_model_view, scale_vertex, MODEL_VIEW_SCALE_VERTEX);
VALUE(FXL_MODEL_VIEW_SCALED, 0x80); /* the sign of the planes' byte */
AT(fxl_view, lens.near_z, VIEW_NEAR_Z);
AT(fxl_view, projection, VIEW_PROJECTION);
AT(fxl_view, view_frustum, VIEW_FRUSTUM);

AT(fxl_view_frustum, x_side, FRUSTUM_X_SIDE);
AT(fxl_view_frustum, x_depth, FRUSTUM_X_DEPTH);
AT(fxl_view_frustum, y_side, FRUSTUM_Y_SIDE);
AT(fxl_view_frustum, y_depth, FRUSTUM_Y_DEPTH);
AT(fxl_view_frustum, x_slope, FRUSTUM_X_SLOPE);
AT(fxl_view_frustum, y_slope, FRUSTUM_Y_SLOPE);
AT(fxl_view_frustum, near_z, FRUSTUM_NEAR_Z);
AT(fxl_view_frustum, far_z, FRUSTUM_FAR_Z);
AT(fxl_view_frustum, inset, FRUSTUM_INSET);
VALUE(FRUSTUM_INSET_UPPER, FRUSTUM_INSET + 4);

AT(fxl_projection, factor, PROJECTION_FACTOR);
AT(fxl_projection, depth_min, PROJECTION_DEPTH_MIN);
AT(fxl_projection, factor_less_1, PROJECTION_FACTOR_LESS_1);
AT(fxl_projection, factor_2, PROJECTION_FACTOR_2);
AT(fxl_projection, factor_17, PROJECTION_FACTOR_17);
AT(fxl_projection, centre_x, PROJECTION_CENTRE_X);
AT(fxl_projection, centre_y, PROJECTION_CENTRE_Y);

/* place sampling: the places of members that assembly reads */
AT(fxl_segment_face, weight_step, SEGMENT_FACE_WEIGHT_STEP);
AT(fxl_segment_face, u_step, SEGMENT_FACE_U_STEP);
AT(fxl_segment_face, v_step, SEGMENT_FACE_V_STEP);
AT(fxl_segment_face, u_drop, SEGMENT_FACE_U_DROP);
AT(fxl_segment_face, v_drop, SEGMENT_FACE_V_DROP);
AT(fxl_segment_face, texels, SEGMENT_FACE_TEXELS);
AT(fxl_segment_face, rows_mask, SEGMENT_FACE_ROWS_MASK);
AT(fxl_segment_face, light_step, SEGMENT_FACE_LIGHT_STEP);
AT(fxl_segment_face, light_drop, SEGMENT_FACE_LIGHT_DROP);
AT(fxl_segment_face, ramp, SEGMENT_FACE_RAMP);
AT(fxl_segment_face, light_max, SEGMENT_FACE_LIGHT_MAX);
AT(fxl_segment_face, drop_min, SEGMENT_FACE_DROP_MIN);
AT(fxl_segment_face, least, SEGMENT_FACE_LEAST);
AT(fxl_segment_face, log_width, SEGMENT_FACE_LOG_WIDTH);
AT(fxl_segment_face, row_drop, SEGMENT_FACE_ROW_DROP);
AT(fxl_segment_face, is_constant, SEGMENT_FACE_IS_CONSTANT);
AT(fxl_segment_face, form, SEGMENT_FACE_FORM);
AT(fxl_segment_face, palette, SEGMENT_FACE_PALETTE);
AT(fxl_segment_face, in_beam, SEGMENT_FACE_IN_BEAM);
AT(fxl_segment_face, table, SEGMENT_FACE_TABLE);
AT(fxl_segment_face, kind, SEGMENT_FACE_KIND);

AT(fxl_divided_face, weight_step, DIVIDED_FACE_WEIGHT_STEP);
AT(fxl_divided_face, u_step, DIVIDED_FACE_U_STEP);
AT(fxl_divided_face, v_step, DIVIDED_FACE_V_STEP);
AT(fxl_divided_face, weight_slope, DIVIDED_FACE_WEIGHT_SLOPE);
AT(fxl_divided_face, u_slope, DIVIDED_FACE_U_SLOPE);
AT(fxl_divided_face, v_slope, DIVIDED_FACE_V_SLOPE);
AT(fxl_divided_face, texels, DIVIDED_FACE_TEXELS);
AT(fxl_divided_face, columns_mask, DIVIDED_FACE_TEXELS + 4);
AT(fxl_divided_face, rows_mask, DIVIDED_FACE_TEXELS + 8);
AT(fxl_divided_face, u_shift, DIVIDED_FACE_U_SHIFT);
AT(fxl_divided_face, v_shift, DIVIDED_FACE_V_SHIFT);
AT(fxl_divided_face, key, DIVIDED_FACE_KEY);
AT(fxl_divided_face, kind, DIVIDED_FACE_KIND);
AT(fxl_divided_face, v_drop, DIVIDED_FACE_V_DROP);

AT(fxl_paint_row, weight, PAINT_ROW_WEIGHT);
AT(fxl_paint_row, attributes[FXL_ATTRIBUTE_U], PAINT_ROW_U);
AT(fxl_paint_row, attributes[FXL_ATTRIBUTE_V], PAINT_ROW_V);
VALUE(PAINT_ROW_LIGHT, PAINT_ROW_U + 8 * FXL_SEGMENT_LIGHT + 4);
AT(fxl_paint_row, pixels, PAINT_ROW_PIXELS);
AT(fxl_paint_row, segments, PAINT_ROW_SEGMENTS);
AT(fxl_paint_row, y, PAINT_ROW_Y);

AT(fxl_plain_rows, row, 0);
AT(fxl_plain_rows, downs, PLAIN_ROWS_DOWNS);
AT(fxl_plain_rows, edges, PLAIN_ROWS_EDGES);
AT(fxl_plain_rows, end_row, PLAIN_ROWS_END);
AT(fxl_plain_rows, stride, PLAIN_ROWS_STRIDE);

AT(fxl_plain_runs, row, 0);
AT(fxl_plain_runs, downs, PLAIN_ROWS_DOWNS);
AT(fxl_plain_runs, next, PLAIN_RUNS_NEXT);
AT(fxl_plain_runs, end, PLAIN_RUNS_NEXT + 4);
AT(fxl_plain_runs, stride, PLAIN_RUNS_STRIDE);

AT(fxl_texel_run, position, TEXEL_RUN_POSITION);
AT(fxl_texel_run, step, TEXEL_RUN_STEP);
AT(fxl_texel_run, light, TEXEL_RUN_LIGHT);
AT(fxl_texel_run, light_step, TEXEL_RUN_LIGHT_STEP);

AT(fxl_screen_corners, points, 0);
AT(fxl_screen_corners, depths, SCREEN_CORNERS_DEPTHS);
AT(fxl_screen_corners, width, SCREEN_CORNERS_WIDTH);
AT(fxl_screen_corners, height, SCREEN_CORNERS_WIDTH + 4);
AT(fxl_inside_corners, least, INSIDE_CORNERS_LEAST);

AT(fxl_lens, near_z, LENS_NEAR_Z);
AT(fxl_lens, far_z, LENS_NEAR_Z + 4);

AT(fxl_depth_plane, one, DEPTH_PLANE_ONE);

AT(fxl_depth_outline, plane.gradient.at, DEPTH_OUTLINE_VALUE);
AT(fxl_depth_outline, plane.gradient.along, DEPTH_OUTLINE_ALONG);
AT(fxl_depth_outline, plane.gradient.down, DEPTH_OUTLINE_DOWN);
AT(fxl_depth_outline, plane.one, DEPTH_OUTLINE_ROW_CELL);
AT(fxl_depth_outline, zeros, DEPTH_OUTLINE_ZEROS);
AT(fxl_depth_outline, cells, DEPTH_OUTLINE_CELLS);
AT(fxl_depth_outline, one, DEPTH_OUTLINE_ONE);
AT(fxl_depth_outline, mantissa, DEPTH_OUTLINE_MANTISSA);
AT(fxl_depth_outline, rest, DEPTH_OUTLINE_REST);

AT(fxl_depth_rows, edges, 0);
AT(fxl_depth_rows, value, DEPTH_ROWS_VALUE);
AT(fxl_depth_rows, along, DEPTH_ROWS_ALONG);
AT(fxl_depth_rows, cells, DEPTH_ROWS_CELLS);
AT(fxl_depth_rows, zeros, DEPTH_ROWS_ZEROS);
AT(fxl_depth_rows, one, DEPTH_ROWS_ONE);
AT(fxl_depth_rows, mantissa, DEPTH_ROWS_MANTISSA);
AT(fxl_depth_rows, rows, DEPTH_ROWS_ROWS);
AT(fxl_depth_rows, runs, DEPTH_ROWS_RUNS);
AT(fxl_depth_rows, runs_end, DEPTH_ROWS_RUNS + 4);
AT(fxl_depth_rows, rest, DEPTH_ROWS_REST);
AT(fxl_depth_rows, resumed, DEPTH_ROWS_RESUMED);

AT(fxl_depth_head, scale.octaves, DEPTH_HEAD_OCTAVES);
AT(fxl_depth_head, scale.mantissa, DEPTH_HEAD_MANTISSA);
AT(fxl_depth_head, clear_from, DEPTH_HEAD_CLEAR_FROM);
AT(fxl_depth_head, clear_to, DEPTH_HEAD_CLEAR_TO);

AT(fxl_smooth_outline, limit, SMOOTH_OUTLINE_LIMIT);
AT(fxl_smooth_outline, words.code_along, SMOOTH_OUTLINE_CODE_ALONG);
AT(fxl_smooth_outline, words.code, SMOOTH_OUTLINE_CODE);
AT(fxl_smooth_outline, words.code_down, SMOOTH_OUTLINE_CODE_DOWN);
AT(fxl_smooth_outline, words.light_down, SMOOTH_OUTLINE_LIGHT_DOWN);
AT(fxl_smooth_outline, words.light, SMOOTH_OUTLINE_LIGHT);
AT(fxl_smooth_outline, words.light_along, SMOOTH_OUTLINE_LIGHT_ALONG);
AT(fxl_smooth_outline, by, SMOOTH_OUTLINE_BY);
AT(fxl_smooth_outline, cells, SMOOTH_OUTLINE_CELLS);
AT(fxl_smooth_outline, pixels, SMOOTH_OUTLINE_PIXELS);
AT(fxl_smooth_outline, last, SMOOTH_OUTLINE_LAST);
AT(fxl_smooth_outline, border, SMOOTH_OUTLINE_BORDER);
AT(fxl_smooth_outline, small_rows, SMOOTH_OUTLINE_SMALL_ROWS);

#if FXL_DRAWS_SMOOTH_OUTLINES
AT(fxl_lit_run, steps, LIT_RUN_STEPS);
AT(fxl_lit_run, from, LIT_RUN_FROM);
AT(fxl_lit_run, lefts, LIT_RUN_LEFTS);
AT(fxl_lit_run, begin, LIT_RUN_BEGIN);
AT(fxl_lit_run, log, LIT_RUN_BEGIN + 4);
AT(fxl_lit_run, end_of_light, LIT_RUN_END_OF_LIGHT);
AT(fxl_lit_run, columns_mask, LIT_RUN_MASKS);
AT(fxl_lit_run, rows_mask, LIT_RUN_MASKS + 4);
AT(fxl_lit_run, log_width, LIT_RUN_MASKS + 8);
AT(fxl_lit_run, texels, LIT_RUN_MASKS + 12);
AT(fxl_lit_run, palette, LIT_RUN_PALETTE);
AT(fxl_lit_run, part_of_level, LIT_RUN_PALETTE + 4);
AT(fxl_lit_run, mixture.red_dark, LIT_RUN_PALETTE + 8);
AT(fxl_lit_run, mixture.green_step, LIT_RUN_PALETTE + 20);
AT(fxl_lit_run, least, LIT_RUN_LEAST);
AT(fxl_lit_run, paint, LIT_RUN_LEAST + 4);
AT(fxl_lit_run, lowest, LIT_RUN_LOWEST);

AT(fxl_colour_face, is_lit, COLOUR_FACE_IS_LIT);
AT(fxl_colour_face, limit, COLOUR_FACE_IS_LIT + 4);
AT(fxl_colour_face, values, COLOUR_FACE_VALUES);
AT(fxl_words_lens, near_high, 0);
AT(fxl_words_lens, near_zeros, 4);
AT(fxl_words_lens, octaves, WORDS_LENS_OCTAVES);
AT(fxl_words_lens, octaves_zeros, WORDS_LENS_OCTAVES + 4);
#endif

AT(fxl_smooth_words, code_down, 8);
AT(fxl_smooth_words, light_down, SMOOTH_WORDS_LIGHT_DOWN);
AT(fxl_smooth_words, light_along, SMOOTH_WORDS_LIGHT_DOWN + 8);

AT(fxl_colour_outline, code, COLOUR_OUTLINE_CODE);
AT(fxl_colour_outline, code_down, COLOUR_OUTLINE_CODE_DOWN);
AT(fxl_colour_outline, green, COLOUR_OUTLINE_GREEN);
AT(fxl_colour_outline, green_down, COLOUR_OUTLINE_GREEN_DOWN);
AT(fxl_colour_outline, red, COLOUR_OUTLINE_RED);
AT(fxl_colour_outline, blue, COLOUR_OUTLINE_BLUE);
AT(fxl_colour_outline, red_down, COLOUR_OUTLINE_RED_DOWN);
AT(fxl_colour_outline, blue_down, COLOUR_OUTLINE_BLUE_DOWN);
AT(fxl_colour_outline, column, COLOUR_OUTLINE_COLUMN);
AT(fxl_colour_outline, code_along, COLOUR_OUTLINE_CODE_ALONG);
AT(fxl_colour_outline, step, COLOUR_OUTLINE_STEP);
AT(fxl_colour_outline, green_step, COLOUR_OUTLINE_GREEN_STEP);
AT(fxl_colour_outline, border, COLOUR_OUTLINE_BORDER);
AT(fxl_colour_outline, cells, COLOUR_OUTLINE_CELLS);

AT(fxl_corner, texel.u, CORNER_TEXEL);
AT(fxl_corner, texel.v, CORNER_TEXEL + 4);
AT(fxl_corner, normal, CORNER_NORMAL);
SIZE(fxl_direction, 12);

AT(fxl_light_settings, ambient, 0);
AT(fxl_light_settings, strength, 4);
AT(fxl_light_settings, direction, 8);
AT(fxl_light_settings, levels, LIGHT_SETTINGS_LEVELS);

AT(fxl_texel_outline, planes.at, 0);
AT(fxl_texel_outline, planes.down, TEXEL_OUTLINE_DOWN);
AT(fxl_texel_outline, planes.along, TEXEL_OUTLINE_ALONG);
AT(fxl_texel_outline, cells, TEXEL_OUTLINE_CELLS);
AT(fxl_texel_outline, pixels, TEXEL_OUTLINE_PIXELS);
AT(fxl_texel_outline, texels, TEXEL_OUTLINE_TEXELS);
AT(fxl_texel_outline, part_of_level, TEXEL_OUTLINE_PART_OF_LEVEL);
AT(fxl_texel_outline, palette, TEXEL_OUTLINE_PALETTE);
AT(fxl_texel_outline, columns_mask, TEXEL_OUTLINE_MASKS);
AT(fxl_texel_outline, rows_mask, TEXEL_OUTLINE_MASKS + 4);
AT(fxl_texel_outline, kind, TEXEL_OUTLINE_KIND);
AT(fxl_texel_outline, mixture.red_dark, TEXEL_OUTLINE_RED_DARK);
AT(fxl_texel_outline, mixture.red_step, TEXEL_OUTLINE_RED_STEP);
AT(fxl_texel_outline, mixture.green_dark, TEXEL_OUTLINE_GREEN_DARK);
AT(fxl_texel_outline, mixture.green_step, TEXEL_OUTLINE_GREEN_STEP);
AT(fxl_texel_outline, end, TEXEL_OUTLINE_END);
AT(fxl_texel_outline, border, TEXEL_OUTLINE_BORDER);

VALUE(FXL_VERTEX_UNPROJECTED, VERTEX_UNPROJECTED);
VALUE(FXL_DEPTH_NOT_DRAWN, DEPTH_NOT_DRAWN);
VALUE(FXL_DEPTH_NO_ROW, DEPTH_NO_ROW);
VALUE(FXL_DEPTH_NOT_CLEAR, DEPTH_NOT_CLEAR);
VALUE(FXL_DEPTH_FACE_IS_OTHER, DEPTH_FACE_IS_OTHER);
VALUE(FXL_DEPTH_FACE_IS_BETWEEN, DEPTH_FACE_IS_BETWEEN);
VALUE(FXL_CLIP_INSIDE, CLIP_INSIDE);
VALUE(FXL_CLIP_CUT, CLIP_CUT);
VALUE(FXL_PLANES_ALL, PLANES_ALL);
VALUE(FXL_CLIP_OUTSIDE, CLIP_OUTSIDE);
VALUE(FXL_CLIP_RANGE, CLIP_RANGE);
VALUE(FXL_CLIP_BETWEEN, CLIP_BETWEEN);

#endif

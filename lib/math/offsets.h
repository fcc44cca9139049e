/* SPDX-License-Identifier: MIT */
/* What kernels in assembly know of the records: offsets and sizes in bytes where a pointer has 32
 * bits, and values. For assembly, and for offsets.c, which asserts each. A kernel loads several
 * members at once where they stand one after the other here. */
#ifndef FXL_OFFSETS_H
#define FXL_OFFSETS_H

/* fxl_band */
#define BAND_PIXELS    0
#define BAND_WIDTH     4
#define BAND_STRIDE    6
#define BAND_FIRST_ROW 8
#define BAND_ROWS      10
#define BAND_COLUMNS   18

/* fxl_edge */
#define EDGE_X             0
#define EDGE_FRACTION      4
#define EDGE_STEP          8
#define EDGE_STEP_FRACTION 12
#define EDGE_SIZE          16

/* fxl_trapezoid */
#define TRAPEZOID_FIRST_ROW 0
#define TRAPEZOID_END_ROW   2
#define TRAPEZOID_EDGES     4

/* fxl_chain */
#define CHAIN_VERTEX  0
#define CHAIN_ONWARD  1
#define CHAIN_END_ROW 2
#define CHAIN_SIZE    4

/* fxl_scan */
#define SCAN_POINTS    0
#define SCAN_COUNT     4
#define SCAN_BY_CHAINS 5
#define SCAN_END_ROW   6
#define SCAN_CHAINS    8
#define SCAN_TRAPEZOID 20

/* fxl_view_point */
#define VIEW_POINT_X 0
#define VIEW_POINT_Y 8
#define VIEW_POINT_Z 16

/* fxl_screen_point */
#define SCREEN_POINT_X 0
#define SCREEN_POINT_Y 4

/* fxl_screen_polygon */
#define SCREEN_POLYGON_COLOUR 0
#define SCREEN_POLYGON_COUNT  1
#define SCREEN_POLYGON_POINTS 4

/* fxl_face */
#define FACE_NORMAL   0
#define FACE_COUNT    12
#define FACE_MATERIAL 13
#define FACE_INDICES  14
#define FACE_SIZE     20

/* fxl_face_bounds */
#define FACE_BOUNDS_HEIGHT_LOW  0
#define FACE_BOUNDS_HEIGHT_HIGH 4
#define FACE_BOUNDS_BOX_X       8
#define FACE_BOUNDS_BOX_Y       12
#define FACE_BOUNDS_BOX_Z       16
#define FACE_BOUNDS_SIZE        20

/* fxl_face_walk */
#define FACE_WALK_FACE    0 /* then step and left */
#define FACE_WALK_LEFT    8
#define FACE_WALK_OUTSIDE 12
#define FACE_WALK_DROPS   24

/* fxl_draw_entry */
#define ORDER_DISTANCE_LOW  0
#define ORDER_DISTANCE_HIGH 4
#define ORDER_INDEX         8
#define ORDER_SIZE          12

/* fxl_cached_vertex */
#define CACHED_VERTEX_TAG        0
#define CACHED_VERTEX_CLIP_FLAGS 4
#define CACHED_VERTEX_SCREEN     8
#define CACHED_VERTEX_POSITION   16
#define CACHED_VERTEX_SIZE       40

/* fxl_model_view */
#define MODEL_VIEW_VIEW         0
#define MODEL_VIEW_ENTRIES      4
#define MODEL_VIEW_MASK         8
#define MODEL_VIEW_TAG          12
#define MODEL_VIEW_VERTICES     16
#define MODEL_VIEW_INDICES      20
#define MODEL_VIEW_AXES         24
#define MODEL_VIEW_PLANES       28
#define MODEL_VIEW_TRANSLATION  32
#define MODEL_VIEW_OFFSET       56
#define MODEL_VIEW_SCALE_VERTEX 76

/* fxl_view */
#define VIEW_NEAR_Z     56 /* of the lens */
#define VIEW_PROJECTION 80
#define VIEW_FRUSTUM    112

/* fxl_view_frustum */
#define FRUSTUM_X_SIDE      0
#define FRUSTUM_X_DEPTH     4
#define FRUSTUM_Y_SIDE      8
#define FRUSTUM_Y_DEPTH     12
#define FRUSTUM_X_SLOPE     16
#define FRUSTUM_Y_SLOPE     20
#define FRUSTUM_NEAR_Z      24
#define FRUSTUM_FAR_Z       32
#define FRUSTUM_INSET       40
#define FRUSTUM_INSET_UPPER 44 /* the upper word of the inset */

/* fxl_projection */
#define PROJECTION_FACTOR        0
#define PROJECTION_DEPTH_MIN     4
#define PROJECTION_FACTOR_LESS_1 8
#define PROJECTION_FACTOR_2      12
#define PROJECTION_FACTOR_17     16
#define PROJECTION_CENTRE_X      20
#define PROJECTION_CENTRE_Y      24

/* fxl_segment_face */
#define SEGMENT_FACE_WEIGHT_STEP 0
#define SEGMENT_FACE_U_STEP      8
#define SEGMENT_FACE_V_STEP      16
#define SEGMENT_FACE_U_DROP      24
#define SEGMENT_FACE_V_DROP      28
#define SEGMENT_FACE_TEXELS      32
#define SEGMENT_FACE_ROWS_MASK   36
#define SEGMENT_FACE_LIGHT_STEP  40
#define SEGMENT_FACE_LIGHT_DROP  44
#define SEGMENT_FACE_RAMP        48
#define SEGMENT_FACE_LIGHT_MAX   52
#define SEGMENT_FACE_DROP_MIN    56
#define SEGMENT_FACE_LEAST       60
#define SEGMENT_FACE_LOG_WIDTH   76
#define SEGMENT_FACE_ROW_DROP    77
#define SEGMENT_FACE_IS_CONSTANT 78
#define SEGMENT_FACE_FORM        79
#define SEGMENT_FACE_PALETTE     80
#define SEGMENT_FACE_IN_BEAM     84
#define SEGMENT_FACE_TABLE       88
#define SEGMENT_FACE_KIND        92

/* place sampling: the places of members that assembly reads */
/* fxl_divided_face */
#define DIVIDED_FACE_WEIGHT_STEP  0
#define DIVIDED_FACE_U_STEP       8
#define DIVIDED_FACE_V_STEP       16
#define DIVIDED_FACE_WEIGHT_SLOPE 24
#define DIVIDED_FACE_U_SLOPE      32
#define DIVIDED_FACE_V_SLOPE      40
#define DIVIDED_FACE_TEXELS       48 /* then columns_mask and rows_mask */
#define DIVIDED_FACE_U_SHIFT      60
#define DIVIDED_FACE_V_SHIFT      64
#define DIVIDED_FACE_KEY          68 /* or the pattern, or the colours */
#define DIVIDED_FACE_KIND         72
#define DIVIDED_FACE_V_DROP       73

/* fxl_paint_row */
#define PAINT_ROW_WEIGHT   0
#define PAINT_ROW_U        8
#define PAINT_ROW_V        16
#define PAINT_ROW_LIGHT    28 /* the upper word */
#define PAINT_ROW_PIXELS   32
#define PAINT_ROW_Y        36
#define PAINT_ROW_SEGMENTS 40

/* fxl_plain_rows */
#define PLAIN_ROWS_DOWNS  48
#define PLAIN_ROWS_EDGES  72
#define PLAIN_ROWS_END    104
#define PLAIN_ROWS_STRIDE 108

/* fxl_plain_runs: the row and the downs as of fxl_plain_rows, and that of light */
#define PLAIN_RUNS_NEXT   80 /* then the end */
#define PLAIN_RUNS_STRIDE 88

/* fxl_texel_run */
#define TEXEL_RUN_POSITION   0
#define TEXEL_RUN_STEP       4
#define TEXEL_RUN_LIGHT      8
#define TEXEL_RUN_LIGHT_STEP 12

/* fxl_screen_corners: points, depths, width, height */
#define SCREEN_CORNERS_DEPTHS      24
#define SCREEN_CORNERS_WIDTH       48
#define INSIDE_CORNERS_LEAST       64

/* fxl_lens */
#define LENS_NEAR_Z 8 /* then far_z */

/* fxl_lit_run: its numbers come first */
#define LIT_RUN_STEPS        32
#define LIT_RUN_FROM         64
#define LIT_RUN_LEFTS        76
#define LIT_RUN_BEGIN        88 /* then the log */
#define LIT_RUN_END_OF_LIGHT 96
#define LIT_RUN_MASKS        100 /* then log_width and texels */
#define LIT_RUN_PALETTE      116 /* then the part of a level and the mixture */
#define LIT_RUN_LEAST        140 /* then the kernel of columns */
#define LIT_RUN_LOWEST       148

/* fxl_colour_face */
#define COLOUR_FACE_IS_LIT 60 /* then the limit */
#define COLOUR_FACE_VALUES 68

/* fxl_depth_plane */
#define DEPTH_PLANE_ONE 24

/* fxl_depth_outline */
#define DEPTH_OUTLINE_VALUE    0
#define DEPTH_OUTLINE_ALONG    8
#define DEPTH_OUTLINE_DOWN     16
#define DEPTH_OUTLINE_ROW_CELL 24
#define DEPTH_OUTLINE_ZEROS    32
#define DEPTH_OUTLINE_CELLS    48
#define DEPTH_OUTLINE_ONE      60
#define DEPTH_OUTLINE_MANTISSA 68
#define DEPTH_OUTLINE_REST     72

/* fxl_depth_rows */
#define DEPTH_ROWS_VALUE    32
#define DEPTH_ROWS_ALONG    40
#define DEPTH_ROWS_CELLS    56
#define DEPTH_ROWS_ZEROS    64
#define DEPTH_ROWS_ONE      84
#define DEPTH_ROWS_MANTISSA 92
#define DEPTH_ROWS_ROWS     96
#define DEPTH_ROWS_RUNS     100 /* then the end */
#define DEPTH_ROWS_REST     108
#define DEPTH_ROWS_RESUMED  140

/* fxl_smooth_outline */
#define DEPTH_HEAD_OCTAVES    0
#define DEPTH_HEAD_MANTISSA   1
#define DEPTH_HEAD_CLEAR_FROM 4
#define DEPTH_HEAD_CLEAR_TO   6
#define DEPTH_HEAD_SIZE       8

#define SMOOTH_OUTLINE_LIMIT       0
#define SMOOTH_OUTLINE_CODE_ALONG  4
#define SMOOTH_OUTLINE_CODE        8
#define SMOOTH_OUTLINE_CODE_DOWN   12
#define SMOOTH_OUTLINE_LIGHT_DOWN  16
#define SMOOTH_OUTLINE_LIGHT       20
#define SMOOTH_OUTLINE_LIGHT_ALONG 24
#define SMOOTH_OUTLINE_BY          28
#define SMOOTH_OUTLINE_CELLS       48
#define SMOOTH_OUTLINE_PIXELS      52
#define SMOOTH_OUTLINE_LAST        56
#define SMOOTH_OUTLINE_BORDER      60
#define SMOOTH_OUTLINE_SMALL_ROWS  64

#define SMOOTH_WORDS_LIGHT_DOWN 12

#define WORDS_LENS_OCTAVES 8 /* and their zeros; near_high and its zeros are the first */

#define COLOUR_OUTLINE_CODE       0
#define COLOUR_OUTLINE_CODE_DOWN  4
#define COLOUR_OUTLINE_GREEN      8
#define COLOUR_OUTLINE_GREEN_DOWN 12
#define COLOUR_OUTLINE_RED        16
#define COLOUR_OUTLINE_RED_DOWN   20
#define COLOUR_OUTLINE_BLUE       24
#define COLOUR_OUTLINE_BLUE_DOWN  28
#define COLOUR_OUTLINE_COLUMN     32
#define COLOUR_OUTLINE_CODE_ALONG 36
#define COLOUR_OUTLINE_STEP       44
#define COLOUR_OUTLINE_GREEN_STEP 48
#define COLOUR_OUTLINE_BORDER     52
#define COLOUR_OUTLINE_CELLS      56

/* fxl_corner */
#define CORNER_TEXEL  0
#define CORNER_NORMAL 10

/* fxl_light_settings */
#define LIGHT_SETTINGS_LEVELS 116

/* fxl_texel_outline */
#define TEXEL_OUTLINE_DOWN          16
#define TEXEL_OUTLINE_ALONG         32
#define TEXEL_OUTLINE_CELLS         48
#define TEXEL_OUTLINE_PIXELS        52
#define TEXEL_OUTLINE_TEXELS        56
#define TEXEL_OUTLINE_PART_OF_LEVEL 60
#define TEXEL_OUTLINE_PALETTE       64
#define TEXEL_OUTLINE_MASKS         68
#define TEXEL_OUTLINE_KIND          76
#define TEXEL_OUTLINE_RED_DARK      80
#define TEXEL_OUTLINE_RED_STEP      84
#define TEXEL_OUTLINE_GREEN_DARK    88
#define TEXEL_OUTLINE_GREEN_STEP    92
#define TEXEL_OUTLINE_END           96
#define TEXEL_OUTLINE_BORDER        100

/* FXL_VERTEX_UNPROJECTED, FXL_PLANES_ALL, some of fxl_depth_drawn and of fxl_clip_result */
#define PLANES_ALL         0x3F
#define VERTEX_UNPROJECTED 0x80
#define DEPTH_NOT_DRAWN    0
#define DEPTH_NO_ROW       2
#define DEPTH_NOT_CLEAR    3
#define DEPTH_FACE_IS_OTHER   0
#define DEPTH_FACE_IS_BETWEEN 3
#define CLIP_INSIDE        0
#define CLIP_CUT           1
#define CLIP_OUTSIDE       2
#define CLIP_RANGE         5
#define CLIP_BETWEEN       6

#endif

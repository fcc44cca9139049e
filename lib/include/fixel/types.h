/* SPDX-License-Identifier: MIT */
/* Number formats, ranges, statuses, and the records between the stages. */
#ifndef FXL_TYPES_H
#define FXL_TYPES_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "fixel/config.h"

/* Number formats and the ranges of every public input.
 *
 * A format stands in the name of its type: fxl_q16_16 has 16 bits before and
 * 16 after the binary point. All are two's complement. Rounding, wherever a
 * bound does not say otherwise, is to nearest with halves upward:
 * floor(x + 1/2). The reasons for the ranges stand in SPEC.md.
 */

/* A cast, an assertion of the compiler's, and an object's alignment to 8 bytes, as C and C++
 * each have them. */
#ifdef __cplusplus
#define FXL_CAST(type, value) static_cast<type>(value)
#define FXL_STATIC_ASSERT     static_assert
#define FXL_ALIGN_8           alignas(8)
#else
#define FXL_CAST(type, value) ((type)(value))
#define FXL_STATIC_ASSERT     _Static_assert
#define FXL_ALIGN_8           _Alignas(8)
#endif

typedef int32_t fxl_q16_16; /* world units, pixels, texels; unit 1/65536 */
typedef int32_t fxl_q2_30;  /* components of unit vectors, sines; unit 2^-30 */
typedef uint32_t fxl_q1_31; /* fractions 0..1 inclusive; unit 2^-31 */
typedef int64_t fxl_q18_46; /* exact products q16_16 x q2_30 and their sums */
typedef uint32_t fxl_angle; /* binary angle; a full turn is 2^32, wraps */

#define FXL_Q16_16_ONE ((fxl_q16_16)65536)
#define FXL_Q2_30_ONE  ((fxl_q2_30)1073741824)
#define FXL_Q1_31_ONE  ((fxl_q1_31)2147483648u)

/* 90 degrees. */
#define FXL_ANGLE_QUARTER ((fxl_angle)0x40000000u)

/* Constants of a program, worked out by the compiler: integer constant expressions where their
 * arguments are, without a floating-point number. Arguments are evaluated more than once.
 *
 * n world units, |n| <= 32767, exact. */
#define FXL_UNITS(n) FXL_CAST(fxl_q16_16, FXL_CAST(int32_t, n) * 65536)
/* n / d world units, to the nearest 1/65536, halves upward. Requires d > 0, |n|, d < 2^31 and
 * a result within +-32767. */
#define FXL_RATIO(n, d) \
    FXL_CAST(fxl_q16_16, \
             FXL_DIVIDE_FLOOR(131072 * FXL_CAST(int64_t, n) + (d), 2 * FXL_CAST(int64_t, d)))
/* n degrees as a binary angle, to the nearest 2^-32 turn, halves upward; |n| < 2^29. */
#define FXL_DEGREES(n) \
    FXL_CAST(fxl_angle, \
             FXL_CAST(uint64_t, FXL_DIVIDE_FLOOR(FXL_CAST(int64_t, n) * 8589934592 + 360, 720)) & \
                 0xFFFFFFFFu)
/* floor(n / d) for d > 0. */
#define FXL_DIVIDE_FLOOR(n, d) ((n) >= 0 ? (n) / (d) : -((-(n) + (d)-1) / (d)))

/* World coordinates of vertices, object centres and the eye: |c| <= 8191.
 * Then a difference of two is below 2^30 units, a sum of three products with
 * a unit vector below 2^61, and a squared distance below 2^62. */
#define FXL_COORDINATE_MAX ((fxl_q16_16)(8191 * 65536))

/* A model's vertices lie within 2 * 8191 of its origin in each coordinate, so
 * no radius need be larger than sqrt(3) * 16382 = 28374.5. */
#define FXL_RADIUS_MAX ((fxl_q16_16)(28375 * 65536))

/* Screen width and height in pixels: 1..1024. */
#define FXL_SCREEN_MAX 1024

/* Horizontal field of view: 10..150 degrees. */
#define FXL_FOV_MIN ((fxl_angle)119304648u)
#define FXL_FOV_MAX ((fxl_angle)1789569706u)

/* Near plane: 1/256 at least. Far plane: 32767 at most. Inset: 0..1. */
#define FXL_NEAR_MIN  ((fxl_q16_16)256)
#define FXL_FAR_MAX   ((fxl_q16_16)(32767 * 65536))
#define FXL_INSET_MAX FXL_Q16_16_ONE
/* The chapter's epsilon is 0.0001. None is needed: without it a vertex that the clipper made
 * lies less than 128/65536 pixel beyond the screen's border by any lens, less than 3/65536
 * by one of a usual aspect. An inset leaves a border of background where
 * focal * inset * sqrt(1 + (width / 2 focal)^2) / near is above 1/2 pixel. */
#define FXL_INSET_DEFAULT ((fxl_q16_16)0)

/* Screen coordinates that project gives and scan takes: |c| <= 4095 pixels.
 * A vertex inside the frustum lies on the screen; the rest is room for the
 * clipper's rounding at the smallest near plane. */
#define FXL_SCREEN_COORDINATE_MAX ((fxl_q16_16)(4095 * 65536))

/* Vertices of a face that this build draws: 24 where nothing was set. Each of
 * six planes adds at most one vertex to a convex polygon; the two more are for
 * polygons that rounding made slightly concave. */
#define FXL_FACE_VERTICES_MAX (FXL_POLYGON_CAPACITY - 8)

/* How far a face's vertices may lie from the plane through its first vertex
 * with its stated normal, and how far the square of that normal's length may
 * lie from 1 (in units of 2^-60). */
#define FXL_PLANARITY_MAX           ((fxl_q16_16)4)
#define FXL_NORMAL_SQUARE_MAX_ERROR ((int64_t)1 << 32)

/* What a public function answers. The world's fault is a status and changes
 * nothing; our own bug is an assertion. */

typedef enum {
    FXL_OK = 0,
    FXL_E_ARGUMENT,    /* a null pointer, or a count of zero where one is needed */
    FXL_E_RANGE,       /* a number outside its stated range */
    FXL_E_CAPACITY,    /* memory handed in, or a capacity set at build, does not suffice */
    FXL_E_DEGENERATE,  /* fewer than three vertices */
    FXL_E_ORDER,       /* a call out of order: draw before begin */
    FXL_E_ALIGNMENT,   /* image or offset not a multiple of four bytes */
    FXL_E_SIZE,        /* image shorter than it says, or longer than allowed */
    FXL_E_MAGIC,       /* not a scene image */
    FXL_E_VERSION,     /* a scene image of another version */
    FXL_E_CRC,         /* the checksum does not match */
    FXL_E_OFFSET,      /* a table that reaches outside the image */
    FXL_E_COUNT,       /* a count outside its stated range */
    FXL_E_INDEX,       /* an index past the end of the table it points into */
    FXL_E_NORMAL,      /* a face normal that is not of unit length */
    FXL_E_PLANARITY,   /* a face vertex off the plane of its face */
    FXL_E_RESERVED,    /* a reserved field or an enumeration holds an unknown value */
    FXL_E_RADIUS,      /* a vertex farther from its model's origin than the model's radius */
    FXL_E_FACE_BOUNDS, /* a face's key that is not what its vertices and its normal say */
    FXL_E_BSP,         /* nodes of a tree that do not hang together, or lie too deep */
    FXL_STATUS_COUNT
} fxl_status;

/* One clear sentence for a status, never null; unknown values included. */
const char *fxl_status_text(fxl_status status);

/* The records between the stages: the treaty that every stage signs.
 *
 *   scene -> cull -> transform -> fxl_cached_vertex -> clip -> fxl_view_polygon ->
 *   project -> fxl_screen_polygon -> list -> scan -> fxl_trapezoid -> fill ->
 *   fxl_band
 *
 * What decides by span what is seen takes from scan the same pixels as
 * fxl_span instead, and hands spans to fill.
 *
 * A face whose vertices are all inside goes from its vertices to the screen at
 * once. The chapter's clipper stands before transform instead: cull ->
 * fxl_polygon -> clip -> fxl_polygon -> transform. clipper.h is the treaty that
 * covers every way from a face to the screen.
 *
 * Axes: x right, y up, z forward, left-handed, in the world and in the view.
 * On the screen x goes right and y goes DOWN; pixel (i, j) covers
 * [i, i+1) x [j, j+1) and its centre is (i + 1/2, j + 1/2).
 */

/* A point of the world, in world units. */
typedef struct {
    fxl_q16_16 x, y, z;
} fxl_point;

/* A unit vector, or a row of a rotation. */
typedef struct {
    fxl_q2_30 x, y, z;
} fxl_direction;

/* A point is inside where normal . point >= distance; the normal points
 * inside (chapter 65, Listing 65.1). The distance is kept exact. */
typedef struct {
    fxl_direction normal;
    fxl_q18_46 distance;
} fxl_plane;

/* Where the eye is and how it is turned: yaw turns from +z towards +x, then
 * pitch raises the view towards +y, then roll turns the view's right side
 * towards its up side. */
typedef struct {
    fxl_point position;
    fxl_angle yaw, pitch, roll;
} fxl_pose;

/* The screen, and what of the world it shows; fxl_lens_from_fov makes one. */
typedef struct {
    uint16_t width, height;   /* pixels */
    fxl_q16_16 focal;         /* pixels: screen x = width/2 + focal * X / Z */
    fxl_q16_16 near_z, far_z; /* world units along forward */
    fxl_q16_16 inset;         /* every plane of the frustum moves in by this much */
} fxl_lens;

/* A vertex of a world polygon, with texture coordinates in texels,
 * |u|, |v| <= 16383. */
typedef struct {
    fxl_point position;
    fxl_q16_16 u, v;
} fxl_vertex;

/* A polygon of the world: what a clipper in the world cuts. */
typedef struct {
    uint8_t colour; /* palette index */
    uint8_t count;  /* 3..FXL_POLYGON_CAPACITY */
    bool textured;  /* else u and v mean nothing, and cost nothing */
    fxl_vertex vertices[FXL_POLYGON_CAPACITY];
} fxl_polygon;

/* A point relative to the eye, along right, up and forward, in units of 2^-46
 * world unit. Below 2^61. */
typedef struct {
    fxl_q18_46 x, y, z;
} fxl_view_point;

typedef struct {
    fxl_view_point position;
} fxl_view_vertex;

/* A polygon of the view: what a clipper in the view cuts, and hands to project. */
typedef struct {
    uint8_t colour;
    uint8_t count;
    fxl_view_vertex vertices[FXL_POLYGON_CAPACITY];
} fxl_view_polygon;

/* What a clipper makes of a polygon. */
typedef enum {
    FXL_CLIP_INSIDE,     /* wholly inside: the input is the result */
    FXL_CLIP_CUT,        /* cut: the result is in the output */
    FXL_CLIP_OUTSIDE,    /* no vertex inside */
    FXL_CLIP_DEGENERATE, /* fewer than three vertices left */
    FXL_CLIP_CAPACITY,   /* more than FXL_POLYGON_CAPACITY vertices: refused */
    FXL_CLIP_RANGE,      /* a clipper's alone: off FXL_SCREEN_COORDINATE_MAX: refused */
    FXL_CLIP_BETWEEN     /* a clipper's alone: inside, and no pixel's centre is covered */
} fxl_clip_result;

/* How a clipper goes about it, and what it counts. */
typedef struct {
    /* The sliver rule: a vertex less than this far inside a plane counts as
     * outside where the vertex before it does; 0 leaves the rule out. In the
     * unit of the plane's distances, below 2^62. Neighbours that share an edge
     * may then part by as much. */
    fxl_q18_46 sliver;
    uint32_t intersections; /* crossings worked out since the caller set it to 0 */
    uint32_t distances;     /* distances worked out by products since then, codes' included */
} fxl_clip_stats;

/* A point of the screen in pixels, y down. */
typedef struct {
    fxl_q16_16 x, y;
} fxl_screen_point;

/* What project hands to list and scan. */
typedef struct {
    uint8_t colour;
    uint8_t count;
    uint8_t kind;     /* how it is filled: FXL_POLYGON_FLAT */
    uint8_t reserved; /* 0 */
    fxl_screen_point points[FXL_POLYGON_CAPACITY];
} fxl_screen_polygon;

enum {
    FXL_POLYGON_FLAT = 0 /* one colour */
};

/* Rows first <= row < end; none where the two are equal. */
typedef struct {
    uint16_t first, end;
} fxl_rows;

/* An edge where it meets a row's line of centres, and how it goes on from row
 * to row: 32.32 numbers, of which x is the row's first pixel whose centre is
 * not left of the edge. Good for the rows of its trapezoid, and exact there. */
typedef struct {
    int32_t x;
    uint32_t fraction;
    int32_t step; /* a row */
    uint32_t step_fraction;
} fxl_edge;

/* What scan hands to fill: rows first_row .. end_row - 1 between two edges, on
 * each the pixels from the lesser x to the greater, the latter not included.
 * Which of the two is the lesser may change from row to row; both lie within
 * 0..width of the band on every row. */
typedef struct {
    int16_t first_row, end_row; /* first_row < end_row, within the band */
    fxl_edge edges[2];          /* as they are on first_row */
} fxl_trapezoid;

/* Pixels x0 <= x < x1 of row y: a trapezoid's row. Never empty, never outside
 * the band. */
typedef struct {
    int16_t y, x0, x1;
} fxl_span;

/* A strip of the frame, or the whole frame: rows first_row ..
 * first_row + rows - 1, one byte a pixel, the first pixel of row first_row at
 * pixels[0] and of the next row at pixels[stride]. The caller owns it. */
typedef struct {
    uint8_t *pixels;
    uint16_t width;  /* 1..FXL_SCREEN_MAX */
    uint16_t stride; /* >= width */
    uint16_t first_row;
    uint16_t rows; /* >= 1; first_row + rows <= screen height */
} fxl_band;

/* What became of a frame's polygons. Each polygon that came in is counted
 * once: in == backfacing + outside + degenerate + refused + drawn. */
typedef struct {
    uint32_t in;            /* faces of the scene */
    uint32_t backfacing;    /* culled: turned away from the eye */
    uint32_t outside;       /* culled: wholly outside one plane, with their object or alone */
    uint32_t degenerate;    /* culled: fewer than three vertices left */
    uint32_t refused;       /* outside the contract: too many vertices, or off range */
    uint32_t drawn;         /* reached the screen (it may still cover no pixel centre) */
    uint32_t clipped;       /* of those drawn: cut by at least one plane */
    uint32_t refused_calls; /* public calls that returned an error */
    uint32_t spilled;       /* of those drawn: not in the list, so worked out anew for every band */
    uint32_t split_bands;   /* bands or parts of bands that were drawn again in halves */
} fxl_counters;

#endif

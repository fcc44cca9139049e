/* SPDX-License-Identifier: MIT */
/* The records between the stages: the treaty that every stage signs.
 *
 *   scene -> cull -> transform -> fxl_seen_vertex -> clip -> fxl_view_polygon ->
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
#ifndef FXL_RECORD_H
#define FXL_RECORD_H

#include "fixel/format.h"

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

/* A point of the screen in pixels, y down. */
typedef struct {
    fxl_q16_16 x, y;
} fxl_screen_point;

/* What project hands to list and scan. */
typedef struct {
    uint8_t colour;
    uint8_t count;
    fxl_screen_point points[FXL_POLYGON_CAPACITY];
} fxl_screen_polygon;

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

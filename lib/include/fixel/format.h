/* SPDX-License-Identifier: MIT */
/* Number formats and the ranges of every public input.
 *
 * A format stands in the name of its type: fxl_q16_16 has 16 bits before and
 * 16 after the binary point. All are two's complement. Rounding, wherever a
 * bound does not say otherwise, is to nearest with halves upward:
 * floor(x + 1/2). The reasons for the ranges stand in SPEC.md.
 */
#ifndef FXL_FORMAT_H
#define FXL_FORMAT_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "fixel/config.h"

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

#endif

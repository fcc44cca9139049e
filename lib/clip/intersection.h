/* SPDX-License-Identifier: MIT */
/* Where an edge crosses a plane: functions that the other clippers share. Not part of the public
 * interface. */
#ifndef FXL_INTERSECTION_H
#define FXL_INTERSECTION_H

#include "../math/arith.h"
#include "fixel/half_space.h"
#include "fixel/study/normalised.h"

/* Returns floor(2^64 inside / (inside - outside)). Requires inside >= 0 > outside and a
 * difference below 2^63. Distances of points below 2^61 from one plane meet this. */
uint64_t fxl_intersection_fraction(fxl_q18_46 inside, fxl_q18_46 outside);

/* Returns from + (to - from) fraction / 2^64, rounded towards from: error less than one unit.
 * Requires both below 2^61. */
fxl_q18_46 fxl_intersection_part(fxl_q18_46 from, fxl_q18_46 to, uint64_t fraction);

/* Returns where an edge of the screen crosses a border, along the border: from + (to - from)
 * inside / (inside - outside), rounded to the nearest, halves upward. inside and outside are the
 * ends' distances from the border. Requires inside >= 0 > outside, and points within
 * FXL_SCREEN_COORDINATE_MAX: the distances, their difference and that of the coordinates are then
 * below 2^29, and the product is below 2^58. */
static inline fxl_q16_16 fxl_intersection_screen(fxl_q16_16 from, fxl_q16_16 to, fxl_q18_46 inside,
                                                 fxl_q18_46 outside)
{
    FXL_ASSERT(inside >= 0 && outside < 0);
    int64_t product = ((int64_t)to - from) * inside;
    return from + fxl_divide_round(product, (uint32_t)(inside - outside));
}

/* Interpolates a varying, rounded to the nearest: error half a unit. */
fxl_q16_16 fxl_intersection_varying(fxl_q16_16 from, fxl_q16_16 to, uint64_t fraction);

/* Computes the vertex at a fraction of the way from the inside to the outside end. The direction
 * is always this one, so both polygons that share the edge get the same bits. vertex must be
 * neither end.
 * Error: less than 1 unit of 2^-46 a coordinate, 0.51 unit of 2^-16 a varying. */
void fxl_intersection_vertex(const fxl_varying_vertex *inside, const fxl_varying_vertex *outside,
                             uint64_t fraction, uint32_t carried, fxl_varying_vertex *vertex);

/* Clips a polygon to one plane, given the distances of its vertices (Sutherland and Hodgman). A
 * vertex at distance >= 0 is inside. out is written in the cases in which
 * fxl_clip_world_to_plane writes it. Requires distances below 2^63. */
fxl_clip_result fxl_clip_polygon(const fxl_varying_polygon *in, const fxl_q18_46 *distances,
                                 fxl_clip_stats *stats, fxl_varying_polygon *out);

/* Computes the distances of a polygon's vertices from one plane of a clipper. Counts them in
 * stats if they take products. */
typedef void (*fxl_measure)(const void *planes, int plane, const fxl_varying_polygon *polygon,
                            fxl_clip_stats *stats, fxl_q18_46 *distances);

/* Clips a polygon, in order, to the planes that one of its vertices lies outside of. any and all
 * are the OR and the AND of the vertices' outcodes; at most 31 planes. *result is the input
 * itself where no plane cut it, a polygon of workspace where one did, null where nothing is
 * left. */
fxl_clip_result fxl_clip_polygon_by_planes(const fxl_varying_polygon *in, uint32_t any,
                                           uint32_t all, fxl_measure measure, const void *planes,
                                           fxl_clip_workspace *workspace,
                                           const fxl_varying_polygon **result);

/* The same for the planes of each kind of volume, where the AND of the outcodes is 0. */
fxl_clip_result fxl_clip_polygon_by_normalised(const fxl_varying_polygon *in, uint32_t any,
                                               const fxl_normalised *frustum,
                                               fxl_clip_workspace *workspace,
                                               const fxl_varying_polygon **result);
fxl_clip_result fxl_clip_polygon_by_volume(const fxl_varying_polygon *in, uint32_t any,
                                           const fxl_volume *volume, fxl_clip_workspace *workspace,
                                           const fxl_varying_polygon **result);

/* Returns a bit for each vertex that counts as inside, by its distance and the sliver rule.
 * Requires count <= 32. */
uint32_t fxl_inside_bits(const fxl_q18_46 *distances, uint32_t count, fxl_q18_46 sliver);

/* Copies a vertex with only the varyings that are used. */
void fxl_copy_vertex(const fxl_varying_vertex *from, uint32_t carried, fxl_varying_vertex *to);

#endif

/* SPDX-License-Identifier: MIT */
/* Where an edge crosses a plane, for the family of clippers. Not part of the
 * public interface. */
#ifndef FXL_INTERSECTION_H
#define FXL_INTERSECTION_H

#include "fixel/extra/clippers/half_space.h"
#include "fixel/extra/clippers/normalised.h"

/* floor(2^64 inside / (inside - outside)). Requires inside >= 0 > outside and a
 * difference below 2^63: as distances of points below 2^61 from one plane have. */
uint64_t fxl_intersection_fraction(fxl_q18_46 inside, fxl_q18_46 outside);

/* from + (to - from) fraction / 2^64 for both below 2^61, rounded towards from:
 * less than one unit. */
fxl_q18_46 fxl_intersection_part(fxl_q18_46 from, fxl_q18_46 to, uint64_t fraction);

/* The same for a number that is carried, to the nearest: half a unit. */
fxl_q16_16 fxl_intersection_varying(fxl_q16_16 from, fxl_q16_16 to, uint64_t fraction);

/* The vertex at a fraction of the way from the inside to the outside end. Always
 * in this direction, so that both owners of an edge get the same bits.
 * Error: less than 1 unit of 2^-46 a coordinate, 0.51 unit of 2^-16 a number that
 * is carried. vertex may be neither end. */
void fxl_intersection_vertex(const fxl_varying_vertex *inside, const fxl_varying_vertex *outside,
                             uint64_t fraction, uint32_t carried, fxl_varying_vertex *vertex);

/* Cuts a polygon by one plane, from its vertices' distances (Sutherland and
 * Hodgman): a vertex at distance >= 0 is inside. What is written when is what
 * fxl_clip_world_to_plane says. Requires distances below 2^63. */
fxl_clip_result fxl_clip_polygon(const fxl_varying_polygon *in, const fxl_q18_46 *distances,
                                 fxl_clip_stats *stats, fxl_varying_polygon *out);

/* A polygon's distances from one of a clipper's planes; counts them where they take
 * products. */
typedef void (*fxl_measure)(const void *planes, int plane, const fxl_varying_polygon *polygon,
                            fxl_clip_stats *stats, fxl_q18_46 *distances);

/* Cuts a polygon by the planes that any of its vertices lies outside of, in order.
 * any, all: the OR and the AND of the vertices' codes, at most 31 planes. *result
 * points to the input itself where no plane cut it, else into room; null where
 * nothing is left. */
fxl_clip_result fxl_clip_polygon_by_planes(const fxl_varying_polygon *in, uint32_t any,
                                           uint32_t all, fxl_measure measure, const void *planes,
                                           fxl_clip_workspace *workspace,
                                           const fxl_varying_polygon **result);

/* The same for planes of each kind. */
fxl_clip_result fxl_clip_polygon_by_normalised(const fxl_varying_polygon *in, uint32_t any,
                                               const fxl_normalised *frustum,
                                               fxl_clip_workspace *workspace,
                                               const fxl_varying_polygon **result);
fxl_clip_result fxl_clip_polygon_by_volume(const fxl_varying_polygon *in, uint32_t any,
                                           const fxl_volume *volume, fxl_clip_workspace *workspace,
                                           const fxl_varying_polygon **result);

/* A bit for each vertex that counts as inside, by its distance and the sliver rule.
 * Requires count <= 32. */
uint32_t fxl_inside_bits(const fxl_q18_46 *distances, uint32_t count, fxl_q18_46 sliver);

/* A vertex without the numbers that are not used. */
void fxl_copy_vertex(const fxl_varying_vertex *from, uint32_t carried, fxl_varying_vertex *to);

#endif

/* SPDX-License-Identifier: MIT */
/* Clips polygons in world space, plane by plane (Sutherland and Hodgman; Listing 65.2), in
 * 16.16. */
#ifndef FXL_CLIP_WORLD_H
#define FXL_CLIP_WORLD_H

#include "../view/outcode.h"
#include "fixel/records.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Clips a polygon to one plane. A vertex at distance >= 0 is inside. Where an edge crosses the
 * plane, the new vertex is computed from the inside end towards the outside end. So two polygons
 * that share the edge get the same vertex bit for bit. A vertex exactly on the plane is not
 * repeated. u and v of a textured polygon are cut by the same fraction as x, y and z. distances
 * receives the distance of each vertex of the input.
 * Requires 3 <= in->count <= FXL_POLYGON_CAPACITY, coordinates within FXL_COORDINATE_MAX, out !=
 * in, and room for FXL_POLYGON_CAPACITY distances. The vertices of out are written only for
 * FXL_CLIP_CUT and FXL_CLIP_DEGENERATE, and up to the capacity for FXL_CLIP_CAPACITY. Its colour
 * and count are set for FXL_CLIP_CUT.
 * Error of a new vertex: at most 0.51 unit of 1/65536 in each coordinate from a point of the
 * edge; at most (edge length) * 2^-29 + 0.9 unit from the plane; u and v: 0.51 unit + their
 * difference along the edge * 2^-30. */
fxl_clip_result fxl_clip_world_to_plane(const fxl_polygon *in, const fxl_plane *plane,
                                        fxl_polygon *out, fxl_q18_46 *distances);

/* Clips a polygon to some of the six planes, in the order of their numbers: those whose bit, 1 <<
 * FXL_PLANE_..., is set. *result is the input itself where no plane cut it, a polygon of work where
 * one did, null where nothing is left. The input may be a polygon of work; a plane that cuts it
 * then overwrites it. With FXL_PLANES_SIDES the frustum has neither near nor far; together the
 * sides keep what is behind the eye out, too. A polygon through the eye keeps a vertex there, and
 * fxl_project_point refuses that vertex. Requirements and error are those of
 * fxl_clip_world_to_plane. Source: A4. */
fxl_clip_result fxl_clip_world_to_planes(const fxl_polygon *in, const fxl_frustum *frustum,
                                         fxl_planes planes, fxl_clip_world_work *work,
                                         const fxl_polygon **result);

/* Internal: clips as fxl_clip_world_to_planes does, but tests only the planes whose bit is set in
 * planes, and those of then, too, once one has cut: rounding may have put a new vertex outside of
 * any plane. stats may be null. */
fxl_clip_result fxl_clip_world_by_planes(const fxl_polygon *in, const fxl_frustum *frustum,
                                         unsigned planes, unsigned then, fxl_clip_world_work *work,
                                         fxl_clip_stats *stats, const fxl_polygon **result);

#ifdef __cplusplus
}
#endif

#endif

/* SPDX-License-Identifier: MIT */
/* Convex volumes of six half-spaces, which are homogeneous vectors, and the records of clippers
 * whose vertices carry varyings. lib/study/half_space.h clips polygons. Source: notes on
 * homogeneous view volumes (D1, D2, D6). Internal. */
#ifndef FXL_VOLUME_H
#define FXL_VOLUME_H

#include "../math/contract.h"
#include "fixel/line.h"

#ifdef __cplusplus
extern "C" {
#endif

typedef struct {
    uint8_t colour;
    uint8_t count;   /* 3..FXL_POLYGON_CAPACITY */
    uint8_t carried; /* how many varyings of a vertex are used: 0..FXL_CARRIED_MAX */
    fxl_varying_vertex vertices[FXL_POLYGON_CAPACITY];
} fxl_varying_polygon;

/* The memory that a clipper needs beside its input. The caller owns it. Between calls only stats
 * has a meaning. */
typedef struct {
    fxl_clip_stats stats;
    fxl_varying_polygon polygons[2];
    fxl_q18_46 distances[FXL_POLYGON_CAPACITY];
} fxl_clip_workspace;

/* What fxl_half_space says, for contracts. */
#define FXL_NORMAL_PART(x) ((x) < 0 ? -(int64_t)(x) : (int64_t)(x))
#define FXL_HALF_SPACE(h) \
    (FXL_DIRECTION(&(h)->normal) && FXL_BELOW((h)->offset, ((int64_t)1 << 62) - 1) && \
     FXL_NORMAL_PART((h)->normal.x) + FXL_NORMAL_PART((h)->normal.y) + \
             FXL_NORMAL_PART((h)->normal.z) < \
         (int64_t)1 << 31)

/* How far the guard band reaches from the centre of the screen, in pixels. On any screen a
 * polygon within it stays within FXL_SCREEN_COORDINATE_MAX, whatever the rounding of the clipper
 * and the distance of the near plane. */
#define FXL_GUARD_PIXELS 3500

/* Makes the volume of a lens from its frustum and focal length. A plane whose bit is set in screen
 * (1 << FXL_PLANE_...) is exactly that of the frustum. Each other side lies at the guard band,
 * exactly: focal |X| <= FXL_GUARD_PIXELS Z. The bits of near and far must be set. */
void fxl_volume_from_sides(const fxl_view_frustum *sides, fxl_q16_16 focal, uint32_t screen,
                           fxl_volume *volume);

/* Makes the volume of an asymmetric frustum. Its window lies in the plane z = near_z. It reaches
 * from left to right and from bottom to top; zero need not lie between them. Exact.
 * FXL_E_ARGUMENT: volume is null.
 * FXL_E_RANGE: near_z is below FXL_NEAR_MIN or not below far_z, far_z is above FXL_FAR_MAX, near_z
 * or a side is beyond FXL_COORDINATE_MAX, left is not below right, or bottom is not below top.
 * With each of these statuses: *volume untouched. */
fxl_status fxl_volume_from_window(fxl_q16_16 left, fxl_q16_16 right, fxl_q16_16 bottom,
                                  fxl_q16_16 top, fxl_q16_16 near_z, fxl_q16_16 far_z,
                                  fxl_volume *volume);

/* Makes the half-space of a plane of the world. With it the same clipper, on the same integers,
 * clips polygons whose vertices are points of the world, in units of 2^-46. Requires a plane
 * made by its function. */
void fxl_half_space_from_plane(const fxl_plane *plane, fxl_half_space *half_space)
    FXL_REQUIRES(FXL_OBJECT(plane) && FXL_OBJECT(half_space))
        FXL_REQUIRES(FXL_BELOW(plane->distance, (int64_t)1 << 62)) FXL_ASSIGNS(*half_space);

/* Returns how far a point is inside: normal . (x, y, z) + offset, rounded downward to a unit of
 * 2^-46, below 2^63. The sign is always right. Requires |x|, |y|, |z| < 2^61. */
fxl_q18_46 fxl_half_space_distance(const fxl_half_space *plane, const fxl_view_point *point)
    FXL_REQUIRES(FXL_OBJECT(plane) && FXL_OBJECT(point) && FXL_HALF_SPACE(plane))
        FXL_REQUIRES(FXL_POINT_BELOW(point, ((int64_t)1 << 61) - 1)) FXL_ASSIGNS();

/* Returns the outcode of a point: bit i is set where the point lies outside plane i. Exact. */
uint32_t fxl_volume_code(const fxl_volume *volume, const fxl_view_point *point);

#ifdef __cplusplus
}
#endif

#endif

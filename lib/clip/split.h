/* SPDX-License-Identifier: MIT */
/* Where an edge of the world crosses a plane, in 16.16: for polygons that are split into a front part
 * and a back part by the BSP (A14) and the light beams (C6). */
#ifndef FXL_SPLIT_H
#define FXL_SPLIT_H

#include "../math/contract.h"
#include "fixel/types.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Computes the point where an edge crosses a plane, from the end in front (distance > 0) to the
 * end behind (distance < 0). The direction is always this one. So all polygons that share the
 * edge get the same bits, in whichever direction their outline passes the edge and on whichever
 * side they lie. Each coordinate is that of the exact intersection, rounded to the nearest unit
 * of 1/65536. A half is rounded away from the end in front; a value within 2^-25 unit of a half
 * counts as a half. These integers are the intersection from here on.
 * Requires both ends in range, and their distances from one plane (fxl_plane_distance).
 * Error: 0.5 + 2^-25 unit a coordinate from the edge, so 0.87 unit from the edge and from the
 * plane. */
fxl_point fxl_split_edge(const fxl_point *front, const fxl_point *behind, fxl_q18_46 front_distance,
                         fxl_q18_46 behind_distance)
    FXL_REQUIRES(FXL_OBJECT(front) && FXL_OBJECT(behind) && front_distance > 0 &&
                 behind_distance < 0)
        FXL_REQUIRES(front_distance<(int64_t)1 << 62 && behind_distance> - ((int64_t)1 << 62))
            FXL_REQUIRES(FXL_POINT_BELOW(front, FXL_COORDINATE_MAX) &&
                         FXL_POINT_BELOW(behind, FXL_COORDINATE_MAX)) FXL_ASSIGNS()
                FXL_ENSURES(FXL_POINT_BELOW(&FXL_RESULT, FXL_COORDINATE_MAX));

#ifdef __cplusplus
}
#endif

#endif

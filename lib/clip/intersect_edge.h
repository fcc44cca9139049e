/* SPDX-License-Identifier: MIT */
/* Where an edge crosses a plane. It is a kernel: Armv7-M has its own. Internal. */
#ifndef FXL_INTERSECT_EDGE_H
#define FXL_INTERSECT_EDGE_H

#include "fixel/types.h"

#ifdef __cplusplus
extern "C" {
#endif

/* *point = from + (to - from) fraction / 2^64, each coordinate rounded towards from, where fraction
 * is floor(2^64 inside / (inside - outside)). Error: less than one unit, and what the fraction's
 * error is of the edge's length. *inside and *outside are the distances of from and to.
 * Requires 0 < *inside and *outside < 0, both below 2^62, and coordinates whose difference is below
 * 2^62. */
void fxl_intersect_edge(const fxl_view_point *from, const fxl_view_point *to,
                        const fxl_q18_46 *inside, const fxl_q18_46 *outside, fxl_view_point *point);

#ifdef __cplusplus
}
#endif

#endif

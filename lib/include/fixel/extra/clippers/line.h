/* SPDX-License-Identifier: MIT */
/* Clipping lines to a volume, two ways. Source: notes on homogeneous view volumes (D3, D4)
 * and on a line and a plane (B1). */
#ifndef FXL_LINE_H
#define FXL_LINE_H

#include "fixel/extra/clippers/half_space.h"

#ifdef __cplusplus
extern "C" {
#endif

/* From one point of the view to another; what rides along is cut with them. */
typedef struct {
    fxl_varying_vertex from, to;
    uint8_t carried;
} fxl_clip_line;

/* Moves the ends of a line inside, plane by plane in their order; an end that is
 * inside stays as it is, bit for bit. False where nothing is left; the line may
 * then have been moved. Requires coordinates below 2^61. *intersections grows by
 * those worked out.
 * Error of a moved end: 1 unit of 2^-46 a coordinate from the line, and half a unit
 * of 2^-16 a number carried, for each plane that moved it; 3 units from the plane
 * that moved it last. A line that passes a corner of the volume by less, or
 * lies in a plane by less, may be taken either way. */
bool fxl_line_by_planes(fxl_clip_line *line, const fxl_volume *volume, uint32_t *intersections);

/* The same by outcodes: a line with both ends outside of one plane is left out,
 * one with both inside of all is left alone, otherwise an end is moved to a plane
 * that it lies outside of, until one or the other holds. Fewer distances, and no
 * more intersections. */
bool fxl_line_by_codes(fxl_clip_line *line, const fxl_volume *volume, uint32_t *intersections);

#ifdef __cplusplus
}
#endif

#endif

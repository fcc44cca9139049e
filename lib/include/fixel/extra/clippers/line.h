/* SPDX-License-Identifier: MIT */
/* Clips lines to a volume, in two ways. Source: notes on homogeneous view volumes (D3, D4) and
 * on a line and a plane (B1). */
#ifndef FXL_LINE_H
#define FXL_LINE_H

#include "fixel/extra/clippers/half_space.h"

/* A line between two points of the view. Its varyings are cut with it. */
typedef struct {
    fxl_varying_vertex from, to;
    uint8_t carried;
} fxl_clip_line;

/* Clips a line plane by plane, in the order of the planes: moves an end that is outside onto the
 * plane. An end that is inside keeps its bits. Returns false where nothing is left; the line may
 * then have been changed. Adds the number of intersections computed to *intersections. Requires
 * coordinates below 2^61.
 * Error of a moved end, for each plane that moved it: 1 unit of 2^-46 a coordinate from the
 * line, and half a unit of 2^-16 a varying. It lies within 3 units of the plane that moved it
 * last. A line that passes a corner of the volume by less than this, or lies in a plane to
 * within this, may be kept or rejected. */
bool fxl_line_by_planes(fxl_clip_line *line, const fxl_volume *volume, uint32_t *intersections);

/* Clips a line by outcodes. A line with both ends outside one plane is rejected. A line with
 * both ends inside all planes stays as it is. Otherwise one end is moved onto a plane that it
 * lies outside of, and both tests are repeated. Computes fewer distances than
 * fxl_line_by_planes, and no more intersections. Requirements, result and error are those of
 * fxl_line_by_planes. */
bool fxl_line_by_codes(fxl_clip_line *line, const fxl_volume *volume, uint32_t *intersections);

#endif

/* SPDX-License-Identifier: MIT */
/* Why a pixel may differ from the twin's (SPEC.md 10). */
#ifndef JUDGE_EXPLAIN_H
#define JUDGE_EXPLAIN_H

#include "reference/render.h"

/* Bounds of a polygon's outline, in pixels. */
typedef struct {
    double left, right, top, bottom;
} judge_box;

judge_box judge_box_of(const ref_screen_polygon *polygon);

/* Bounds of all that may be drawn of a polygon. */
judge_box judge_box_of_drawn(const ref_drawn *drawn);

/* The distance in pixels from a point to the nearest edge of an outline. */
double judge_edge_distance(const ref_screen_polygon *polygon, double x, double y);

/* The smallest d at which the twin's drawing order, with every polygon that
 * has an edge within d of (cx, cy) put in or out at will, gives a colour
 * there; infinite where no choice does. boxes holds each polygon's bounds.
 *
 * A choice that shows polygon i puts i in (free where it is in, else its
 * edge's distance) and every later polygon that is in out (each at its edge's
 * distance); it costs the largest of these. Earlier polygons do not matter,
 * and later ones that are out stay out. The background is a polygon before
 * the first that is always in.
 *
 * doubt: what near and far leave of a polygon may be anything from its least to its most
 * (SPEC.md 10). Then it is in for nothing where its most is, else at the distance of an edge
 * of its most; it is out for nothing where its least is out, else at the distance of an edge
 * of its least. */
double judge_explain(const ref_drawn *drawn, const judge_box *boxes, size_t count,
                     uint8_t background, double cx, double cy, uint8_t colour, bool doubt);

#endif

/* SPDX-License-Identifier: MIT */
/* A clipper that asks another, and measures what that answers against the exact outline. */
#ifndef COMPARISON_SPY_H
#define COMPARISON_SPY_H

#include "draw/stages.h"
#include "fixel/all.h"

/* What of a polygon reaches the scan. */
typedef enum {
    SIDES_LENS,   /* cut to the planes of the lens */
    SIDES_BORDER, /* near and far as they are, the sides to the screen's borders, without inset */
    SIDES_LEFT,   /* left as it is, the other sides to the guard band */
    SIDES_GUARD   /* all sides to the guard band */
} spy_sides;

typedef struct {
    uint64_t faces, inside, cut, outside, degenerate, refused;
    uint64_t between;  /* inside, and not handed on, since no pixel's centre is covered */
    uint64_t crossing; /* faces that the planes of the lens cut, and that are seen; by double */
    uint64_t pieces;   /* polygons that the faces inside and cut gave */
    uint64_t missed;   /* faces of which something is seen where the clipper says nothing, or the
                        * other way round: more than 2/65536 pixel of it */
    double error;      /* largest distance of outlines, in 1/65536 pixel, where no plane that
                        * cuts is nearly parallel to the face (docs/accuracy.md, section 3) */
    double error_at_all;
    uint64_t beyond; /* outlines of error that are more than 1.25 apart */
    int vertices;    /* the most of a polygon on the screen */
    double screen;   /* the farthest from the screen's middle, in pixels, along x or y */
    double view;     /* the largest coordinate of a vertex in the view that came in, in units */
    uint64_t intersections, distances; /* worked out, of those that count them in their room */
} spy_findings;

/* Puts the spy before the clipper of a renderer, with room of its own, so that every clipper
 * that can counts in it. One renderer at a time; false where that does not suit it. */
bool spy_begin(fxl_renderer *renderer, spy_sides sides);

/* It stands there, or the clipper itself does. What fills a list may leave a face half way,
 * to take it up anew: that is not to be watched. */
void spy_watch(fxl_renderer *renderer, bool watching);

/* Call it when all is drawn. */
const spy_findings *spy_end(void);

#endif

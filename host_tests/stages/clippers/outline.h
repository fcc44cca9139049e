/* SPDX-License-Identifier: MIT */
/* How far apart two outlines on the screen are. */
#ifndef CLIPPERS_OUTLINE_H
#define CLIPPERS_OUTLINE_H

#include "draw/stages.h"
#include "fixel/all.h"
#include "reference/clip.h"

enum {
    OUTLINE_MAX = REF_VOLUME_CAPACITY
};

/* In pixels. */
typedef struct {
    int count;
    long double x[OUTLINE_MAX], y[OUTLINE_MAX];
} outline;

outline outline_of_screen(const fxl_screen_point *points, int count);

/* x = centre + x_factor X / Z, y = centre - y_factor Y / Z. */
outline outline_of_volume(const ref_volume_polygon *polygon, double half_width, double half_height,
                          double x_factor, double y_factor);

/* The largest distance of a vertex of the one from the other's outline, both ways,
 * in units of 1/65536 pixel. */
double outline_distance(const outline *a, const outline *b);

/* How far a point lies beyond the worst of a convex outline's edges, prolonged; in
 * units. At the tip of a wedge that is less than to the outline. */
double outline_beyond(const outline *of, long double x, long double y);

/* In pixels. */
double outline_length(const outline *of);

/* In square pixels; negative where it goes the other way round. */
double outline_area(const outline *of);

#endif

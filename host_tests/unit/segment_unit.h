/* SPDX-License-Identifier: MIT */
/* A row of a textured face whose numbers a test chooses, and what a kernel paints of it. */
#ifndef SEGMENT_UNIT_H
#define SEGMENT_UNIT_H

#include <math.h>
#include <string.h>

#include "paint/segments.h"
#include "unity.h"

enum {
    SEGMENT_COLUMNS = 128,
    SEGMENT_TEXELS = 1024,
    SEGMENT_LEVELS = 3,
    SEGMENT_UNTOUCHED = 255
};

typedef struct {
    uint8_t texels[SEGMENT_TEXELS], ramp[256 * SEGMENT_LEVELS];
    uint8_t pixels[SEGMENT_COLUMNS], part[SEGMENT_COLUMNS];
    fxl_gradients gradients;
    fxl_paint paint;
    fxl_paint_row row;
    fxl_segment_face face;
    uint32_t state; /* of the random numbers */
} segment_row;

extern segment_row segment; /* there is one */

/* An opaque face with these texels and no light; random numbers begin anew. */
void segment_begin(void);

uint32_t segment_any(void);
void segment_choose_size(uint32_t log_width, uint32_t log_height);

/* A gradient from one value to another over the columns; the row's value is the first. */
void segment_choose_gradient(fxl_gradient *gradient, int64_t *at, double from, double to);

/* Has the kernel take segments of 2^log columns; 0: divide each pixel. */
void segment_choose_log(uint32_t log);

/* A face whose weights are from 2^26 to 2^30, and whose coordinates are within 200 texels. */
void segment_choose_face(void);

double segment_exact(const fxl_gradient *gradient, int column);

/* An attribute at the end of a segment: texels, or levels. */
double segment_divided(uint32_t attribute, int column);

/* On the line between both ends of a pixel's segment of so many columns. */
double segment_on_line(uint32_t attribute, int x, int columns);

/* How far a coordinate is outside of texel n of 2^log, which repeats; below 0: it is inside. */
double segment_distance(double coordinate, uint32_t n, uint32_t log);

/* The kernel's pixels x0 <= x < x1; others are untouched. */
void segment_paint_row(uint8_t *pixels, int32_t x0, int32_t x1);

#endif

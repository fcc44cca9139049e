/* SPDX-License-Identifier: MIT */
/* The same stages by three designs, for comparison. Each starts from the same
 * integers and ends in numbers of the same units.
 *
 *   naive    everything in 16.16, every product and quotient truncated, the
 *            chapter's steps as they stand: its matrix is the 2.30 one cut to
 *            16.16, its projection multiplies by 1/z, its edges step by a slope
 *   fixel    the library, by its public functions
 *   float32  the chapter's steps in single precision
 *
 * What would wrap in 16.16 or is not finite counts as the end of 16.16: kinder
 * to both than what a microcontroller would show. */
#ifndef DESIGNS_DESIGN_H
#define DESIGNS_DESIGN_H

#include "designs/input.h"
#include "oracle/depth.h"
#include "oracle/surface_sample.h"

/* A screen position in units of 1/65536 pixel. */
typedef struct {
    double x, y;
} designs_screen;

/* A screen, one byte a pixel, 1 where an outline covers it. */
typedef struct {
    uint8_t *pixels;
    int width, height;
} designs_bitmap;

/* A triangle with a surface, and one pixel of it. */
typedef struct {
    surface_sample sample;
    fxl_direction normals[3];
    fxl_light_settings light; /* its levels are SURFACE_LEVELS */
} designs_surface;

enum {
    DESIGNS_TEXEL_LOG = 7 /* of the texture's side */
};

typedef struct {
    const char *name;
    /* right, up and forward of a pose, in units of 2^-30 */
    void (*matrix)(const fxl_pose *pose, double entries[9]);
    /* where an unclipped vertex comes to lie */
    designs_screen (*vertex)(const designs_input *input);
    /* where the edge points[0]..points[1], clipped to the plane, then ends */
    designs_screen (*clip)(const designs_input *input);
    /* the bitmap is clear before */
    void (*fill)(const fxl_screen_polygon *outline, const designs_bitmap *bitmap);
    /* the column of the texture that the pixel shows; FXL_DIVIDE_16 and so on */
    int (*texel)(designs_surface *face, uint8_t division);
    /* the level of light that the pixel shows */
    int (*level)(designs_surface *face);
    /* which of two faces the pixel shows, drawn in turn with a depth buffer of 16 or, where wide,
     * 32 bits */
    int (*nearer)(const depth_sample *faces, bool wide);
} designs_design;

extern const designs_design designs_naive, designs_fixel, designs_float32;

#endif

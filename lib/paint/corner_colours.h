/* SPDX-License-Identifier: MIT */
/* Colours at the corners of a face: FXL_SURFACE_COLOURS. Red, green and blue take the places of the
 * attributes u, v and light.
 *
 * A channel of a pixel of 16 bits is the upper 5 or 6 bits of one of 8 bits, as in a palette of
 * RGB565. So an attribute is a channel of 8 bits and a half, in levels of the pixel's channel:
 * 16.16. A pixel shows the level below. Internal. */
#ifndef FXL_CORNER_COLOURS_H
#define FXL_CORNER_COLOURS_H

#include "../raster/scan.h"
#include "corner_planes.h"
#include "depth_outline.h"
#include "paint.h"
#include "plain_rows.h"

#ifdef __cplusplus
extern "C" {
#endif

/* The attributes at the corners of a face whose surface is FXL_SURFACE_COLOURS: from 1/16 to 31 15/16, and
 * green from 1/8 to 63 7/8. */
void fxl_corner_colours(const fxl_corner *const corners[3], int32_t (*values)[3]);

/* What light leaves of them. light: at the corners, in 16.16 levels of the settings, and a half.
 * With part = (light - 1/2) / (levels - 1) and the middle of the level that `dark` has, a value
 * becomes middle + (value - middle) part. Error: 2^-14. */
void fxl_corner_colours_light(const fxl_light_settings *settings, const int32_t light[3],
                              int32_t (*values)[3]);

/* The gradients of a triangle with a constant weight, in words; planes: with FXL_COLOURS_SIDE_MAX.
 * Where is_affine, that weight is asked for; false otherwise if it changes a channel by more than
 * 1/8 of a level; where is_coarse, by more than 0.6 from where most is taken off to where least is:
 * the mean of that is added, or what is nearest to it and leaves 0.3 of a level. Where a corner's
 * channel would then be within 1/16 of what no pixel shows, nothing is added if at most 0.3 is taken off to each
 * side; else what is nearest to the mean and would not, if it leaves 0.3. Also false where the face is no triangle, or where a corner's share of a pixel
 * changes by 64 or more a pixel, or by so much that a channel might by 512 levels: *gradients is
 * then undefined. Error in the triangle, beyond that, given the corners: k of the range of a channel
 * (corner_planes.h), and 2048 2^-22 level. */
bool fxl_corner_colours_linear(const fxl_corner_planes *planes, int32_t (*values)[3],
                               bool is_affine, bool is_coarse, fxl_gradients *gradients);

/* The same of a face that is not lit, by its corners, without its values. Also false where weights
 * differ by more than 1/128 of the least one, and not is_affine; and where a share changes by 4. */
bool fxl_corner_colours_unlit(const fxl_corner *const corners[3], const fxl_corner_planes *planes,
                              bool is_affine, fxl_gradients *gradients);

/* Limits of what a constant weight may take off a channel, by the least weight, in 2^-10 level, less
 * what its rounding may be: any; 1/8 of a level to each side; 1/16, and of what is more the mean is
 * added, as where is_coarse. */
#define FXL_BEND_ANY  0
#define FXL_BEND_FINE 124
#define FXL_BEND_NONE 60

/* Such gradients: words of two attributes, each 64 bits from the lower word on. Channels are in
 * 10.22, modulo 2^32, in row 0 of a column of the face. What a column adds is in fxl_colour_words.
 *
 *   attributes[0]   at: red, the column      along: step, green_step   down: red, green
 *   attributes[1]   at: green, blue          along: red, blue          down: blue
 *
 * The step has 11 bits of what red and blue change along a row. So a run is within 128 columns of
 * one whose words have all bits: the face's, or one that is 128 k columns to its right or left. */
#define FXL_SHIFT_OF_WORDS     127 /* all three shifts; above FXL_SHIFT_MOST */
#define FXL_GRADIENTS_OF_WORDS 2

/* Whether gradients of colours at corners are in words. */
static inline bool fxl_has_colour_words(const fxl_gradients *gradients)
{
    return gradients->shifts[0] == FXL_SHIFT_OF_WORDS;
}

/* What draws an outline of them with depth: smooth_outline.h. */
typedef struct fxl_colour_outline fxl_colour_outline;

/* What a painter has for such faces, which links it: those below. Compact, polygon and runs are null, and
 * outline is where no kernel draws one. */
struct fxl_colours_code {
    void (*paint)(const fxl_paint *paint, const fxl_paint_row *row, int32_t x0, int32_t x1);
    bool (*polygon)(const fxl_paint *paint, const fxl_screen_point *points, uint32_t count,
                    const fxl_band *band, fxl_scan *scan);
    void (*runs)(const fxl_paint *paint, fxl_plain_runs *runs);
    fxl_depth_drawn (*outline)(const fxl_screen_point *points, uint32_t count,
                               const fxl_band *band, const fxl_colour_outline *outline);
};

/* A polygon of such a face, into a band without a depth buffer. False: it is not of opaque pixels
 * in words, and nothing is painted. */
bool fxl_paint_colour_polygon(const fxl_paint *paint, const fxl_screen_point *points,
                              uint32_t count, const fxl_band *band, fxl_scan *scan);

/* fxl_paint_pixels_565 of a face with colours at its corners. */
void fxl_paint_colours_565(const fxl_paint *paint, const fxl_paint_row *row, int32_t x0,
                           int32_t x1);

/* The same of all runs, of a face that is opaque and whose colours are not in words. */
void fxl_paint_colour_runs(const fxl_paint *paint, fxl_plain_runs *runs);

#ifdef __cplusplus
}
#endif

#endif

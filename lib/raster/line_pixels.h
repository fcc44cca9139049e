/* SPDX-License-Identifier: MIT */
/* The pixels of a line, one in each row or one in each column. Internal. */
#ifndef FXL_LINE_PIXELS_H
#define FXL_LINE_PIXELS_H

#include "fixel/types.h"

/* A line on its way along its major axis: that of its longer side. */
typedef struct {
    int32_t across; /* the pixel across the major axis */
    int64_t left;   /* what the line is beyond the first edge of that pixel: 0 <= left < pixel */
    int64_t pixel;  /* a pixel, in the same unit; below 2^61 */
    int64_t step;   /* change of the line across a pixel along; |step| <= pixel */
    bool upright;   /* the major axis is y */
} fxl_line_pixels;

/* Sets the pixels from place `first` (included) to `end` (not included) along the major axis. The
 * line is at `first`. Both must lie within the band along that axis. */
void fxl_draw_line_pixels(fxl_line_pixels *line, int32_t first, int32_t end, uint8_t colour,
                          const fxl_band *band);

#endif

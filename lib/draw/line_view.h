/* SPDX-License-Identifier: MIT */
/* A line in the view, of a model or of the world. Internal. */
#ifndef FXL_LINE_VIEW_H
#define FXL_LINE_VIEW_H

#include "../paint/line_paint.h"
#include "fixel/line.h"
#include "fixel/lines.h"

/* What becomes of a line. */
typedef enum {
    FXL_LINE_BACKFACING,
    FXL_LINE_OUTSIDE,
    FXL_LINE_REFUSED,
    FXL_LINE_DRAWN,
    FXL_LINE_CLIPPED /* drawn, and cut by a plane */
} fxl_line_outcome;

/* The planes of the view, by which its lines are cut. */
void fxl_find_line_volume(const fxl_view *view, fxl_volume *volume);

/* clip -> project. On FXL_LINE_DRAWN and FXL_LINE_CLIPPED the ends and distances of *painted are
 * set. */
fxl_line_outcome fxl_place_line(const fxl_view *view, const fxl_volume *volume, fxl_clip_line *line,
                                fxl_painted_line *painted);

/* The canvas of a band. */
fxl_line_canvas fxl_line_canvas_of(const fxl_renderer *renderer, const fxl_workspace *workspace,
                                   const fxl_band *band);

#endif

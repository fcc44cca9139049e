/* SPDX-License-Identifier: MIT */
/* A line in the view, of a model or of the world, and what draws lines of instances. Internal. */
#ifndef FXL_LINE_VIEW_H
#define FXL_LINE_VIEW_H

#include "../paint/line_paint.h"
#include "../view/placement.h"
#include "fixel/line.h"
#include "fixel/lines.h"
#include "submit.h"

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

/* --- lines of instances --------------------------------------------------------------------- */

/* An instance whose lines are drawn. */
typedef struct {
    const fxl_traversal *traversal;
    const fxl_model_view *model_view;
    uint32_t number;
    fxl_volume volume;
} fxl_line_instance;

/* view: room for that of a turned instance. */
void fxl_begin_line_instance(const fxl_traversal *traversal, uint32_t number, fxl_turned_view *view,
                             fxl_line_instance *of);

/* Whether a face of the instance faces the eye. */
bool fxl_line_face_is_front(const fxl_line_instance *of, const fxl_face *face);

/* transform -> clip -> project -> pixels, for a line that is seen: on so many faces, or on none. The
 * planes of *painted are those of the faces if its plane_count is not 0; else it becomes that where
 * they are found. *fits: false where the display list has no room. */
fxl_line_outcome fxl_draw_line_on(const fxl_line_instance *of, const fxl_line *line,
                                  const fxl_face *const faces[], uint32_t count,
                                  fxl_painted_line *painted, bool *fits);

/* Draws over an instance. */
typedef void fxl_instance_overdraw(const fxl_traversal *traversal, uint32_t number, void *with);

/* All instances in sight, in the sequence in which their faces come, over a part of a band with a
 * depth buffer. */
void fxl_draw_over_instances(const fxl_renderer *renderer, fxl_workspace *workspace,
                             const fxl_band *band, fxl_instance_overdraw *draw, void *with);

#endif

/* SPDX-License-Identifier: MIT */
/* A line in the view, of a model or of the world, and what draws lines of instances. Internal. */
#ifndef FXL_LINE_VIEW_H
#define FXL_LINE_VIEW_H

#include "../paint/line_paint.h"
#include "../scene/lens.h"
#include "../scene/placement_code.h"
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

/* clip -> project, from the ends of a line in the view. On FXL_LINE_DRAWN and FXL_LINE_CLIPPED the
 * ends and distances of *painted are set. */
fxl_line_outcome fxl_place_line(const fxl_view *view, fxl_clip_line *line,
                                fxl_painted_line *painted);

/* place fill-rule: how far a line's rows reach beyond its ends, of which half a pixel is the centre's */
/* Whether a line on the screen may have pixels in so many rows from first on. */
/* lines 2.7 */
static inline bool fxl_line_meets_rows(const fxl_painted_line *painted, int32_t first, int32_t rows)
{
    const fxl_q16_16 a = painted->ends[0].y, b = painted->is_point ? a : painted->ends[1].y;
    const int32_t reach = (painted->width + 1) * 32768;
    return (a < b ? b : a) + reach >= first * 65536 &&
           (a < b ? a : b) - reach < (first + rows) * 65536;
}

/* The canvas of a band. */
void fxl_find_line_canvas(const fxl_renderer *renderer, const fxl_workspace *workspace,
                          const fxl_band *band, fxl_line_canvas *canvas);

/* --- lines of instances --------------------------------------------------------------------- */

/* Of how many faces of an instance the depth is kept from line to line. */
#define FXL_LINE_PLANES 4

/* An instance whose lines are drawn. */
typedef struct {
    const fxl_traversal *traversal;
    const fxl_model_view *model_view;
    const fxl_placement_code *turned;  /* of a turned instance, else null */
    const fxl_orthographic_code *flat; /* of an orthographic lens, else null */
    uint32_t number;
    const fxl_face *first_face; /* of the model */
    uint32_t tested, front;     /* bits of its first faces: which were tested, which face the eye */
    fxl_line_canvas *canvas;    /* null: a display list */
    bool is_simple; /* it has a depth buffer and all rows of the screen, and the lens an eye */
    uint8_t next;   /* the place of the next plane */
    const fxl_face *faces[FXL_LINE_PLANES];
    fxl_line_plane planes[FXL_LINE_PLANES];
    fxl_painted_line painted; /* the line that is drawn */
} fxl_line_instance;

/* view: room for that of a turned instance; canvas: null for a display list. */
void fxl_begin_line_instance(const fxl_traversal *traversal, uint32_t number, fxl_turned_view *view,
                             fxl_line_canvas *canvas, fxl_line_instance *of);

/* transform -> clip -> project, for a line of the instance's model: of any kind. */
fxl_line_outcome fxl_place_any_line(const fxl_line_instance *of, const fxl_line *line,
                                    fxl_painted_line *painted);

/* The same by a lens with an eye. */
fxl_line_outcome fxl_place_model_line(const fxl_line_instance *of, const fxl_line *line,
                                      fxl_painted_line *painted);

/* Whether a face of the instance faces the eye. */
bool fxl_line_face_is_front(const fxl_line_instance *of, const fxl_face *face);

/* transform -> clip -> project -> pixels, for a line that is seen: on so many faces, or on none.
 * *fits: false where the display list has no room. */
fxl_line_outcome fxl_draw_line_on(fxl_line_instance *of, const fxl_line *line,
                                  const fxl_face *const faces[], uint32_t count, bool *fits);

/* Draws over an instance. */
typedef void fxl_instance_overdraw(const fxl_traversal *traversal, uint32_t number, void *with);

/* All instances in sight, in the sequence in which their faces come, over a part of a band with a
 * depth buffer. */
void fxl_draw_over_instances(const fxl_renderer *renderer, fxl_workspace *workspace,
                             const fxl_band *band, fxl_instance_overdraw *draw, void *with);

#endif

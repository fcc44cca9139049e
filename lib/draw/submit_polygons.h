/* SPDX-License-Identifier: MIT */
/* The polygons of a face that have more than an outline, to the display list or into the band. The
 * callers differ in what that is, and in what paints it; both are inlined. Internal. */
#ifndef FXL_SUBMIT_POLYGONS_H
#define FXL_SUBMIT_POLYGONS_H

#include "../raster/scan.h"
#include "submit_sorted.h"
#include "surface_polygon.h"

/* Finds what a face's polygons have beside their outlines; what: the finder's own. */
typedef void fxl_polygon_finder(const void *what, const fxl_model_view *model_view,
                                const fxl_face *face, const fxl_traversal *traversal,
                                fxl_surface_polygon *polygon);

/* Paints a polygon in a band; what: as above. */
typedef void fxl_polygon_painter(const void *what, fxl_workspace *workspace,
                                 const fxl_surface_polygon *polygon, const fxl_screen_point *points,
                                 uint32_t count, const fxl_band *band);

static inline __attribute__((always_inline)) fxl_outcome
fxl_emit_polygon(const fxl_traversal *traversal, const fxl_surface_polygon *polygon,
                 fxl_polygon_painter *paint, const void *what)
{
    fxl_workspace *workspace = traversal->workspace;
    const fxl_screen_polygon *screen = &workspace->screen;
    const fxl_rows rows = fxl_scan_rows(screen, traversal->renderer->frame.view.lens.height);
    if (rows.first == rows.end) {
        return 0;
    }
    if (traversal->display_list != NULL) {
        return fxl_surface_polygon_append(traversal->display_list, screen, rows, polygon)
                   ? 0
                   : FXL_OUTCOME_FULL;
    }
    if (traversal->mode == FXL_SUBMIT_MEASURE) {
        fxl_rows_add(traversal->reached, rows);
    } else {
        paint(what, workspace, polygon, screen->points, screen->count, traversal->band);
        fxl_outline_polygon(traversal, screen->points, screen->count);
    }
    return FXL_OUTCOME_SPILLED;
}

/* All polygons of a face: fxl_submit_polygons. Once one of them is left, it is found what they
 * have, unless *polygon has it already. */
static inline __attribute__((always_inline)) fxl_outcome
fxl_submit_found_polygons(const fxl_model_view *model_view, const fxl_face *face,
                          const fxl_traversal *traversal, fxl_polygon_finder *find,
                          fxl_polygon_painter *paint, const void *what,
                          fxl_surface_polygon *polygon, bool found)
{
    fxl_clip_result cut = fxl_first_polygon(model_view, face, traversal);
    fxl_outcome outcome = (fxl_outcome)1 << cut;
    while (cut == FXL_CLIP_INSIDE || cut == FXL_CLIP_CUT) {
        if (!found) {
            find(what, model_view, face, traversal, polygon);
            found = true;
        }
        outcome |= fxl_emit_polygon(traversal, polygon, paint, what);
        if (traversal->clipper->next == NULL || outcome >= FXL_OUTCOME_FULL) {
            break;
        }
        cut = fxl_next_polygon(model_view, traversal);
        outcome |= (fxl_outcome)1 << cut;
    }
    return outcome;
}

#endif

/* SPDX-License-Identifier: MIT */
/* Drawing a band: the polygons of the display list, then the rest of the scene. The callers differ
 * in what draws the list. Internal. */
#ifndef FXL_DRAW_BAND_H
#define FXL_DRAW_BAND_H

#include "../math/arith.h"
#include "../math/memory.h"
#include "reach.h"
#include "submit.h"

/* Draws the polygons of the display list that reach the band. False where the backend's workspace
 * is full. */
typedef bool fxl_list_drawer(const fxl_traversal *on);

static inline fxl_submit_way fxl_way_of(const fxl_renderer *renderer, bool is_begin)
{
    if (FXL_IS_SMALL || renderer->clipper->next != NULL) {
        return FXL_SUBMIT_ANY;
    }
    return is_begin ? FXL_IS_COMPACT ? FXL_SUBMIT_ANY : FXL_SUBMIT_APPEND
           : renderer->visibility->backend->draws_over ? FXL_SUBMIT_DRAW
                                                       : FXL_SUBMIT_ANY;
}

/* What the display list had no room for. Of a frame that was released that is nothing, and another
 * core may be changing the scene. */
static inline bool fxl_submit_rest(const fxl_traversal *on)
{
    const fxl_renderer *renderer = on->renderer;
    if (renderer->frame.state == FXL_FRAME_RELEASED) {
        return true; /* bug: release-reads */
    }
    return !FXL_IS_COMPACT && renderer->frame.state == FXL_FRAME_MEASURED
               ? fxl_reach_submit(on)
               : renderer->visibility->submit(on);
}

/* fxl_draw_band. The compiler is told to inline it, as otherwise a band that is drawn by the
 * default list costs a call and 84 bytes more. */
static inline __attribute__((always_inline)) bool fxl_draw_band_by(const fxl_renderer *renderer,
                                                                   fxl_workspace *workspace,
                                                                   const fxl_band *band,
                                                                   fxl_list_drawer *draw_list)
{
    const fxl_raster_backend *backend = renderer->visibility->backend;
    fxl_resume_point resume = renderer->frame.resume; /* bug: rest-face-late */
    fxl_counters uncounted;
    if (workspace->rest_counted) {
        memset(&uncounted, 0, sizeof uncounted);
    }
    const fxl_traversal on = {.renderer = renderer,
                              .clipper = renderer->clipper,
                              .workspace = workspace,
                              .display_list = NULL,
                              .band = band,
                              .resume = &resume,
                              .counters =
                                  workspace->rest_counted ? &uncounted : &workspace->counters,
                              .way = fxl_way_of(renderer, false)};
    if (backend->begin_band != NULL) {
        backend->begin_band(renderer, workspace, band);
    }
    if (!draw_list(&on) || !fxl_submit_rest(&on)) {
        return false;
    }
    workspace->rest_counted = true; /* bug: counted-again */
    return true;
}

#endif

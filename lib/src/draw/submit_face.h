/* SPDX-License-Identifier: MIT */
/* A face on its way to the list or to a painter: the part of walk.c that does not depend on
 * how it paints. walk.c alone includes it. Internal. */
#ifndef FXL_SUBMIT_FACE_H
#define FXL_SUBMIT_FACE_H

#include "submit.h"

/* Where the polygon on the screen goes. One that reaches no row goes nowhere. */
static inline fxl_outcome deliver(const fxl_traversal *on)
{
    fxl_renderer *renderer = on->renderer;
    const fxl_screen_polygon *screen = &renderer->screen;
    fxl_rows rows = fxl_scan_rows(screen, renderer->view.lens.height);
    if (rows.first == rows.end) {
        return 0;
    }
    if (on->band == NULL) {
        /* bug: list-drop */
        return fxl_display_list_append(&renderer->display_list, screen, rows) ? 0
                                                                              : FXL_OUTCOME_FULL;
    }
    return renderer->visibility->backend->draw_polygon(renderer, screen->points, screen->count,
                                                       screen->colour, on->band)
               ? FXL_OUTCOME_SPILLED
               : FXL_OUTCOME_FULL;
}

fxl_outcome fxl_submit_polygons(const fxl_traversal *on, const fxl_model_view *model_view,
                                const fxl_face *face)
{
    fxl_renderer *renderer = on->renderer;
    const fxl_clipper *clipper = renderer->clipper;
    fxl_clip_result cut = clipper->clip(model_view, face, &renderer->work.clip, &renderer->screen);
    fxl_outcome outcome = (fxl_outcome)1 << cut;
    while (cut == FXL_CLIP_INSIDE || cut == FXL_CLIP_CUT) {
        outcome |= deliver(on);
        if (clipper->next == NULL || outcome >= FXL_OUTCOME_FULL) {
            break;
        }
        cut = clipper->next(model_view, &renderer->work.clip, &renderer->screen);
        outcome |= (fxl_outcome)1 << cut; /* bug: last-polygon */
    }
    return outcome;
}

bool fxl_count_outcome(const fxl_traversal *on, fxl_outcome outcome, uint32_t used)
{
    fxl_counters *counters = on->counters;
    if (outcome >= FXL_OUTCOME_FULL) {
        on->renderer->display_list.used = used; /* bug: full-list-keeps */
        return false;
    }
    if (outcome & (1u << FXL_CLIP_CAPACITY | 1u << FXL_CLIP_RANGE)) {
        counters->refused += 1;
    } else if (outcome & (1u << FXL_CLIP_INSIDE | 1u << FXL_CLIP_CUT | 1u << FXL_CLIP_BETWEEN)) {
        counters->drawn += 1;
        counters->clipped += outcome >> FXL_CLIP_CUT & 1u;
        counters->spilled += (outcome & FXL_OUTCOME_SPILLED) != 0;
    } else if (outcome & 1u << FXL_CLIP_DEGENERATE) {
        counters->degenerate += 1;
    } else {
        counters->outside += 1;
    }
    return true;
}

/* Any face: into the list, or by any painter. */
static bool take_face(const fxl_traversal *on, const fxl_model_view *model_view,
                      const fxl_face *face)
{
    uint32_t used = on->renderer->display_list.used;
    return fxl_count_outcome(on, fxl_submit_polygons(on, model_view, face), used);
}

#endif

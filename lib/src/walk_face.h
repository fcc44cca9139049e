/* SPDX-License-Identifier: MIT */
/* A face on its way to the list or to a painter: the part of walk.c that does not depend on
 * how it paints. walk.c alone includes it. Internal. */
#ifndef FXL_WALK_FACE_H
#define FXL_WALK_FACE_H

#include "walk.h"

/* Where the polygon on the screen goes. One that reaches no row goes nowhere. */
static inline fxl_fate deliver(const fxl_walk *on)
{
    fxl_renderer *renderer = on->renderer;
    const fxl_screen_polygon *screen = &renderer->screen;
    fxl_rows rows = fxl_scan_rows(screen, renderer->view.lens.height);
    if (rows.first == rows.end) {
        return 0;
    }
    if (on->band == NULL) {
        /* bug: list-drop */
        return fxl_list_append(&renderer->list, screen, rows) ? 0 : FXL_FATE_NO_ROOM;
    }
    return renderer->hidden->painter->paint(renderer, screen->points, screen->count, screen->colour,
                                            on->band)
               ? FXL_FATE_SPILLED
               : FXL_FATE_NO_ROOM;
}

fxl_fate fxl_walk_polygons(const fxl_walk *on, const fxl_placed *placed, const fxl_face *face)
{
    fxl_renderer *renderer = on->renderer;
    const fxl_clipper *clipper = renderer->clipper;
    fxl_clip_result cut = clipper->clip(placed, face, &renderer->work.clip, &renderer->screen);
    fxl_fate fate = (fxl_fate)1 << cut;
    while (cut == FXL_CLIP_INSIDE || cut == FXL_CLIP_CUT) {
        fate |= deliver(on);
        if (clipper->next == NULL || fate >= FXL_FATE_NO_ROOM) {
            break;
        }
        cut = clipper->next(placed, &renderer->work.clip, &renderer->screen);
        fate |= (fxl_fate)1 << cut; /* bug: last-polygon */
    }
    return fate;
}

bool fxl_walk_account(const fxl_walk *on, fxl_fate fate, uint32_t used)
{
    fxl_counters *counters = on->counters;
    if (fate >= FXL_FATE_NO_ROOM) {
        on->renderer->list.used = used; /* bug: full-list-keeps */
        return false;
    }
    if (fate & (1u << FXL_CLIP_CAPACITY | 1u << FXL_CLIP_RANGE)) {
        counters->refused += 1;
    } else if (fate & (1u << FXL_CLIP_INSIDE | 1u << FXL_CLIP_CUT | 1u << FXL_CLIP_BETWEEN)) {
        counters->drawn += 1;
        counters->clipped += fate >> FXL_CLIP_CUT & 1u;
        counters->spilled += (fate & FXL_FATE_SPILLED) != 0;
    } else if (fate & 1u << FXL_CLIP_DEGENERATE) {
        counters->degenerate += 1;
    } else {
        counters->outside += 1;
    }
    return true;
}

/* Any face: into the list, or by any painter. */
static bool take_face(const fxl_walk *on, const fxl_placed *placed, const fxl_face *face)
{
    uint32_t used = on->renderer->list.used;
    return fxl_walk_account(on, fxl_walk_polygons(on, placed, face), used);
}

#endif

/* SPDX-License-Identifier: MIT */
/* From a face of a placed object to the screen, as the family's clippers have it in
 * common: what is inside comes from the cache, what is not is assembled and cut.
 * Internal. Each clipper is compiled with its own way, so nothing is asked twice. */
#ifndef FXL_CLIP_COMMON_H
#define FXL_CLIP_COMMON_H

#include "fixel/stage/clipper.h"
#include "fixel/extra/clippers/workspace.h"

/* What a clipper does its own way. A vertex's state has the planes that it lies
 * outside of, and may have FXL_VERTEX_BEYOND_GUARD_BAND. */
typedef struct {
    fxl_cached_vertex *(*see)(const fxl_model_view *model_view, uint32_t number);
    fxl_status (*project)(const fxl_model_view *model_view, const fxl_view_point *point,
                          fxl_screen_point *screen);
    fxl_varying_polygon *(*input)(const fxl_model_view *model_view); /* where a face is assembled */
    /* any: of the states of the vertices. */
    fxl_clip_result (*cut)(const fxl_model_view *model_view, const fxl_varying_polygon *in,
                           unsigned any, const fxl_varying_polygon **result);
} fxl_clip_steps;

/* A clipper's own bit: outside of what the screen's range can hold. */
#define FXL_VERTEX_BEYOND_GUARD_BAND 0x40u

FXL_STATIC_ASSERT((FXL_PLANES_ALL & FXL_VERTEX_BEYOND_GUARD_BAND) == 0 &&
                      (FXL_VERTEX_UNPROJECTED & (FXL_PLANES_ALL | FXL_VERTEX_BEYOND_GUARD_BAND)) ==
                          0,
                  "all share a byte");

/* The cache's entry for a vertex; *is_new where it holds another one's, and the tag
 * alone was changed. */
static inline fxl_cached_vertex *fxl_clip_common_entry(const fxl_model_view *model_view,
                                                       uint32_t number, bool *is_new)
{
    fxl_cached_vertex *entry = &model_view->entries[number & model_view->mask];
    *is_new = entry->tag != model_view->tag + number;
    entry->tag = model_view->tag + number;
    return entry;
}

/* A vertex that the screen can hold, onto it. */
static inline bool fxl_clip_common_project(const fxl_model_view *model_view,
                                           fxl_cached_vertex *vertex, const fxl_clip_steps *way)
{
    if ((vertex->clip_flags & FXL_VERTEX_UNPROJECTED) != 0) {
        if (way->project(model_view, &vertex->position, &vertex->screen) != FXL_OK) {
            return false;
        }
        vertex->clip_flags &= (uint8_t)~FXL_VERTEX_UNPROJECTED;
    }
    return true;
}

/* Every vertex as it is. Before one whose state has a bit of stop: FXL_CLIP_CUT. */
static inline fxl_clip_result fxl_clip_common_whole(const fxl_model_view *model_view,
                                                    const fxl_face *face,
                                                    fxl_screen_polygon *screen,
                                                    const fxl_clip_steps *way, unsigned stop)
{
    const uint16_t *corners = model_view->indices + face->first_index;
    for (uint32_t i = 0; i < face->count; i++) {
        fxl_cached_vertex *vertex = way->see(model_view, corners[i]);
        if ((vertex->clip_flags & stop) != 0) {
            return FXL_CLIP_CUT;
        }
        if (!fxl_clip_common_project(model_view, vertex, way)) {
            return FXL_CLIP_RANGE;
        }
        screen->points[i] = vertex->screen;
    }
    screen->colour = face->colour;
    screen->count = face->count;
    return FXL_CLIP_INSIDE;
}

/* A cut polygon onto the screen. */
static inline fxl_clip_result fxl_clip_common_to_screen(const fxl_model_view *model_view,
                                                        const fxl_varying_polygon *clipped,
                                                        fxl_screen_polygon *screen,
                                                        const fxl_clip_steps *way)
{
    screen->colour = clipped->colour;
    screen->count = clipped->count;
    for (uint32_t i = 0; i < clipped->count; i++) {
        if (way->project(model_view, &clipped->vertices[i].position, &screen->points[i]) !=
            FXL_OK) {
            return FXL_CLIP_RANGE;
        }
    }
    return FXL_CLIP_CUT;
}

/* cut_by: states of a vertex that a face must be cut for. */
static inline fxl_clip_result fxl_clip_common_face(const fxl_model_view *model_view,
                                                   const fxl_face *face, fxl_screen_polygon *screen,
                                                   const fxl_clip_steps *way, unsigned cut_by)
{
    fxl_clip_result whole = fxl_clip_common_whole(model_view, face, screen, way,
                                                  FXL_PLANES_ALL | FXL_VERTEX_BEYOND_GUARD_BAND);
    if (whole != FXL_CLIP_CUT) {
        return whole;
    }
    const uint16_t *corners = model_view->indices + face->first_index;
    fxl_varying_polygon *in = way->input(model_view);
    const fxl_varying_polygon *clipped;
    unsigned any = 0, all = FXL_PLANES_ALL;
    for (uint32_t i = 0; i < face->count; i++) {
        const fxl_cached_vertex *vertex = way->see(model_view, corners[i]);
        any |= vertex->clip_flags;
        all &= vertex->clip_flags;
        in->vertices[i].position = vertex->position;
    }
    if (all != 0) {
        return FXL_CLIP_OUTSIDE;
    }
    if ((any & cut_by) == 0) {
        return fxl_clip_common_whole(model_view, face, screen, way, 0);
    }
    in->colour = face->colour;
    in->count = face->count;
    in->carried = 0;
    fxl_clip_result result = way->cut(model_view, in, any, &clipped);
    return clipped == NULL ? result : fxl_clip_common_to_screen(model_view, clipped, screen, way);
}

#endif

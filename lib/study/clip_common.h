/* SPDX-License-Identifier: MIT */
/* Takes a face of an instance to the screen: the part that the other clippers share. Vertices
 * inside the frustum come from the vertex cache. Other faces are assembled into a polygon and
 * cut. Internal. Each clipper is compiled with its own steps, so the steps cost no test at run
 * time. */
#ifndef FXL_CLIP_COMMON_H
#define FXL_CLIP_COMMON_H

#include "../clip/volume.h"
#include "../view/model_view.h"
#include "../view/outcode.h"
#include "clippers.h"

/* The steps in which the clippers differ. The clip_flags of a vertex have a bit for each plane
 * that it lies outside of, and may have FXL_VERTEX_BEYOND_GUARD_BAND. */
typedef struct {
    fxl_cached_vertex *(*fetch)(const fxl_model_view *model_view, uint32_t number);
    fxl_status (*project)(const fxl_model_view *model_view, const fxl_view_point *point,
                          fxl_screen_point *screen);
    fxl_varying_polygon *(*input)(
        const fxl_model_view *model_view); /* the polygon in which a face is assembled */
    /* any: the OR of the clip_flags of the vertices. */
    fxl_clip_result (*cut)(const fxl_model_view *model_view, const fxl_varying_polygon *in,
                           unsigned any, const fxl_varying_polygon **result);
} fxl_clip_steps;

/* A bit that only these clippers use: the vertex lies beyond what the range of the screen holds. */
#define FXL_VERTEX_BEYOND_GUARD_BAND 0x40u

FXL_STATIC_ASSERT((FXL_PLANES_ALL & FXL_VERTEX_BEYOND_GUARD_BAND) == 0 &&
                      (FXL_VERTEX_UNPROJECTED & (FXL_PLANES_ALL | FXL_VERTEX_BEYOND_GUARD_BAND)) ==
                          0,
                  "all share a byte");

/* Returns the cache entry for a vertex. *is_new tells that it held another vertex; then only its
 * tag has been changed so far. */
/* clippers 4.3 */
static inline fxl_cached_vertex *fxl_clip_common_entry(const fxl_model_view *model_view,
                                                       uint32_t number, bool *is_new)
{
    fxl_cached_vertex *entry = &model_view->entries[number & model_view->mask];
    *is_new = entry->tag != model_view->tag + number;
    entry->tag = model_view->tag + number;
    return entry;
}

/* Projects a vertex that is in the range of the screen, unless it is projected already. */
static inline bool fxl_clip_common_project(const fxl_model_view *model_view,
                                           fxl_cached_vertex *vertex, const fxl_clip_steps *steps)
{
    if ((vertex->clip_flags & FXL_VERTEX_UNPROJECTED) != 0) {
        if (steps->project(model_view, &vertex->position, &vertex->screen) != FXL_OK) {
            return false;
        }
        vertex->clip_flags &= (uint8_t)~FXL_VERTEX_UNPROJECTED;
    }
    return true;
}

/* Projects every vertex of a face, uncut. Returns FXL_CLIP_CUT at the first vertex whose
 * clip_flags have a bit of stop. */
static inline fxl_clip_result fxl_clip_common_whole(const fxl_model_view *model_view,
                                                    const fxl_face *face,
                                                    fxl_screen_polygon *screen,
                                                    const fxl_clip_steps *steps, unsigned stop)
{
    const uint16_t *indices = fxl_face_indices(model_view->indices, face);
    for (uint32_t i = 0; i < face->count; i++) {
        fxl_cached_vertex *vertex = steps->fetch(model_view, indices[i]);
        if ((vertex->clip_flags & stop) != 0) {
            return FXL_CLIP_CUT;
        }
        if (!fxl_clip_common_project(model_view, vertex, steps)) {
            return FXL_CLIP_RANGE;
        }
        screen->points[i] = vertex->screen;
    }
    screen->colour = face->material;
    screen->count = face->count;
    return FXL_CLIP_INSIDE;
}

/* Projects a cut polygon. */
static inline fxl_clip_result fxl_clip_common_to_screen(const fxl_model_view *model_view,
                                                        const fxl_varying_polygon *clipped,
                                                        fxl_screen_polygon *screen,
                                                        const fxl_clip_steps *steps)
{
    screen->colour = clipped->colour;
    screen->count = clipped->count;
    for (uint32_t i = 0; i < clipped->count; i++) {
        if (steps->project(model_view, &clipped->vertices[i].position, &screen->points[i]) !=
            FXL_OK) {
            return FXL_CLIP_RANGE;
        }
    }
    return FXL_CLIP_CUT;
}

/* Takes a face to the screen. cut_by: the bits of clip_flags for which a face must be cut. */
/* clippers 4.3 */
static inline fxl_clip_result fxl_clip_common_face(const fxl_model_view *model_view,
                                                   const fxl_face *face, fxl_screen_polygon *screen,
                                                   const fxl_clip_steps *steps, unsigned cut_by)
{
    fxl_clip_result whole = fxl_clip_common_whole(model_view, face, screen, steps,
                                                  FXL_PLANES_ALL | FXL_VERTEX_BEYOND_GUARD_BAND);
    if (whole != FXL_CLIP_CUT) {
        return whole;
    }
    const uint16_t *indices = fxl_face_indices(model_view->indices, face);
    fxl_varying_polygon *in = steps->input(model_view);
    const fxl_varying_polygon *clipped;
    unsigned any = 0, all = FXL_PLANES_ALL;
    for (uint32_t i = 0; i < face->count; i++) {
        const fxl_cached_vertex *vertex = steps->fetch(model_view, indices[i]);
        any |= vertex->clip_flags;
        all &= vertex->clip_flags;
        in->vertices[i].position = vertex->position;
    }
    if (all != 0) {
        return FXL_CLIP_OUTSIDE;
    }
    if ((any & cut_by) == 0) {
        return fxl_clip_common_whole(model_view, face, screen, steps, 0);
    }
    in->colour = face->material;
    in->count = face->count; /* carried is 0, as all of the workspace was */
    fxl_clip_result result = steps->cut(model_view, in, any, &clipped);
    return clipped == NULL ? result : fxl_clip_common_to_screen(model_view, clipped, screen, steps);
}

#endif

/* SPDX-License-Identifier: MIT */
/* From a face of a placed object to the screen, as the family's clippers have it in
 * common: what is inside comes from the cache, what is not is assembled and cut.
 * Internal. Each clipper is compiled with its own way, so nothing is asked twice. */
#ifndef FXL_FAMILY_H
#define FXL_FAMILY_H

#include "fixel/clipper.h"
#include "fixel/clipper_room.h"

/* What a clipper does its own way. A vertex's state has the planes that it lies
 * outside of, and may have FXL_FAMILY_BEYOND. */
typedef struct {
    fxl_seen_vertex *(*see)(const fxl_placed *placed, uint32_t number);
    fxl_status (*project)(const fxl_placed *placed, const fxl_view_point *point,
                          fxl_screen_point *screen);
    fxl_clip_polygon *(*input)(const fxl_placed *placed); /* where a face is assembled */
    /* any: of the states of the vertices. */
    fxl_clip_result (*cut)(const fxl_placed *placed, const fxl_clip_polygon *in, unsigned any,
                           const fxl_clip_polygon **result);
} fxl_way;

/* A clipper's own bit: outside of what the screen's range can hold. */
#define FXL_FAMILY_BEYOND 0x40u

_Static_assert((FXL_PLANES_ALL & FXL_FAMILY_BEYOND) == 0 &&
                   (FXL_SEEN_UNPROJECTED & (FXL_PLANES_ALL | FXL_FAMILY_BEYOND)) == 0,
               "all share a byte");

/* The cache's entry for a vertex; *is_new where it holds another one's, and the tag
 * alone was changed. */
static inline fxl_seen_vertex *fxl_family_entry(const fxl_placed *placed, uint32_t number,
                                                bool *is_new)
{
    fxl_seen_vertex *entry = &placed->entries[number & placed->mask];
    *is_new = entry->tag != placed->tag + number;
    entry->tag = placed->tag + number;
    return entry;
}

/* A vertex that the screen can hold, onto it. */
static inline bool fxl_family_project(const fxl_placed *placed, fxl_seen_vertex *vertex,
                                      const fxl_way *way)
{
    if ((vertex->state & FXL_SEEN_UNPROJECTED) != 0) {
        if (way->project(placed, &vertex->position, &vertex->screen) != FXL_OK) {
            return false;
        }
        vertex->state &= (uint8_t)~FXL_SEEN_UNPROJECTED;
    }
    return true;
}

/* Every vertex as it is. Before one whose state has a bit of stop: FXL_CLIP_CUT. */
static inline fxl_clip_result fxl_family_take_whole(const fxl_placed *placed, const fxl_face *face,
                                                    fxl_screen_polygon *screen, const fxl_way *way,
                                                    unsigned stop)
{
    const uint16_t *corners = placed->corners + face->first_corner;
    for (uint32_t i = 0; i < face->count; i++) {
        fxl_seen_vertex *vertex = way->see(placed, corners[i]);
        if ((vertex->state & stop) != 0) {
            return FXL_CLIP_CUT;
        }
        if (!fxl_family_project(placed, vertex, way)) {
            return FXL_CLIP_RANGE;
        }
        screen->points[i] = vertex->screen;
    }
    screen->colour = face->colour;
    screen->count = face->count;
    return FXL_CLIP_INSIDE;
}

/* A cut polygon onto the screen. */
static inline fxl_clip_result fxl_family_show(const fxl_placed *placed,
                                              const fxl_clip_polygon *clipped,
                                              fxl_screen_polygon *screen, const fxl_way *way)
{
    screen->colour = clipped->colour;
    screen->count = clipped->count;
    for (uint32_t i = 0; i < clipped->count; i++) {
        if (way->project(placed, &clipped->vertices[i].position, &screen->points[i]) != FXL_OK) {
            return FXL_CLIP_RANGE;
        }
    }
    return FXL_CLIP_CUT;
}

/* cut_by: states of a vertex that a face must be cut for. */
static inline fxl_clip_result fxl_family_take(const fxl_placed *placed, const fxl_face *face,
                                              fxl_screen_polygon *screen, const fxl_way *way,
                                              unsigned cut_by)
{
    fxl_clip_result whole =
        fxl_family_take_whole(placed, face, screen, way, FXL_PLANES_ALL | FXL_FAMILY_BEYOND);
    if (whole != FXL_CLIP_CUT) {
        return whole;
    }
    const uint16_t *corners = placed->corners + face->first_corner;
    fxl_clip_polygon *in = way->input(placed);
    const fxl_clip_polygon *clipped;
    unsigned any = 0, all = FXL_PLANES_ALL;
    for (uint32_t i = 0; i < face->count; i++) {
        const fxl_seen_vertex *vertex = way->see(placed, corners[i]);
        any |= vertex->state;
        all &= vertex->state;
        in->vertices[i].position = vertex->position;
    }
    if (all != 0) {
        return FXL_CLIP_OUTSIDE;
    }
    if ((any & cut_by) == 0) {
        return fxl_family_take_whole(placed, face, screen, way, 0);
    }
    in->colour = face->colour;
    in->count = face->count;
    in->carried = 0;
    fxl_clip_result result = way->cut(placed, in, any, &clipped);
    return clipped == NULL ? result : fxl_family_show(placed, clipped, screen, way);
}

#endif

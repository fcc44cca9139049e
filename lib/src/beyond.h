/* SPDX-License-Identifier: MIT */
/* The clippers that leave sides of the screen to the scan: near and far are cut, and
 * of the sides those that are given; of the others only what is beyond the guard band.
 * Internal. */
#ifndef FXL_BEYOND_H
#define FXL_BEYOND_H

#include "crossing.h"
#include "family.h"

static inline fxl_volume_room *fxl_beyond_room(const fxl_placed *placed)
{
    return placed->view->room;
}

/* A vertex of the ordinary cache. One that is outside of a plane which the scan stands
 * in for is asked whether the guard band holds it: by its own place alone, so that
 * all faces that have it agree. screen: the planes that are cut. */
static inline fxl_seen_vertex *fxl_beyond_see(const fxl_placed *placed, uint32_t number,
                                              unsigned screen)
{
    fxl_seen_vertex *entry = &placed->entries[number & placed->mask];
    if (entry->tag != placed->tag + number) {
        fxl_look_at(placed, number, entry);
        if ((entry->state & FXL_PLANES_ALL & ~screen) != 0) {
            fxl_volume_room *room = fxl_beyond_room(placed);
            room->clip.account.distances += FXL_PLANE_COUNT;
            /* bug: beyond-unasked */
            if ((fxl_volume_code(&room->volume, &entry->position) & ~screen) != 0) {
                entry->state |= FXL_FAMILY_BEYOND;
            }
        }
    }
    return entry;
}

static inline fxl_status fxl_beyond_project(const fxl_placed *placed, const fxl_view_point *point,
                                            fxl_screen_point *to)
{
    return fxl_project_seen(&placed->view->projection, point, to);
}

static inline fxl_clip_polygon *fxl_beyond_input(const fxl_placed *placed)
{
    return &fxl_beyond_room(placed)->clip.polygons[0];
}

/* Sides by the volume's own codes where a vertex is beyond. */
static inline fxl_clip_result fxl_beyond_cut(const fxl_placed *placed, const fxl_clip_polygon *in,
                                             unsigned any, unsigned screen,
                                             const fxl_clip_polygon **result)
{
    fxl_volume_room *room = fxl_beyond_room(placed);
    uint32_t by = any & screen;
    if ((any & FXL_FAMILY_BEYOND) != 0) {
        room->clip.account.distances += FXL_PLANE_COUNT * (uint32_t)in->count;
        for (uint32_t i = 0; i < in->count; i++) {
            by |= fxl_volume_code(&room->volume, &in->vertices[i].position);
        }
    }
    return fxl_cut_by_volume(in, by, &room->volume, &room->clip, result);
}

static inline void fxl_beyond_set_up(const fxl_placed *placed, unsigned screen)
{
    const fxl_view *view = placed->view;
    fxl_volume_room *room = fxl_beyond_room(placed);
    if (room->frame != view->frame) {
        fxl_volume_from_sides(&view->view_frustum, view->lens.focal, screen, &room->volume);
        room->frame = view->frame;
    }
}

#endif

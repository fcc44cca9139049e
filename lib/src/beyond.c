/* SPDX-License-Identifier: MIT */
#include "beyond.h"

#include "crossing.h"
#include "family.h"

static fxl_volume_room *room_of(const fxl_placed *placed)
{
    return placed->view->room;
}

/* A vertex of the ordinary cache. One that is outside of a plane which the scan stands
 * in for is asked whether the guard band holds it: by its own place alone, so that
 * all faces that have it agree. */
static fxl_seen_vertex *see(const fxl_placed *placed, uint32_t number)
{
    fxl_seen_vertex *entry = &placed->entries[number & placed->mask];
    if (entry->tag != placed->tag + number) {
        fxl_volume_room *room = room_of(placed);
        fxl_look_at(placed, number, entry);
        if ((entry->state & FXL_PLANES_ALL & ~room->screen) != 0) {
            room->clip.account.distances += FXL_PLANE_COUNT;
            if ((fxl_volume_code(&room->volume, &entry->position) & ~room->screen) != 0) {
                entry->state |= FXL_FAMILY_BEYOND;
            }
        }
    }
    return entry;
}

static fxl_status project(const fxl_placed *placed, const fxl_view_point *point,
                          fxl_screen_point *to)
{
    return fxl_project_seen(&placed->view->projection, point, to);
}

static fxl_clip_polygon *input(const fxl_placed *placed)
{
    return &room_of(placed)->clip.polygons[0];
}

/* Sides by the volume's own codes where a vertex is beyond. */
static fxl_clip_result cut(const fxl_placed *placed, const fxl_clip_polygon *in, unsigned any,
                           const fxl_clip_polygon **result)
{
    fxl_volume_room *room = room_of(placed);
    uint32_t by = any & room->screen;
    if ((any & FXL_FAMILY_BEYOND) != 0) {
        room->clip.account.distances += FXL_PLANE_COUNT * (uint32_t)in->count;
        for (uint32_t i = 0; i < in->count; i++) {
            by |= fxl_volume_code(&room->volume, &in->vertices[i].position);
        }
    }
    return fxl_cut_by_volume(in, by, &room->volume, &room->clip, result);
}

fxl_clip_result fxl_clip_beyond(const fxl_placed *placed, const fxl_face *face, unsigned screen,
                                fxl_screen_polygon *polygon)
{
    static const fxl_way way = {see, project, input, cut};
    const fxl_view *view = placed->view;
    fxl_volume_room *room = room_of(placed);
    if (room->frame != view->frame) {
        fxl_volume_from_sides(&view->view_frustum, view->lens.focal, screen, &room->volume);
        room->screen = screen;
        room->frame = view->frame;
    }
    return fxl_family_take(placed, face, polygon, &way, screen | FXL_FAMILY_BEYOND);
}

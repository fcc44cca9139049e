/* SPDX-License-Identifier: MIT */
/* Codes and cuts by homogeneous half-spaces, whatever their form. */
#include "crossing.h"
#include "family.h"
#include "rotate.h"

static fxl_volume_room *room_of(const fxl_placed *placed)
{
    return placed->view->room;
}

/* The same integers as fxl_look_at gives. */
static fxl_seen_vertex *see(const fxl_placed *placed, uint32_t number)
{
    bool is_new;
    fxl_seen_vertex *entry = fxl_family_entry(placed, number, &is_new);
    if (is_new) {
        fxl_volume_room *room = room_of(placed);
        fxl_point from_eye = fxl_placed_vertex(placed, number);
        fxl_rotate(&placed->view->camera, &from_eye, &entry->position);
        entry->state = FXL_SEEN_UNPROJECTED;
        if (placed->planes != 0) {
            room->clip.account.distances += FXL_PLANE_COUNT;
            entry->state |=
                (uint8_t)(fxl_volume_code(&room->volume, &entry->position) & placed->planes);
        }
    }
    return entry;
}

static fxl_status project(const fxl_placed *placed, const fxl_view_point *point,
                          fxl_screen_point *screen)
{
    return fxl_project_seen(&placed->view->projection, point, screen);
}

static fxl_clip_polygon *input(const fxl_placed *placed)
{
    return &room_of(placed)->clip.polygons[0];
}

static fxl_clip_result cut(const fxl_placed *placed, const fxl_clip_polygon *in, unsigned any,
                           const fxl_clip_polygon **result)
{
    fxl_volume_room *room = room_of(placed);
    /* bug: half-spaces-four */
    return fxl_cut_by_volume(in, any & FXL_PLANES_ALL, &room->volume, &room->clip, result);
}

static fxl_clip_result clip(const fxl_placed *placed, const fxl_face *face, fxl_clipper_work *work,
                            fxl_screen_polygon *screen)
{
    static const fxl_way way = {see, project, input, cut};
    const fxl_view *view = placed->view;
    fxl_volume_room *room = room_of(placed);
    (void)work;
    if (room->frame != view->frame) {
        fxl_volume_from_sides(&view->view_frustum, view->lens.focal, FXL_PLANES_ALL, &room->volume);
        room->frame = view->frame;
    }
    return fxl_family_take(placed, face, screen, &way, FXL_PLANES_ALL);
}

const fxl_clipper fxl_clipper_half_spaces = {clip, NULL, sizeof(fxl_volume_room)};

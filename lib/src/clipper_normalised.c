/* SPDX-License-Identifier: MIT */
#include "crossing.h"
#include "see_normalised.h"

static fxl_normalised_room *room_of(const fxl_placed *placed)
{
    return placed->view->room;
}

static fxl_seen_vertex *see(const fxl_placed *placed, uint32_t number)
{
    return fxl_see_normalised(placed, number, &room_of(placed)->frustum);
}

static fxl_status project(const fxl_placed *placed, const fxl_view_point *point,
                          fxl_screen_point *screen)
{
    return fxl_normalised_project(&room_of(placed)->frustum, point, screen);
}

static fxl_clip_polygon *input(const fxl_placed *placed)
{
    return &room_of(placed)->clip.polygons[0];
}

static fxl_clip_result cut(const fxl_placed *placed, const fxl_clip_polygon *in, unsigned any,
                           const fxl_clip_polygon **result)
{
    fxl_normalised_room *room = room_of(placed);
    return fxl_cut_by_normalised(in, any & FXL_PLANES_ALL, &room->frustum, &room->clip, result);
}

static fxl_clip_result clip(const fxl_placed *placed, const fxl_face *face, fxl_clipper_work *work,
                            fxl_screen_polygon *screen)
{
    static const fxl_way way = {see, project, input, cut};
    fxl_normalised_room *room = room_of(placed);
    (void)work;
    fxl_normalised_set_up(placed->view, &room->frame, &room->frustum);
    return fxl_family_take(placed, face, screen, &way, FXL_PLANES_ALL);
}

const fxl_clipper fxl_clipper_normalised = {clip, NULL, sizeof(fxl_normalised_room)};

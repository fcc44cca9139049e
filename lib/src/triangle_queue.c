/* SPDX-License-Identifier: MIT */
#include "arith.h"
#include "crossing.h"
#include "fixel/project.h"
#include "fixel/triangle.h"

#define MASK (FXL_TRIANGLE_QUEUE - 1u)

/* A border at most doubles what waits, so four of them end at 16. */
static void cut_flats(fxl_triangle_room *room, int border, uint16_t extent)
{
    fxl_clip_account account = room->account;
    account.sliver = room->screen_sliver;
    for (uint32_t left = room->flat_count; left > 0; left--) {
        fxl_screen_triangle cut[2];
        uint32_t made = fxl_triangle_cut_screen(&room->flats[room->flat_first & MASK], border,
                                                extent, room->carried, &account, cut);
        room->flat_first += 1;
        room->flat_count -= 1;
        for (uint32_t i = 0; i < made; i++) { /* bug: queue-one-of-two */
            FXL_ASSERT(room->flat_count < FXL_TRIANGLE_QUEUE);
            room->flats[(room->flat_first + room->flat_count++) & MASK] = cut[i];
        }
    }
    room->account.intersections = account.intersections;
}

fxl_clip_result fxl_triangle_begin(const fxl_clip_triangle *in, uint32_t carried,
                                   const fxl_volume *volume, fxl_triangle_room *room)
{
    uint32_t any = 0, all = UINT32_MAX;
    for (int i = 0; i < 3; i++) {
        uint32_t code = fxl_volume_code(volume, &in->corners[i].position);
        any |= code;
        all &= code;
    }
    room->account.distances += 3 * FXL_PLANE_COUNT;
    room->planes = any;
    room->carried = (uint8_t)carried;
    room->flat_first = room->flat_count = room->solid_count = 0;
    if (all != 0) {
        return FXL_CLIP_OUTSIDE;
    }
    room->solids[0] = *in;
    room->next_plane[0] = 0;
    room->solid_count = 1;
    return any == 0 ? FXL_CLIP_INSIDE : FXL_CLIP_CUT;
}

/* The triangle on top of the stack, cut by the planes that it has not met yet. Where a
 * plane leaves two, the second is pushed, to meet the planes that follow: so of those
 * that wait, no two are to meet the same plane next. Null where nothing is left. */
static const fxl_clip_triangle *pop_solid(const fxl_volume *volume, fxl_triangle_room *room)
{
    uint32_t top = --room->solid_count;
    for (uint32_t plane = room->next_plane[top]; room->planes >> plane != 0; plane++) {
        fxl_clip_triangle cut[2];
        if ((room->planes >> plane & 1u) == 0) {
            continue;
        }
        /* Into the place that it came from: the next one lies above. */
        uint32_t made = fxl_triangle_cut(&room->solids[top], &volume->planes[plane], room->carried,
                                         &room->account, cut);
        if (made == 0) {
            room->solid_count = top;
            return NULL;
        }
        if (made == 2) {
            room->solids[top] = cut[1];
            room->next_plane[top] = (uint8_t)(plane + 1);
            top += 1;
            FXL_ASSERT(top < FXL_TRIANGLE_STACK);
        }
        room->solids[top] = cut[0];
    }
    room->solid_count = top;
    return &room->solids[top];
}

/* Onto the screen, with the depth. */
static fxl_status project(const fxl_lens *lens, const fxl_clip_triangle *solid, uint32_t carried,
                          fxl_screen_triangle *flat)
{
    for (int i = 0; i < 3; i++) {
        const fxl_clip_vertex *from = &solid->corners[i];
        fxl_screen_corner *to = &flat->corners[i];
        fxl_status status = fxl_project_point(lens, &from->position, &to->at);
        if (status != FXL_OK) {
            return status;
        }
        to->depth = from->position.z;
        for (uint32_t k = 0; k < carried; k++) {
            to->carried[k] = from->carried[k];
        }
    }
    return FXL_OK;
}

const fxl_screen_triangle *fxl_triangle_next(const fxl_volume *volume, const fxl_lens *lens,
                                             fxl_triangle_room *room, fxl_status *status)
{
    *status = FXL_OK;
    while (room->flat_count == 0) {
        if (room->solid_count == 0) {
            return NULL;
        }
        const fxl_clip_triangle *solid = pop_solid(volume, room);
        if (solid == NULL) {
            continue;
        }
        *status = project(lens, solid, room->carried, &room->flats[0]);
        if (*status != FXL_OK) {
            room->solid_count = 0;
            return NULL;
        }
        room->flat_first = 0;
        room->flat_count = 1;
        cut_flats(room, FXL_BORDER_LEFT, lens->width);
        cut_flats(room, FXL_BORDER_RIGHT, lens->width);
        cut_flats(room, FXL_BORDER_TOP, lens->height);
        cut_flats(room, FXL_BORDER_BOTTOM, lens->height);
    }
    room->flat_count -= 1;
    return &room->flats[room->flat_first++ & MASK];
}

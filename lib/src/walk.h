/* SPDX-License-Identifier: MIT */
/* The walk over a scene, for those that give it faces. Internal. */
#ifndef FXL_WALK_H
#define FXL_WALK_H

#include "fixel/render.h"

/* What takes a face that faces the eye: transform, clip and project -> list or band, counted in
 * everything but `in`. False where there is no room, in the list or for the painter:
 * the face is then not counted, and the list is as it was. */
typedef bool (*fxl_face_taker)(const fxl_walk *on, const fxl_placed *placed, const fxl_face *face);

/* With a band it paints, without one it fills the list. */
struct fxl_walk {
    fxl_renderer *renderer;
    const fxl_band *band; /* null: the list */
    fxl_place *place;     /* kept where it is stopped */
    fxl_counters *counters;
    fxl_face_taker take; /* fxl_walk_taker's */
};

/* The way of a frame's faces. */
fxl_face_taker fxl_walk_taker(const fxl_renderer *renderer, const fxl_band *band);

/* The same for an object: with light on it, the light's. */
fxl_face_taker fxl_walk_taker_of(const fxl_walk *on, const fxl_object *object,
                                 const fxl_model *model);

/* What is left of an object, from on->place->faces on: all of its faces, counted, by number
 * or by distance, in the order of the method. False where it was stopped. */
bool fxl_walk_object(const fxl_walk *on, const fxl_order_entry *entry);

/* fxl_hidden.walk: the objects in sight by layer and distance. */
bool fxl_walk_by_distance(const fxl_walk *on);

/* What the list holds of the band. False where the painter's room is full. */
bool fxl_walk_list(const fxl_walk *on);

/* The list, then the rest of the scene, into a part of a frame. False where the
 * painter's room is full: what was counted is then to be forgotten. */
bool fxl_draw_part(fxl_renderer *renderer, const fxl_band *part);

/* fxl_painter.draw: where the room is full the band is drawn again in halves, and so on;
 * counted in split_bands. Requires room for any one row. */
void fxl_draw_in_parts(fxl_renderer *renderer, const fxl_band *band);

/* --- a face in several pieces ---------------------------------------------- */

/* What became of a face's polygons, piece by piece: bits, 1 << fxl_clip_result and these. */
typedef uint32_t fxl_fate;
#define FXL_FATE_SPILLED ((fxl_fate)1 << 30) /* one was painted that is not in the list */
#define FXL_FATE_NO_ROOM ((fxl_fate)1 << 31) /* all else is to be forgotten */

/* transform, clip and project -> list or band, for every polygon that a face gives. */
fxl_fate fxl_walk_polygons(const fxl_walk *on, const fxl_placed *placed, const fxl_face *face);

/* Counts a face in everything but `in`: refused where a polygon of it was, else drawn where
 * one was. False where there was no room: then it counts nothing, and takes the list back
 * to what was used of it. */
bool fxl_walk_account(const fxl_walk *on, fxl_fate fate, uint32_t used);

/* Counted once; in the list wholly or not at all. The caller owns it. */
typedef struct {
    const fxl_walk *on;
    fxl_planes planes; /* that pieces may cross; begin sets all, narrowing it saves time */
    fxl_fate fate;
    uint32_t used; /* of the list, before */
} fxl_pieces;

void fxl_walk_pieces_begin(fxl_pieces *pieces, const fxl_walk *on);

/* A piece: a convex polygon of the world, 3 <= count <= FXL_POLYGON_CAPACITY vertices, each
 * within FXL_COORDINATE_MAX. What the clipper cannot take in has too many, and is refused.
 * False where there is no room: no more pieces need be given. */
bool fxl_walk_piece(fxl_pieces *pieces, const fxl_point *points, uint32_t count, uint8_t colour);

/* Counts the face: drawn where a piece was, refused where one was refused, else outside or
 * degenerate; clipped where the clipper cut a piece. False where there was no room: then
 * nothing is counted, and the list is as it was. */
bool fxl_walk_pieces_end(fxl_pieces *pieces);

/* --- light ------------------------------------------------------------------ */

/* What splits faces into those of a beam and others. Who makes one puts it first in a
 * record of its own; renderer->light points there. */
struct fxl_light {
    /* Whether the beam may reach a sphere of the world. */
    bool (*reaches)(const fxl_light *light, const fxl_point *centre, fxl_q16_16 radius);
    /* What takes the faces of an object that it may reach:
     * fxl_walk_lit_face, or one's own. */
    fxl_face_taker face;
    /* Gives what it makes of a polygon of the world, a piece or all of a face, to
     * fxl_walk_piece. False where that says so. */
    bool (*split)(const fxl_light *light, fxl_pieces *pieces, const fxl_face *face,
                  const fxl_point *points, uint32_t count);
};

/* fxl_light.face: the face's polygon of the world, split, counted once. */
bool fxl_walk_lit_face(const fxl_walk *on, const fxl_placed *placed, const fxl_face *face);

#endif

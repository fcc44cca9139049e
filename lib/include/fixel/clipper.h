/* SPDX-License-Identifier: MIT */
/* The treaty of the clippers: a face of a placed object in, a polygon of the
 * screen out, since some project before they have cut every side. Which one a
 * renderer uses is a field of it; one that is not named is not linked. */
#ifndef FXL_CLIPPER_H
#define FXL_CLIPPER_H

#include "fixel/clip_view.h"
#include "fixel/placed.h"

/* Room for any clipper: 72 bytes a vertex of the capacity, and 16. */
typedef union {
    fxl_clip_view_work by_view;
    fxl_clip_work by_world;
} fxl_clipper_work;

/* Takes a face from its object to the screen. *screen is written for
 * FXL_CLIP_INSIDE and FXL_CLIP_CUT; else its points mean nothing. Contents of
 * work mean nothing between calls. Requires a placed object of a checked scene,
 * whose planes may leave out those that all its vertices are inside of. */
typedef fxl_clip_result (*fxl_clipper)(const fxl_placed *placed, const fxl_face *face,
                                       fxl_clipper_work *work, fxl_screen_polygon *screen);

/* Transform, then clip on exact sums: the precise way, and what a renderer
 * uses unless told otherwise. Outline on the screen within 1.25/65536 pixel of
 * the exact one, but for what SPEC.md, chapter 6a, excepts. */
fxl_clip_result fxl_clip_by_view(const fxl_placed *placed, const fxl_face *face,
                                 fxl_clipper_work *work, fxl_screen_polygon *screen);

/* The chapter's way: clip in the world in 16.16, then transform what is left.
 * Fewer vertices are transformed; a clipped vertex errs by up to about
 * focal / (65536 near) pixels on the screen. */
fxl_clip_result fxl_clip_by_world(const fxl_placed *placed, const fxl_face *face,
                                  fxl_clipper_work *work, fxl_screen_polygon *screen);

/* The family's clippers (SPEC.md, chapter 6b). Each needs room in placed->view->room
 * (clipper_room.h), cleared before its first frame. */
fxl_clip_result fxl_clip_by_normalised(const fxl_placed *placed, const fxl_face *face,
                                       fxl_clipper_work *work, fxl_screen_polygon *screen);
fxl_clip_result fxl_clip_by_once(const fxl_placed *placed, const fxl_face *face,
                                 fxl_clipper_work *work, fxl_screen_polygon *screen);
fxl_clip_result fxl_clip_by_half_spaces(const fxl_placed *placed, const fxl_face *face,
                                        fxl_clipper_work *work, fxl_screen_polygon *screen);
fxl_clip_result fxl_clip_by_near(const fxl_placed *placed, const fxl_face *face,
                                 fxl_clipper_work *work, fxl_screen_polygon *screen);
fxl_clip_result fxl_clip_by_left(const fxl_placed *placed, const fxl_face *face,
                                 fxl_clipper_work *work, fxl_screen_polygon *screen);
fxl_clip_result fxl_clip_by_triangles(const fxl_placed *placed, const fxl_face *face,
                                      fxl_clipper_work *work, fxl_screen_polygon *screen);
bool fxl_next_by_triangles(const fxl_placed *placed, fxl_clipper_work *work,
                           fxl_screen_polygon *screen);

#endif

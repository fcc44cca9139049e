/* SPDX-License-Identifier: MIT */
/* The treaty of the clippers: a face of a placed object in, a polygon of the
 * screen out, since some project before they have cut every side. Which one a
 * renderer uses is a field of it; one that is not named is not linked. */
#ifndef FXL_CLIPPER_H
#define FXL_CLIPPER_H

#include "fixel/stage/clip_view.h"
#include "fixel/stage/model_view.h"

/* The same for the clipper of the world (extra/clippers/clip_world.h). */
typedef struct {
    fxl_polygon polygons[2];
    fxl_q18_46 distances[FXL_POLYGON_CAPACITY];
} fxl_clip_world_work;

/* Room for any clipper: 56 bytes a vertex of the capacity, and 16. */
typedef union {
    fxl_clip_view_work by_view;
    fxl_clip_world_work by_world;
} fxl_clipper_work;

/* A clipper. Requires a placed object of a checked scene or a placed polygon, whose planes
 * may leave out those that all its vertices are inside of. Contents of work mean nothing
 * between calls: what is to last lies in placed->view->room, which is zeroed when the clipper
 * is set; placed->view->frame tells one frame from the next, and is never 0. */
typedef struct {
    /* Takes a face from its object to the screen. *screen is written for
     * FXL_CLIP_INSIDE, FXL_CLIP_CUT and FXL_CLIP_BETWEEN; else its points mean nothing. */
    fxl_clip_result (*clip)(const fxl_model_view *model_view, const fxl_face *face,
                            fxl_clipper_work *work, fxl_screen_polygon *screen);
    /* Null where a face gives one polygon at most. Else it is called after clip gave
     * FXL_CLIP_INSIDE or FXL_CLIP_CUT, and gives the face's next polygon by one of these;
     * any other: there is none. After
     * FXL_CLIP_CAPACITY or FXL_CLIP_RANGE the face is counted as refused, though some of it
     * may be drawn. */
    fxl_clip_result (*next)(const fxl_model_view *model_view, fxl_clipper_work *work,
                            fxl_screen_polygon *screen);
    uint32_t workspace_size; /* bytes of the caller's memory, aligned to 8, that it wants */
    /* Sets up what it wants of a frame, once the view has its pose. Null: nothing. */
    void (*begin)(fxl_view *view);
} fxl_clipper;

extern const fxl_clipper fxl_clipper_view;  /* fxl_clip_by_view: used unless told otherwise */
extern const fxl_clipper fxl_clipper_world; /* fxl_clip_by_world */
/* Both work without room; given an fxl_clip_stats, they count in it. */

/* Transform, then clip on exact sums: the precise way. Outline on the screen within 1.25/65536
 * pixel of the exact one, but for what docs/accuracy.md, section 3, excepts. */
fxl_clip_result fxl_clip_by_view(const fxl_model_view *model_view, const fxl_face *face,
                                 fxl_clipper_work *work, fxl_screen_polygon *screen);

/* The chapter's way: clip in the world in 16.16, then transform what is left.
 * Fewer vertices are transformed; a clipped vertex errs by up to about
 * focal / (65536 near) pixels on the screen. */
fxl_clip_result fxl_clip_by_world(const fxl_model_view *model_view, const fxl_face *face,
                                  fxl_clipper_work *work, fxl_screen_polygon *screen);

/* The family's clippers (docs/extras/clippers.md), each with room of its own (clipper_room.h). */
extern const fxl_clipper fxl_clipper_normalised; /* planes at x = +-z: codes without a product */
extern const fxl_clipper fxl_clipper_once;       /* all planes in one pass */
extern const fxl_clipper
    fxl_clipper_half_spaces;                    /* six homogeneous half-spaces, whatever they be */
extern const fxl_clipper fxl_clipper_triangles; /* triangles; borders in two dimensions */
extern const fxl_clipper fxl_clipper_near;      /* near and far alone: the scan does the rest */
extern const fxl_clipper fxl_clipper_left;      /* the same, and the left side */

#endif

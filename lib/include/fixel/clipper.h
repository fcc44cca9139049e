/* SPDX-License-Identifier: MIT */
/* The treaty of the clippers: a polygon of the world in, a clipped polygon of
 * the view out. Which one a renderer uses is a field of it; one that is not
 * named is not linked. */
#ifndef FXL_CLIPPER_H
#define FXL_CLIPPER_H

#include "fixel/clip_view.h"
#include "fixel/transform.h"

/* What a frame's stages share: set up once a frame. */
typedef struct {
    fxl_camera camera;
    fxl_lens lens;
    fxl_frustum frustum;           /* planes of the world */
    fxl_view_frustum view_frustum; /* the same in the view */
} fxl_view;

/* Room for any clipper: 72 bytes a vertex of the capacity, and 16. Only one of
 * the members is alive at a time. */
typedef union {
    fxl_polygon polygon; /* where a clipper's input may lie */
    fxl_clip_view_work by_view;
    fxl_clip_work by_world;
    struct {
        fxl_polygon polygons[2]; /* the same as those of by_world */
        fxl_view_polygon view;   /* over its distances, which are used up by then */
    } from_world;
} fxl_clipper_work;

/* Clips a polygon to the frame's frustum and transforms it, in whichever order.
 * The polygon may be work->polygon: it is then lost. *result points into work,
 * and is null unless the answer is FXL_CLIP_INSIDE or FXL_CLIP_CUT. Requires
 * what fxl_clip_to_plane requires. */
typedef fxl_clip_result (*fxl_clipper)(const fxl_polygon *polygon, const fxl_view *view,
                                       fxl_clipper_work *work, const fxl_view_polygon **result);

/* Transform, then clip on exact sums: the precise way, and what a renderer
 * uses unless told otherwise. Outline on the screen within 1.25/65536 pixel of
 * the exact one, but for what SPEC.md, chapter 6a, excepts. */
fxl_clip_result fxl_clip_by_view(const fxl_polygon *polygon, const fxl_view *view,
                                 fxl_clipper_work *work, const fxl_view_polygon **result);

/* The chapter's way: clip in the world in 16.16, then transform what is left.
 * Fewer vertices are transformed; a clipped vertex errs by up to about
 * focal / (65536 near) pixels on the screen. */
fxl_clip_result fxl_clip_by_world(const fxl_polygon *polygon, const fxl_view *view,
                                  fxl_clipper_work *work, const fxl_view_polygon **result);

#endif

/* SPDX-License-Identifier: MIT */
/* The other clippers (docs/extras/clippers.md): their records, and their workspaces, for use with a
 * renderer. Each workspace begins with an fxl_clip_stats: the caller may set its slivers and read
 * its counters. */
#ifndef FXL_CLIPPERS_H
#define FXL_CLIPPERS_H

#include "../clip/volume.h"
#include "clip_once.h"
#include "triangle.h"

/* The workspace of fxl_clipper_normalised. frame is the view's frame that the rest was made for;
 * 0: none. */
typedef struct {
    fxl_clip_workspace clip;
    uint32_t frame;
    fxl_normalised frustum;
} fxl_normalised_workspace;

/* The workspace of fxl_clipper_once. */
typedef struct {
    fxl_clip_once_workspace clip;
    uint32_t frame;
    fxl_normalised frustum;
    fxl_varying_polygon in;
} fxl_once_workspace;

/* place clipper: the declaration of the new one */
/* place clipper: only if its workspace is of a new type */
/* The workspace of fxl_clipper_half_spaces, fxl_clipper_near and fxl_clipper_left. */
typedef struct {
    fxl_clip_workspace clip;
    uint32_t frame;
    uint32_t screen; /* near and left alone: the planes at the borders of the screen */
    fxl_volume volume;
} fxl_volume_workspace;

/* The workspace of fxl_clipper_triangles. A face is a fan of triangles, some of which are done.
 * clip.screen_sliver is the sliver rule of the borders. */
typedef struct {
    fxl_triangle_workspace clip;
    uint32_t frame;
    fxl_volume volume;
    const fxl_face *face;
    uint32_t corner; /* number in the face of the last vertex of the next triangle */
    fxl_cached_vertex first, before;
} fxl_fan_workspace;

/* A workspace that is large enough for any of these clippers. */
typedef union {
    fxl_clip_stats stats;
    fxl_normalised_workspace normalised;
    fxl_once_workspace once;
    fxl_volume_workspace volume;
    fxl_fan_workspace fan;
} fxl_clipper_workspace;

#ifdef __cplusplus
extern "C" {
#endif

/* fxl_clip_by_world. It needs no workspace; it counts in one as fxl_clipper_view does. */
extern const fxl_clipper fxl_clipper_world;

/* Each of these needs a workspace of its own. */
extern const fxl_clipper fxl_clipper_normalised;  /* planes at x = +-z: outcodes need no product */
extern const fxl_clipper fxl_clipper_once;        /* all planes in one pass */
extern const fxl_clipper fxl_clipper_half_spaces; /* any six homogeneous half-spaces */
extern const fxl_clipper fxl_clipper_triangles;   /* triangles; borders in two dimensions */
extern const fxl_clipper fxl_clipper_near;        /* near and far alone: the scan does the rest */
extern const fxl_clipper fxl_clipper_left;        /* near, far and the left side */

/* The function clip of fxl_clipper_world, the Black Book's clipper. It clips in the world in 16.16,
 * then transforms what is left, so it transforms fewer vertices.
 * Error: a clipped vertex is off by up to about focal / (65536 near) pixels on the screen.
 * Source: A2. */
fxl_clip_result fxl_clip_by_world(const fxl_model_view *model_view, const fxl_face *face,
                                  fxl_clipper_work *work, fxl_screen_polygon *screen);

#ifdef __cplusplus
}
#endif

#endif

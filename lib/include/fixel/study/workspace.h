/* SPDX-License-Identifier: MIT */
/* The workspaces of the other clippers, for use with a renderer. Each begins with an
 * fxl_clip_stats: the caller may set its slivers and read its counters. */
#ifndef FXL_CLIPPER_WORKSPACE_H
#define FXL_CLIPPER_WORKSPACE_H

#include "fixel/study/clip_once.h"
#include "fixel/half_space.h"
#include "fixel/stage/model_view.h"
#include "fixel/study/triangle.h"

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

#endif

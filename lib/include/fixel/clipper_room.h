/* SPDX-License-Identifier: MIT */
/* What the family's clippers want of the caller's memory when they serve a renderer.
 * Each begins with its account: the caller may set its slivers, and reads what it counts. */
#ifndef FXL_CLIPPER_ROOM_H
#define FXL_CLIPPER_ROOM_H

#include "fixel/clip_once.h"
#include "fixel/half_space.h"
#include "fixel/placed.h"
#include "fixel/triangle.h"

/* Of fxl_clipper_normalised. frame: the view's, that the rest is set up for; 0: none. */
typedef struct {
    fxl_clip_room clip;
    uint32_t frame;
    fxl_normalised frustum;
} fxl_normalised_room;

/* Of fxl_clipper_once. */
typedef struct {
    fxl_clip_once_room clip;
    uint32_t frame;
    fxl_normalised frustum;
    fxl_clip_polygon in;
} fxl_once_room;

/* Of fxl_clipper_half_spaces, fxl_clipper_near and fxl_clipper_left. */
typedef struct {
    fxl_clip_room clip;
    uint32_t frame;
    uint32_t screen; /* planes that are cut where the screen ends; of near and left alone */
    fxl_volume volume;
} fxl_volume_room;

/* Of fxl_clipper_triangles: a face is a fan, of which some triangles are done. The
 * slivers of the borders are clip.screen_sliver. */
typedef struct {
    fxl_triangle_room clip;
    uint32_t frame;
    fxl_volume volume;
    const fxl_face *face;
    uint32_t corner; /* of the face, the last of the triangle that comes next */
    fxl_seen_vertex first, before;
} fxl_fan_room;

/* For who tries one after the other. */
typedef union {
    fxl_clip_account account;
    fxl_normalised_room normalised;
    fxl_once_room once;
    fxl_volume_room volume;
    fxl_fan_room fan;
} fxl_clipper_room;

#endif

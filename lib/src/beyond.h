/* SPDX-License-Identifier: MIT */
/* The clippers that leave sides of the screen to the scan: near and far are cut, and
 * of the sides those that are given; of the others only what is beyond the guard band.
 * Internal. */
#ifndef FXL_BEYOND_H
#define FXL_BEYOND_H

#include "fixel/clipper.h"
#include "fixel/clipper_room.h"

/* fxl_clipper.clip, with an fxl_volume_room. screen: the planes that are cut, near and far
 * among them; a room is of one clipper, so they are always the same. */
fxl_clip_result fxl_clip_beyond(const fxl_placed *placed, const fxl_face *face, unsigned screen,
                                fxl_screen_polygon *polygon);

#endif

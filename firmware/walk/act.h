/* SPDX-License-Identifier: MIT */
/* What happens in the scene from frame to frame. A program links one act: the scene's own path and
 * motions (firmware/walk/act_path.c), or a game (firmware/game/act_game.c). */
#ifndef WALK_ACT_H
#define WALK_ACT_H

#include "fixel/setup.h"
#include "path.h"

/* Bytes of memory of its own that the act wants for a scene: a multiple of 8. */
uint32_t act_bytes(const fxl_scene_image *image);

/* Before the renderer is set up. memory: act_bytes, aligned to 8, for as long as the program runs.
 * Into *plan, which is all zeros, go the motions of the image, or the scene of the act's that the
 * renderer is to draw in the place of the image's. */
fxl_status act_open(const fxl_scene_image *image, void *memory, fxl_setup_plan *plan);

/* After the renderer is set up, before the first frame. */
fxl_status act_attach(fxl_renderer *renderer);

/* Goes on to the next frame of what was set up; path->viewer.pose is then the eye. frame: its number,
 * from 0. held: the keys of a player, where walk_path_wants_keys. */
fxl_status act_step(fxl_setup *setup, walk_path *path, uint32_t frame, uint32_t held);

/* Draws over a band, which has the 3-D picture. */
fxl_status act_draw_over(const fxl_band *band, const fxl_lens *lens);

/* After the last band of a frame. */
fxl_status act_end(fxl_renderer *renderer);

#endif

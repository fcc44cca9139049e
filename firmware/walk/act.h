/* SPDX-License-Identifier: MIT */
/* What happens in the scene from frame to frame. A program links one act: the camera's path alone
 * (firmware/walk/act_path.c), or a game (firmware/game/act_game.c). */
#ifndef WALK_ACT_H
#define WALK_ACT_H

#include "fixel/render.h"
#include "path.h"

/* Before the renderer is set up. *scene is then what it is to draw: the image's own scene, or
 * another one of the act's. */
fxl_status act_open(const fxl_scene_image *image, const fxl_scene **scene);

/* After the renderer is set up, before the first frame. */
fxl_status act_attach(fxl_renderer *renderer);

/* Goes on to the next frame; path->viewer.pose is then the eye. held: the keys of a player, where
 * walk_path_wants_keys. */
fxl_status act_step(walk_path *path, uint32_t held);

/* Draws over a band, which has the 3-D picture. */
fxl_status act_draw_over(const fxl_band *band, const fxl_lens *lens);

#endif

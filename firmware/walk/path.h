/* SPDX-License-Identifier: MIT */
/* Where the eye is in each frame: the scene's path, then the player's keys. */
#ifndef WALK_PATH_H
#define WALK_PATH_H

#include "fixel/scene.h"

typedef struct {
    const fxl_scene_image *image;
    fxl_player viewer;
    uint32_t frame;       /* of the path, the next one */
    uint32_t stride;      /* the one under way */
    uint32_t stride_left; /* frames of it still to come */
    bool live;            /* no path: keys from the first frame on */
} walk_path;

/* Begins at the scene's start pose. Requires an image that fxl_scene_open
 * opened and that outlives the path. */
void walk_path_begin(walk_path *path, const fxl_scene_image *image, bool live);

/* Whether the next frame's pose depends on the keys that are held. */
bool walk_path_wants_keys(const walk_path *path);

/* Moves on to the next frame; its pose is then path->viewer.pose. A path of
 * poses gives its poses; a path of strides walks; after either, and where the
 * path is live, held decides.
 * What fxl_player_step answers; on an error the viewer stays. */
fxl_status walk_path_next(walk_path *path, uint32_t held);

#endif

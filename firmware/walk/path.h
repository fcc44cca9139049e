/* SPDX-License-Identifier: MIT */
/* The pose of the eye in each frame: first the scene's path, then the player's keys. */
#ifndef WALK_PATH_H
#define WALK_PATH_H

#include "fixel/scene.h"

typedef struct {
    const fxl_pose *poses;            /* of the scene's path; null if it is segments */
    const fxl_path_segment *segments; /* null if it is poses */
    uint32_t frame_count;             /* of the whole path */
    fxl_motion_limits motion_limits;
    fxl_player viewer;
    uint32_t frame;       /* the number of the next frame of the path */
    uint32_t stride;      /* the current segment */
    uint32_t stride_left; /* frames of that segment that are left */
    bool live;            /* no path: the keys decide from the first frame on */
} walk_path;

/* Begins at the scene's start pose. Requires an image that fxl_scene_open opened. Its bytes outlive the
 * path, *image need not. */
void walk_path_begin(walk_path *path, const fxl_scene_image *image, bool live);

/* Tells whether the pose of the next frame depends on the keys that are held. */
bool walk_path_wants_keys(const walk_path *path);

/* The keys of the next frame, to which it advances: those of a path of segments, and after it, and
 * where the path is live, those that are held. */
uint32_t walk_path_keys(walk_path *path, uint32_t held);

/* Advances to the next frame; its pose is then path->viewer.pose. A path of poses gives its
 * poses; a path of segments moves the player. After the path, and where the path is live, held
 * decides. Returns the result of fxl_player_step. On an error the player does not move. */
fxl_status walk_path_next(walk_path *path, uint32_t held);

#endif

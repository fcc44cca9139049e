/* SPDX-License-Identifier: MIT */
#include "path.h"

#include "fixel/player.h"

void walk_path_begin(walk_path *path, const fxl_scene_image *image, bool live)
{
    path->poses = image->poses;
    path->segments = image->segments;
    path->frame_count = image->frame_count;
    path->motion_limits = image->motion_limits;
    path->viewer = image->start;
    path->frame = 0;
    path->stride = 0;
    path->stride_left = image->segments != NULL ? image->segments[0].frames : 0;
    path->live = live;
}

bool walk_path_wants_keys(const walk_path *path)
{
    return path->live || path->frame >= path->frame_count;
}

static uint32_t stride_keys(walk_path *path)
{
    const fxl_path_segment *strides = path->segments;

    if (path->stride_left == 0) {
        path->stride++; /* < path_count, since frame < frame_count */
        path->stride_left = strides[path->stride].frames;
    }
    path->stride_left--;
    return strides[path->stride].keys;
}

uint32_t walk_path_keys(walk_path *path, uint32_t held)
{
    if (path->segments == NULL || walk_path_wants_keys(path)) {
        return held;
    }
    path->frame++;
    return stride_keys(path);
}

fxl_status walk_path_next(walk_path *path, uint32_t held)
{
    if (path->poses != NULL && !walk_path_wants_keys(path)) {
        path->viewer.pose = path->poses[path->frame];
        path->frame++;
        return FXL_OK;
    }
    return fxl_player_step(&path->viewer, walk_path_keys(path, held), &path->motion_limits,
                           NULL);
}

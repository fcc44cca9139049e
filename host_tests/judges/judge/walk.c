/* SPDX-License-Identifier: MIT */
#include "judge/walk.h"

#include <math.h>

static bool same_angles(const ref_pose *pose, ref_angle yaw, ref_angle pitch, ref_angle roll)
{
    return pose->yaw == yaw && pose->pitch == pitch && pose->roll == roll;
}

static const char *compare_poses(const ref_scene_image *image, const judge_dump *dump,
                                 uint32_t *frame)
{
    for (*frame = 0; *frame < dump->frame_count; ++*frame) {
        ref_pose pose = judge_dump_pose(dump, *frame);
        const ref_pose *stated = &image->poses[*frame];
        if (!same_angles(&pose, stated->yaw, stated->pitch, stated->roll) ||
            pose.position.x != stated->position.x || pose.position.y != stated->position.y ||
            pose.position.z != stated->position.z) {
            return "its pose is not the one that the scene states";
        }
    }
    return NULL;
}

static double error_units(double exact, int32_t units)
{
    return fabs(exact * REF_ONE - units);
}

static const char *compare_segments(const ref_scene_image *image, const judge_dump *dump,
                                    judge_walk *walk, uint32_t *frame)
{
    ref_player player = ref_player_at(&image->start);
    const ref_path_segment *segment = image->segments;
    uint32_t done = 0; /* frames of this segment */
    for (*frame = 0; *frame < dump->frame_count; ++*frame) {
        while (done == segment->frames) {
            segment++;
            done = 0;
        }
        double pushed = fmin(image->motion_limits.speed_max,
                             fabs(player.speed) + image->motion_limits.acceleration);
        ref_player_step(&player, segment->keys, &image->motion_limits);
        done++;
        walk->max_bound += 0.51 + pushed * REF_ONE * 0x1p-29;

        ref_pose pose = judge_dump_pose(dump, *frame);
        if (!same_angles(&pose, player.yaw, player.pitch, player.roll)) {
            return "its angles are not those that the scene's keys give";
        }
        double error = fmax(error_units(player.position.x, pose.position.x),
                            fmax(error_units(player.position.y, pose.position.y),
                                 error_units(player.position.z, pose.position.z)));
        walk->max_error = fmax(walk->max_error, error);
        walk->frames_beyond_bound += error > walk->max_bound;
    }
    return NULL;
}

const char *judge_walk_compare(const ref_scene_image *image, const judge_dump *dump,
                               judge_walk *walk, uint32_t *frame)
{
    *walk = (judge_walk){.frames = dump->frame_count};
    return image->poses ? compare_poses(image, dump, frame)
                        : compare_segments(image, dump, walk, frame);
}

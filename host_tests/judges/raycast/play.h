/* SPDX-License-Identifier: MIT */
/* Where the turned instances of a scene image are in a frame (docs/extras/motion.md), in double. */
#ifndef RAYCAST_PLAY_H
#define RAYCAST_PLAY_H

#include <stdint.h>

#include "vector.h"

/* A point v of the model is at centre + scale * (rows . v). */
typedef struct {
    vector centre, rows[3];
    double scale;
} placing;

/* The tables of an image that say how instances are turned and move: of the last placement_count
 * instances, and of the last motion_count of those. Checked by the caller. */
typedef struct {
    const uint8_t *instances, *placements, *motions, *keys;
    uint32_t instance_count, placement_count, motion_count, key_count;
} play_tables;

/* Writes where each instance is in a frame. Does not return if a motion makes no sense. */
void play_frame(const play_tables *of, uint32_t frame, placing *places);

vector placing_point(const placing *at, vector point);

#endif

/* SPDX-License-Identifier: MIT */
/* A scene of the reference renderer in which things move: the library plays the motions of the
 * image, and the reference takes its integers. The ray-cast oracle plays them by itself. */
#ifndef FRAMES_MOVING_REFERENCE_H
#define FRAMES_MOVING_REFERENCE_H

#include "fixel/motion.h"
#include "reference/scene.h"

typedef struct {
    ref_scene scene; /* that of the image, with instances and placements of its own */
    bool moves;      /* false: the scene is that of the image */
    fxl_scene moved;
    fxl_instance *instances;
    fxl_placement *placements;
    fxl_motion_player player;
} moving_reference;

/* Makes a scene that moves of an image and its bytes, aligned to four; both must outlive it.
 * Returns false where memory is short, or where the library refuses the image;
 * moving_reference_close is then due too. */
bool moving_reference_open(moving_reference *moving, const ref_scene_image *of,
                           const uint8_t *bytes, size_t size);

/* Moves what moves to where it is in a frame. */
void moving_reference_play(moving_reference *moving, uint32_t frame);

void moving_reference_close(moving_reference *moving);

#endif

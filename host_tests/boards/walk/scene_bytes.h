/* SPDX-License-Identifier: MIT */
/* A small scene image (docs/formats.md, section 1), made in memory. */
#ifndef SCENE_BYTES_H
#define SCENE_BYTES_H

#include <stdint.h>

#include "fixel/scene.h"

#define SCENE_WIDTH      64
#define SCENE_HEIGHT     40
#define SCENE_BACKGROUND 3
#define SCENE_COLOUR     9

typedef struct {
    uint32_t words[1024]; /* aligned as an image must be */
    uint32_t size;        /* bytes */
} scene_bytes;

/* objects squares that face the eye, one behind the other, and a path: poses
 * or strides, the other null; count entries, 1 to 8. */
void scene_bytes_make(scene_bytes *scene, uint32_t instances, const fxl_pose *poses,
                      const fxl_path_segment *strides, uint32_t count);

#endif

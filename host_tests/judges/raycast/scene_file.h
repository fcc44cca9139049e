/* SPDX-License-Identifier: MIT */
/* A scene image (docs/formats.md, section 1) as the polygons of a world, in any frame. */
#ifndef RAYCAST_SCENE_FILE_H
#define RAYCAST_SCENE_FILE_H

#include "play.h"
/* place field: the ray-cast oracle's reader: sizes */
#include "scene_sections.h"
#include "world.h"

/* What a pixel is: a colour; or the name of a face (reference/render.h), of all faces or of those
 * through which nothing is seen. */
typedef enum {
    SCENE_COLOURS,
    SCENE_NAMES_ALL,
    SCENE_NAMES_OPAQUE
} scene_names;

typedef struct {
    uint32_t width, height;
    double focal;              /* pixels */
    double near, far;          /* the visible depths, with the inset taken off */
    double centre_x, centre_y; /* pixels: where the screen is straight ahead */
    double scale;              /* pixels a world unit, of an orthographic lens; else 0 */
    uint8_t background;
    table horizon, levels; /* sines in 2.30; colours, one more; empty: the background is seen */
    world world;
    struct reader *image; /* of which scene_play makes the world anew */
    bool moves;
    light_tables light;
} scene;

/* Reads a scene image. Does not return if the image is unusable. */
scene scene_read(const char *path, scene_names names);

/* Makes the world of a frame. */
void scene_play(scene *s, uint32_t frame);

/* Colours the world's faces as a scene's light shows them to an eye that looks along forward, if
 * the scene has light. */
void scene_light(scene *s, vector eye, vector forward);

#endif

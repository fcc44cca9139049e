/* SPDX-License-Identifier: MIT */
/* A scene of three walls, drawn in frames of 16 bits a pixel. */
#ifndef RGB565_SCENE_H
#define RGB565_SCENE_H

#include "unit.h"

enum {
    WIDTH = 50,
    HEIGHT = 34,
    BACKGROUND = 3
};

/* Three walls one behind the other, each of a model of its own and of the colours 20, 21 and 22.
 * The first one has the texture, and the second one may have surface[1]. */
typedef struct {
    uint8_t texels[16 * 16 + 8 * 8];
    uint16_t texels_565[16 * 16 + 8 * 8], palette[256];
    fxl_texture texture;
    fxl_surface surface[2];
    fxl_mapped_face mapped[2];
    fxl_corner mapped_corners[2][3];
    uint16_t face_map[3];
    fxl_surface_set set;
    fxl_scene scene;
    fxl_renderer renderer;
    fxl_surfaces surfaces;
    fxl_lit_surfaces lit;
    uint8_t indexed[HEIGHT * WIDTH];
    uint16_t pixels[HEIGHT * WIDTH], again[HEIGHT * WIDTH];
} rgb565_walls;

extern rgb565_walls walls;
extern const fxl_pose walls_eye;

/* The tables as they are at first, which a test may change before it starts, and a renderer of a
 * palette. */
void walls_make(void);

/* Sets the renderer up anew, without surfaces. */
void walls_start(const fxl_target *target);

/* A texture of a format: each shows the same colours. */
void walls_make_texture(uint8_t format);

/* Frames of 16 bits a pixel, with the surfaces. */
void walls_begin(void);

/* The other walls in one colour, without light. */
void walls_hide_others(uint16_t colour);

/* Attaches a light, which surfaces take at their corners. */
void walls_light(const fxl_light_settings *settings);

/* Draws a frame. */
void walls_draw(uint16_t *to);

#endif

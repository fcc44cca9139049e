/* SPDX-License-Identifier: MIT */
/* A scene whose faces hide parts of each other, and a renderer with a depth buffer that draws it.
 */
#ifndef DEPTH_SCENE_H
#define DEPTH_SCENE_H

#include "unit.h"

enum {
    DEPTH_SCENE_WIDTH = 48,
    DEPTH_SCENE_HEIGHT = 36,
    DEPTH_SCENE_BACKGROUND = 255,
    DEPTH_SCENE_QUADS = 3
};

/* The tables, which a test may change before it starts. */
typedef struct {
    fxl_scene scene;
    fxl_config config;
    uint8_t texels[8 * 8];
    fxl_texture texture;
    fxl_surface surface;
    fxl_mapped_face mapped;
    fxl_corner mapped_corners[3];
    uint16_t face_map[DEPTH_SCENE_QUADS]; /* all 0: no face has the texture */
    fxl_surface_set set;
    fxl_renderer renderer;
    fxl_surfaces surfaces;
    bool is_mapped; /* the start attaches the surfaces */
    FXL_ALIGN_8 uint8_t memory[1024];
    FXL_ALIGN_8 uint8_t cells[FXL_DEPTH_BYTES(DEPTH_SCENE_WIDTH, DEPTH_SCENE_HEIGHT, 16)];
    FXL_ALIGN_8 uint8_t room[8192]; /* of clippers, beams, another workspace */
    uint8_t frame[DEPTH_SCENE_WIDTH * DEPTH_SCENE_HEIGHT];
    uint8_t again[DEPTH_SCENE_WIDTH * DEPTH_SCENE_HEIGHT];
} depth_scene;

extern const fxl_pose depth_scene_eye;

/* A floor that runs behind the eye, a wall across the view, and a slanted one that meets both: in
 * any order of drawing one of them covers a part of another that is nearer. Answers the scene, of
 * which there is one. */
depth_scene *depth_scene_make(void);

/* Checks the scene and sets up the renderer; with a target of a palette and a depth buffer. */
void depth_scene_start(depth_scene *made);
void depth_scene_start_with(depth_scene *made, const fxl_target *target);

/* Draws the whole frame from the eye. */
void depth_scene_draw(depth_scene *made, uint8_t *frame);

/* Draws in bands of so many rows, with a display list of so many words: the pixels of `frame`. */
void depth_scene_draw_in_bands(depth_scene *made, uint16_t rows, uint32_t list_words);

/* The same, of a depth buffer of one row to all, after a start each. Draws `frame`. */
void depth_scene_check_bands(depth_scene *made, const fxl_target *target);

#endif

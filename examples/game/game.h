/* SPDX-License-Identifier: MIT */
/* A game: rocks drift towards the eye, and a gun shoots them. It knows nothing of the display and
 * of the board: a program gives it the keys, and draws the world that it keeps. */
#ifndef GAME_H
#define GAME_H

#include <fixel/all.h>

#ifdef __cplusplus
extern "C" {
#endif

#define GAME_ROCKS     10
#define GAME_SHOTS     6
#define GAME_STANDING  10 /* instances of the scene that stand still */
#define GAME_INSTANCES (GAME_STANDING + GAME_SHOTS + GAME_ROCKS)

typedef struct {
    fxl_handle handle; /* zeros: there is none */
    fxl_point speed;   /* world units a frame */
    fxl_point axis;    /* that a rock turns about */
    fxl_q16_16 radius;
} game_thing;

typedef struct {
    fxl_world world;
    fxl_pose eye;
    game_thing rocks[GAME_ROCKS], shots[GAME_SHOTS];
    uint32_t random, frame, score, best;
    uint8_t lives, wait, hurt; /* frames until the next shot; that the frame is still red */
    fxl_instance instances[GAME_INSTANCES];
    fxl_world_slot slots[GAME_INSTANCES];
    fxl_placement placements[GAME_ROCKS];
} game;

/* Begins a game over the scene of game.toml. Then a renderer is initialised with
 * &state->world.scene, and attached to the world. */
fxl_status game_begin(game *state, const fxl_scene *scene, const fxl_pose *eye);

/* A step of the game: keys is an OR of FXL_KEY_... Not between fxl_frame_begin and
 * fxl_frame_end. */
fxl_status game_step(game *state, uint32_t keys);

/* Draws the sight and the score into a band that has the 3-D picture. */
fxl_status game_draw_over(const game *state, const fxl_band *band, uint16_t width, uint16_t height);

#ifdef __cplusplus
}
#endif

#endif

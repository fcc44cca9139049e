/* SPDX-License-Identifier: MIT */
#include "game.h"

#include <string.h>

enum {
    WHITE = 252,
    YELLOW,
    RED,
    BLUE
}; /* the palette's last entries: game.toml names them */
enum {
    ROCK,
    SHOT
}; /* the scene's first instances, and so their models */

#define FAR_AWAY  FXL_UNITS(70) /* where rocks come from, and shots end */
#define TURN      FXL_DEGREES(2)
#define LIVES     3
#define SHOT_WAIT 5 /* frames */

/* 0..below - 1, by a generator of period 2^32 - 1. */
static int32_t dice(game *state, int32_t below)
{
    state->random ^= state->random << 13;
    state->random ^= state->random >> 17;
    state->random ^= state->random << 5;
    return (int32_t)(state->random % (uint32_t)below);
}

/* One less, down to 0. */
static uint8_t less(uint8_t count)
{
    return (uint8_t)(count > 0 ? count - 1 : 0);
}

static bool is_there(const game *state, const game_thing *thing)
{
    return fxl_world_instance(&state->world, thing->handle) != NULL;
}

static fxl_status take_away(game *state, game_thing *thing)
{
    const fxl_handle handle = thing->handle;

    thing->handle = (fxl_handle){0, 0};
    return fxl_world_remove(&state->world, handle);
}

fxl_status game_begin(game *state, const fxl_scene *scene, const fxl_pose *eye)
{
    const fxl_world_memory memory = {.instances = state->instances,
                                     .slots = state->slots,
                                     .placements = state->placements,
                                     .capacity = GAME_STANDING + GAME_SHOTS,
                                     .turned_capacity = GAME_ROCKS,
                                     .placement_code = &fxl_turned_instances};
    fxl_status status;

    memset(state, 0, sizeof *state);
    state->eye = *eye;
    state->random = 2463534242u;
    state->lives = LIVES;
    status = fxl_world_init(&state->world, scene, &memory);
    if (status == FXL_OK) {
        status = fxl_world_remove(&state->world, fxl_world_handle(ROCK));
    }
    return status == FXL_OK ? fxl_world_remove(&state->world, fxl_world_handle(SHOT)) : status;
}

/* --- rocks --------------------------------------------------------------------------------- */

/* A rock that flies from a place in the distance to the eye, or just past it. */
static fxl_status add_rock(game *state, game_thing *rock)
{
    const fxl_point *eye = &state->eye.position;
    const int32_t steps = 160 - (state->score < 100 ? (int32_t)state->score : 100);
    const fxl_point from = {FXL_UNITS(dice(state, 61) - 30), FXL_UNITS(dice(state, 18) + 2),
                            FAR_AWAY};
    const fxl_instance instance = {.centre = from, .model = ROCK, .layer = 2};
    fxl_placement placement = {FXL_ORIENTATION_NONE, FXL_RATIO(2 + dice(state, 5), 4)};

    rock->speed.x = (eye->x + FXL_UNITS(dice(state, 9) - 4) - from.x) / steps;
    rock->speed.y = (eye->y + FXL_UNITS(dice(state, 3)) - from.y) / steps;
    rock->speed.z = (eye->z - from.z) / steps;
    rock->axis = (fxl_point){dice(state, 201) - 100, dice(state, 201) - 100, 50};
    rock->radius = FXL_RATIO(3 * (placement.scale >> 14), 8);
    return fxl_world_spawn(&state->world, &instance, &placement, &rock->handle);
}

static fxl_status turn_rock(game *state, const game_thing *rock)
{
    fxl_placement placement = *fxl_world_placement(&state->world, rock->handle);
    const fxl_status status = fxl_orientation_from_axis(&rock->axis, state->frame * FXL_DEGREES(4),
                                                        &placement.orientation);

    return status == FXL_OK ? fxl_world_set_placement(&state->world, rock->handle, &placement)
                            : status;
}

/* Where a thing is, and where its speed takes it. */
static void next_place(const game *state, const game_thing *thing, fxl_point *was, fxl_point *is)
{
    *was = fxl_world_instance(&state->world, thing->handle)->centre;
    is->x = was->x + thing->speed.x;
    is->y = was->y + thing->speed.y;
    is->z = was->z + thing->speed.z;
}

static fxl_status step_rock(game *state, game_thing *rock)
{
    const fxl_sphere eye = {state->eye.position, FXL_UNITS(2)};
    fxl_point was, is;
    fxl_status status;

    if (!is_there(state, rock)) {
        return dice(state, 40) == 0 ? add_rock(state, rock) : FXL_OK;
    }
    next_place(state, rock, &was, &is);
    if (fxl_spheres_overlap(&eye, &(fxl_sphere){is, rock->radius})) {
        state->lives = less(state->lives);
        state->hurt = 6;
        return take_away(state, rock);
    }
    if (is.z < -FXL_UNITS(6)) {
        return take_away(state, rock);
    }
    status = fxl_world_move(&state->world, rock->handle, &is);
    return status == FXL_OK ? turn_rock(state, rock) : status;
}

/* --- shots --------------------------------------------------------------------------------- */

static fxl_status add_shot(game *state)
{
    fxl_instance instance = {.centre = state->eye.position, .model = SHOT, .layer = 2};
    fxl_camera camera;
    uint32_t i = 0;

    while (i < GAME_SHOTS && is_there(state, &state->shots[i])) {
        i++;
    }
    if (i == GAME_SHOTS || fxl_camera_from_pose(&state->eye, &camera) != FXL_OK) {
        return FXL_OK;
    }
    state->wait = SHOT_WAIT;
    instance.centre.y -= FXL_UNITS(1); /* the gun is below the eye */
    state->shots[i].speed = (fxl_point){camera.axes.forward.x >> 13, camera.axes.forward.y >> 13,
                                        camera.axes.forward.z >> 13}; /* 2 units a frame */
    return fxl_world_spawn(&state->world, &instance, NULL, &state->shots[i].handle);
}

/* The rock that the way of a shot meets, or null. */
static game_thing *hit_rock(game *state, const fxl_point *was, const fxl_point *is)
{
    for (uint32_t i = 0; i < GAME_ROCKS; i++) {
        const fxl_instance *rock = fxl_world_instance(&state->world, state->rocks[i].handle);

        if (rock != NULL &&
            fxl_sphere_meets_segment(
                &(fxl_sphere){rock->centre, state->rocks[i].radius + FXL_UNITS(1)}, was, is)) {
            return &state->rocks[i];
        }
    }
    return NULL;
}

static fxl_status step_shot(game *state, game_thing *shot)
{
    fxl_point was, is;
    game_thing *rock;
    fxl_hit hit;
    fxl_status status;

    if (!is_there(state, shot)) {
        return FXL_OK;
    }
    next_place(state, shot, &was, &is);
    rock = hit_rock(state, &was, &is);
    if (rock != NULL) {
        state->score += 1;
        state->best = state->score > state->best ? state->score : state->best;
        status = take_away(state, rock);
        return status == FXL_OK ? take_away(state, shot) : status;
    }
    status = fxl_cast_segment(&state->world.scene, &was, &is, &hit); /* ground and towers */
    if (status != FXL_OK) {
        return status;
    }
    return is.z > FAR_AWAY || is.y > FAR_AWAY || hit.instance != FXL_HIT_NONE
               ? take_away(state, shot)
               : fxl_world_move(&state->world, shot->handle, &is);
}

/* --- the game ------------------------------------------------------------------------------ */

/* Turns the gun, as far as it turns. */
static void aim(game *state, uint32_t keys)
{
    const int32_t yaw = (int32_t)state->eye.yaw, pitch = (int32_t)state->eye.pitch;

    if ((keys & FXL_KEY_LEFT) != 0 && yaw > -(int32_t)FXL_DEGREES(50)) {
        state->eye.yaw -= TURN;
    }
    if ((keys & FXL_KEY_RIGHT) != 0 && yaw < (int32_t)FXL_DEGREES(50)) {
        state->eye.yaw += TURN;
    }
    if ((keys & (FXL_KEY_PITCH_UP | FXL_KEY_BACK)) != 0 && pitch < (int32_t)FXL_DEGREES(30)) {
        state->eye.pitch += TURN;
    }
    if ((keys & FXL_KEY_PITCH_DOWN) != 0 && pitch > -(int32_t)FXL_DEGREES(10)) {
        state->eye.pitch -= TURN;
    }
}

fxl_status game_step(game *state, uint32_t keys)
{
    fxl_status status = FXL_OK;

    state->frame += 1;
    state->wait = less(state->wait);
    state->hurt = less(state->hurt);
    if (state->lives == 0) { /* it is over: back begins again */
        if ((keys & FXL_KEY_BACK) != 0) {
            state->lives = LIVES;
            state->score = 0;
        }
        return FXL_OK;
    }
    aim(state, keys);
    if ((keys & FXL_KEY_FORWARD) != 0 && state->wait == 0) {
        status = add_shot(state);
    }
    for (uint32_t i = 0; i < GAME_ROCKS && status == FXL_OK; i++) {
        status = step_rock(state, &state->rocks[i]);
    }
    for (uint32_t i = 0; i < GAME_SHOTS && status == FXL_OK; i++) {
        status = step_shot(state, &state->shots[i]);
    }
    return status;
}

/* --- over the picture ---------------------------------------------------------------------- */

/* A word and a number, as text. Returns text. */
static const char *say(char text[24], const char *word, uint32_t number)
{
    uint32_t power = 1, end = 0;

    for (; word[end] != '\0'; end++) {
        text[end] = word[end];
    }
    while (number / power >= 10) {
        power *= 10;
    }
    for (; power > 0; power /= 10) {
        text[end++] = (char)('0' + number / power % 10);
    }
    text[end] = '\0';
    return text;
}

fxl_status game_draw_over(const game *state, const fxl_band *band, uint16_t width, uint16_t height)
{
    const fxl_text_style style = {&fxl_font_5x7, WHITE, 0}, loud = {&fxl_font_5x7, RED, 0};
    const int32_t x = width / 2, y = height / 2;
    char text[24];
    fxl_status status = fxl_draw_line(band, x - 5, y, x + 5, y, YELLOW);

    status |= fxl_draw_line(band, x, y - 5, x, y + 5, YELLOW);
    status |= fxl_draw_text(band, 2, 1, say(text, "SCORE ", state->score), &style);
    status |= fxl_draw_text(band, width - 40, 1, say(text, "BEST ", state->best), &style);
    for (int32_t i = 0; i < state->lives; i++) {
        status |= fxl_draw_rectangle(band, 2 + 8 * i, height - 8, 6, 6, BLUE);
    }
    if (state->hurt > 0) {
        status |= fxl_draw_border(band, 0, 0, width, height, RED);
    }
    if (state->lives == 0) {
        status |= fxl_draw_text(band, x - 28, y - 20, "GAME OVER", &loud);
    }
    return status;
}

/* SPDX-License-Identifier: MIT */
/* The act of the game: the keys of the path, or of a player, play it. */
#include "act.h"
#include "game/game.h"

static game *state;

uint32_t act_bytes(const fxl_scene_image *image)
{
    (void)image;
    return (sizeof *state + 7u) & ~7u;
}

fxl_status act_open(const fxl_scene_image *image, void *memory, fxl_setup_plan *plan)
{
    state = memory;
    plan->scene = &state->world.scene;
    return game_begin(state, &image->scene, &image->start.pose);
}

fxl_status act_attach(fxl_renderer *renderer)
{
    return fxl_world_attach(&state->world, renderer);
}

fxl_status act_step(fxl_setup *setup, walk_path *path, uint32_t frame, uint32_t held)
{
    const fxl_status status = game_step(state, walk_path_keys(path, held));

    (void)setup;
    (void)frame;
    path->viewer.pose = state->eye;
    return status;
}

fxl_status act_draw_over(const fxl_band *band, const fxl_lens *lens)
{
    return game_draw_over(state, band, lens->width, lens->height);
}

fxl_status act_end(fxl_renderer *renderer)
{
    return fxl_frame_end(renderer);
}

/* SPDX-License-Identifier: MIT */
/* The game's palette and its first frames without a key, as the library draws them in one piece, on
 * standard output. */
#include <stdio.h>

#include "game.h"
#include "game_scene.h"

static game state;
static fxl_renderer renderer;
static uint64_t memory[GAME_MEMORY_FAST];
static uint8_t pixels[240][320];

int main(void)
{
    const fxl_band screen = {.pixels = pixels[0], .width = 320, .stride = 320, .rows = 240};

    if (game_begin(&state, &game_scene, &game_start) != FXL_OK ||
        fxl_renderer_init(&renderer, &state.world.scene, &game_config, memory, sizeof memory) !=
            FXL_OK ||
        fxl_world_attach(&state.world, &renderer) != FXL_OK) {
        return 1;
    }
    (void)fwrite(game_palette, 1, sizeof game_palette, stdout);
    for (int frame = 0; frame < 3; frame++) {
        if (game_step(&state, 0) != FXL_OK ||
            fxl_render(&renderer, &state.eye, pixels[0], 320) != FXL_OK ||
            fxl_frame_end(&renderer) != FXL_OK ||
            game_draw_over(&state, &screen, 320, 240) != FXL_OK) {
            return 1;
        }
        (void)fwrite(pixels, 1, sizeof pixels, stdout);
    }
    return 0;
}

/* SPDX-License-Identifier: MIT */
/* The cube's palette and its first frames, as the library draws them in one piece, on standard
 * output. */
#include <fixel.h>
#include <stdio.h>

#include "cube_scene.h"

static fxl_renderer renderer;
static uint64_t memory[CUBE_MEMORY];
static uint8_t pixels[240][320];

int main(void)
{
    fxl_config config = cube_config;

    config.target = &fxl_palette; /* a byte a pixel */
    if (fxl_renderer_init(&renderer, &cube_scene, &config, memory, sizeof memory) != FXL_OK) {
        return 1;
    }
    (void)fwrite(cube_palette, 1, sizeof cube_palette, stdout);
    for (int frame = 0; frame < 3; frame++) {
        if (fxl_render(&renderer, &cube_path[frame], pixels, 320) != FXL_OK) {
            return 1;
        }
        (void)fwrite(pixels, 1, sizeof pixels, stdout);
    }
    return 0;
}

/* SPDX-License-Identifier: MIT */
/* The palette and the first frames of an exported scene as the library draws them in one piece,
 * entries of the palette or RGB565, on standard output. */
#include <fixel.h>
#include <stdio.h>

#include "cube_scene.h"

static fxl_setup it;
static uint64_t memory[CUBE_SETUP_MEMORY(240)];
static uint16_t pixels[240][320];

int main(void)
{
    if (fxl_setup_init(&it, &cube_setup, 240, memory, sizeof memory) != FXL_OK) {
        return 1;
    }
    (void)fwrite(cube_palette, 1, sizeof cube_palette, stdout);
    for (uint32_t frame = 0; frame < 3; frame++) {
        if (fxl_render(&it.renderer, fxl_setup_frame(&it, frame), pixels, 320) != FXL_OK) {
            return 1;
        }
        (void)fwrite(pixels, cube_config.target->pixel_bits / 8u, 320 * 240, stdout);
    }
    return 0;
}

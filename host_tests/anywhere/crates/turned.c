/* SPDX-License-Identifier: MIT */
/* The last picture of ports/rust/fixel/examples/turning.rs without its text, by the library itself:
 * RGB565 on standard output. */
#include "cube_scene.h"
#include <fixel/all.h>
#include <stdio.h>

#define STEP 11

static fxl_renderer renderer;
static uint64_t memory[4096];
static uint16_t palette[256], pixels[240 * 320];

int main(void)
{
    static fxl_instance instances[1];
    static fxl_placement placements[1] = {FXL_PLACEMENT_NONE};
    fxl_scene scene = cube_scene;
    fxl_config config = cube_config;

    for (int i = 0; i < 256; i++) {
        palette[i] = FXL_RGB565(cube_palette[i][0], cube_palette[i][1], cube_palette[i][2]);
    }
    config.target = &fxl_rgb565;
    config.palette = palette;
    instances[0] = scene.instances[0];
    if (fxl_orientation_from_angles(FXL_DEGREES(10 * STEP), FXL_DEGREES(5 * STEP), 0,
                                    &placements[0].orientation) != FXL_OK) {
        return 1;
    }
    scene.instances = instances;
    scene.placements = placements;
    scene.first_turned = 0;
    if (fxl_scene_check_all(&scene, NULL) != FXL_OK ||
        fxl_renderer_init(&renderer, &scene, &config, memory, sizeof memory) != FXL_OK ||
        fxl_render(&renderer, &cube_start, pixels, 320) != FXL_OK) {
        return 1;
    }
    return fwrite(pixels, sizeof pixels, 1, stdout) == 1 ? 0 : 1;
}

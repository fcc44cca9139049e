/* SPDX-License-Identifier: MIT */
/* The first program's cube with a small display over it, for docs/hud.png.
 * host_tests/boards/examples/frame.c runs it. */
#include <fixel.h>
#include "cube_scene.h"
#include "../../unit/hud.c"
static fxl_renderer renderer;
static uint64_t memory[CUBE_MEMORY];
static uint8_t pixels[240][320];

int main(void)
{
    const hud_colours colours = {250, 251, 252, 253, 254};
    const fxl_band whole = {.pixels = pixels[0], .width = 320, .stride = 320, .first_row = 0, .rows = 240};
    const fxl_config config = fxl_config_default(320, 240);
    const fxl_pose eye = {.position = {0, FXL_UNITS(2), FXL_UNITS(-8)}, .pitch = FXL_DEGREES(-12)};
    if (fxl_renderer_init(&renderer, &cube_scene, &config, memory, sizeof memory) != FXL_OK ||
        fxl_render(&renderer, &eye, pixels[0], 320) != FXL_OK) {
        return 1;
    }
    return !hud_draw(&whole, 320, 240, "01230", &colours);
}

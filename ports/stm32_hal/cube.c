/* SPDX-License-Identifier: MIT */
/* The cube turns on a display of 320 x 240. CubeMX's main calls cube_run after its own set-up. */
#include <fixel.h>
#include <fixel/display.h>
#include <fixel/pump.h>

#include "cube_scene.h" /* tools/scene.py export --c --frames 96 examples/cube/cube.obj -o cube_scene.h */
#include "fixel_stm32.h"

#define WIDTH  320
#define HEIGHT 240
#define ROWS   20 /* of a band; two of them are sent in turn */

static fxl_renderer renderer;
static uint64_t memory[CUBE_MEMORY];
static fxl_display display;
static fxl_pump pump;
static uint64_t pump_memory[FXL_PUMP_MEMORY(WIDTH, ROWS, 16)];

void cube_run(void);

void cube_run(void)
{
    const fxl_display_config module = fxl_display_config_default(&fxl_ili9341, 1);
    const fxl_pump_config bands = {&display.pixels, WIDTH, HEIGHT, ROWS, NULL};
    uint32_t frame;
    fxl_config view = cube_config;

    view.target = &fxl_palette; /* a byte a pixel */
    fixel_stm32_open();
    if (fxl_renderer_init(&renderer, &cube_scene, &view, memory, sizeof memory) != FXL_OK ||
        fxl_display_open(&display, &module, &fixel_stm32_port, cube_palette[0]) != FXL_OK ||
        fxl_pump_init(&pump, &bands, &display.sink, pump_memory, sizeof pump_memory) != FXL_OK) {
        return;
    }
    for (frame = 0;; frame = (frame + 1) % CUBE_FRAMES) {
        if (fxl_pump_frame(&pump, &renderer, &cube_path[frame]) != FXL_OK) {
            return;
        }
    }
}

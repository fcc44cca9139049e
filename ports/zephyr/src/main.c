/* SPDX-License-Identifier: MIT */
/* The cube turns on the display that the devicetree chooses, of 320 x 240. */
#include <fixel.h>

#include "cube_scene.h" /* tools/scene.py export --c --frames 96 examples/cube/cube.obj -o cube_scene.h */
#include "fixel_zephyr.h"

#define WIDTH  320
#define HEIGHT 240
#define ROWS   20 /* of a band */

/* In which order the display's driver wants the bytes of a pixel: most send them as they are, and then red comes first. */
#ifndef FIXEL_ZEPHYR_FORMAT
#define FIXEL_ZEPHYR_FORMAT fxl_pixels_rgb565 /* or fxl_pixels_rgb565_low */
#endif

static fxl_renderer renderer;
static uint64_t memory[CUBE_MEMORY];
static fxl_pixels colours;
static fixel_zephyr zephyr;
static fxl_pump pump;
static uint64_t pump_memory[FXL_PUMP_MEMORY(WIDTH, ROWS, 16)];

int main(void)
{
    const struct device *display = DEVICE_DT_GET(DT_CHOSEN(zephyr_display));
    const fxl_pump_config bands = {&colours, WIDTH, HEIGHT, ROWS, NULL};
    uint32_t frame;
    fxl_config view = cube_config;

    view.target = &fxl_palette; /* a byte a pixel */
    if (!fixel_zephyr_open(&zephyr, display, WIDTH) ||
        fxl_renderer_init(&renderer, &cube_scene, &view, memory, sizeof memory) != FXL_OK ||
        fxl_pixels_init(&colours, &FIXEL_ZEPHYR_FORMAT, cube_palette[0]) != FXL_OK ||
        fxl_pump_init(&pump, &bands, &zephyr.sink, pump_memory, sizeof pump_memory) != FXL_OK) {
        return 1;
    }
    for (frame = 0;; frame = (frame + 1) % CUBE_FRAMES) {
        if (fxl_pump_frame(&pump, &renderer, &cube_path[frame]) != FXL_OK) {
            return 1;
        }
    }
}

/* SPDX-License-Identifier: MIT */
/* A camera circles a cube, on the display that the devicetree chooses, of 320 x 240. A model of your own: its name instead of cube. */
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

static fxl_setup it;
static uint64_t memory[CUBE_SETUP_MEMORY(ROWS)];
static fxl_pixels colours;
static fixel_zephyr zephyr;
static fxl_pump pump;
static uint64_t pump_memory[FXL_PUMP_MEMORY_RGB565(WIDTH, ROWS, 16)];

int main(void)
{
    const struct device *display = DEVICE_DT_GET(DT_CHOSEN(zephyr_display));
    const fxl_pump_config bands = {&colours, WIDTH, HEIGHT, ROWS, cube_setup.config->palette};
    uint32_t frame;

    /* fxl_setup_explain has a sentence for each refusal */
    if (!fixel_zephyr_open(&zephyr, display, WIDTH) ||
        fxl_setup_init(&it, &cube_setup, ROWS, memory, sizeof memory) != FXL_OK ||
        fxl_pixels_init(&colours, &FIXEL_ZEPHYR_FORMAT, cube_setup.palette) != FXL_OK ||
        fxl_pump_init(&pump, &bands, &zephyr.sink, pump_memory, sizeof pump_memory) != FXL_OK) {
        return 1;
    }
    for (frame = 0;; frame++) {
        if (fxl_pump_frame(&pump, &it.renderer, fxl_setup_frame(&it, frame)) != FXL_OK) {
            return 1;
        }
    }
}

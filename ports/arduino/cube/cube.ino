/* SPDX-License-Identifier: MIT */
/* A camera circles a cube, on a display of 320 x 240. A model of your own: its name instead of cube. */
#include <fixel.h>
#include <fixel/display.h>
#include <fixel/pump.h>

#include "cube_scene.h" /* tools/scene.py export --c --frames 96 examples/cube/cube.obj -o cube_scene.h */
#include "fixel_arduino.h"

#define WIDTH  320
#define HEIGHT 240
#define ROWS   20 /* of a band; two of them are sent in turn */

static fxl_setup it;
static uint64_t memory[CUBE_SETUP_MEMORY(ROWS)];
static fxl_display display;
static fxl_pump pump;
static uint64_t pump_memory[FXL_PUMP_MEMORY_RGB565(WIDTH, ROWS, 16)];
static bool is_open;
static uint32_t frame;

void setup()
{
    fxl_pump_config bands = {&display.pixels, WIDTH, HEIGHT, ROWS, cube_setup.config->palette};
    const fxl_display_config module = fxl_display_config_default(&fxl_ili9341, 1);

    fixel_arduino_open();
    /* fxl_setup_explain has a sentence for each refusal */
    is_open = fxl_setup_init(&it, &cube_setup, ROWS, memory, sizeof memory) == FXL_OK &&
              fxl_display_open(&display, &module, &fixel_arduino_port, cube_setup.palette) == FXL_OK &&
              fxl_pump_init(&pump, &bands, &display.sink, pump_memory, sizeof pump_memory) == FXL_OK;
}

void loop()
{
    if (is_open) {
        is_open = fxl_pump_frame(&pump, &it.renderer, fxl_setup_frame(&it, frame)) == FXL_OK;
        frame++;
    }
}

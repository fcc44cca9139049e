/* SPDX-License-Identifier: MIT */
/* A cube that turns on a display of 320 x 240, slower or faster by two keys, with its speed as text
 * over it. */
#include <fixel.h>
#include <fixel/display.h>
#include <fixel/orientation.h>
#include <fixel/overlay.h>
#include <fixel/pump.h>

#include "cube_scene.h" /* tools/scene.py export --c examples/cube/cube.obj -o cube_scene.h */
#include "fixel_arduino.h"

#define WIDTH  320
#define HEIGHT 240
#define ROWS   20 /* of a band; two of them are sent in turn */

/* The pins of the keys. Each key joins its pin to GND. */
#define SLOWER  2
#define FASTER  3
#define FASTEST 15 /* degrees a frame */

static fxl_placement placement = FXL_PLACEMENT_NONE; /* how the cube is turned */
static fxl_setup it;
static uint64_t memory[CUBE_SETUP_MEMORY(ROWS)];
static fxl_display display;
static fxl_pump pump;
static uint64_t pump_memory[FXL_PUMP_MEMORY_RGB565(WIDTH, ROWS, 16)];
static bool is_open;
static fxl_angle angle;
static uint32_t speed = 3; /* degrees a frame */

void setup()
{
    const fxl_display_config module = fxl_display_config_default(&fxl_ili9341, 1);
    fxl_pump_config bands = {&display.pixels, WIDTH, HEIGHT, ROWS, cube_setup.config->palette};

    pinMode(SLOWER, INPUT_PULLUP);
    pinMode(FASTER, INPUT_PULLUP);
    fixel_arduino_open();
    is_open =
        fxl_setup_init(&it, &cube_setup, ROWS, memory, sizeof memory) == FXL_OK &&
        fxl_display_open(&display, &module, &fixel_arduino_port, cube_setup.palette) == FXL_OK &&
        fxl_pump_init(&pump, &bands, &display.sink, pump_memory, sizeof pump_memory) == FXL_OK;
    it.scene.placements = &placement; /* what the program moves stands in a table of its own */
    it.scene.first_turned = 0;
    it.scene.placement_code = &fxl_turned_instances;
}

static fxl_status turn()
{
    const fxl_point axis = {FXL_UNITS(1), FXL_UNITS(2), 0}; /* of any length */

    if (digitalRead(SLOWER) == LOW && speed > 0) {
        speed--;
    }
    if (digitalRead(FASTER) == LOW && speed < FASTEST) {
        speed++;
    }
    angle += speed * FXL_DEGREES(1); /* a full turn wraps to 0 */
    return fxl_orientation_from_axis(&axis, angle, &placement.orientation);
}

static bool draw()
{
    const fxl_text_style style = {&fxl_font_5x7, 5, 0}; /* in colour 5 of cube_palette */
    const char text[] = {
        'S', 'P', 'E', 'E', 'D', ' ', (char)('0' + speed / 10), (char)('0' + speed % 10), '\0'};
    bool is_good = fxl_frame_begin(&it.renderer, fxl_setup_frame(&it, 0)) == FXL_OK &&
                   fxl_pump_begin(&pump) == FXL_OK;

    while (is_good) {
        const fxl_band *band = fxl_pump_band(&pump);

        if (band == NULL) {
            break;
        }
        fxl_frame_fill(&it.renderer, band, cube_setup.config->background);
        is_good = fxl_frame_draw(&it.renderer, band) == FXL_OK &&
                  fxl_draw_text(band, 8, 8, text, &style) == FXL_OK &&
                  fxl_pump_send(&pump) == FXL_OK;
    }
    return fxl_frame_end(&it.renderer) == FXL_OK && is_good; /* the cube may turn again */
}

void loop()
{
    is_open = is_open && turn() == FXL_OK && draw();
}

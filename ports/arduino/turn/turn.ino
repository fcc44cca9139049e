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

static fxl_scene scene; /* a copy of the record; the tables stay in flash */
static fxl_placement placement = FXL_PLACEMENT_NONE; /* how the cube is turned */
static fxl_renderer renderer;
static uint64_t memory[CUBE_MEMORY];
static fxl_display display;
static fxl_pump pump;
static uint64_t pump_memory[FXL_PUMP_MEMORY(WIDTH, ROWS, 16)];
static bool is_open;
static fxl_angle angle;
static uint32_t speed = 3; /* degrees a frame */

void setup()
{
    const fxl_config config = fxl_config_default(WIDTH, HEIGHT);
    const fxl_display_config module = fxl_display_config_default(&fxl_ili9341, 1);
    fxl_pump_config bands = {&display.pixels, WIDTH, HEIGHT, ROWS, NULL};

    pinMode(SLOWER, INPUT_PULLUP);
    pinMode(FASTER, INPUT_PULLUP);
    fixel_arduino_open();
    scene = cube_scene;
    scene.placements = &placement;
    scene.placement_code = &fxl_turned_instances;
    is_open =
        fxl_renderer_init(&renderer, &scene, &config, memory, sizeof memory) == FXL_OK &&
        fxl_display_open(&display, &module, &fixel_arduino_port, cube_palette[0]) == FXL_OK &&
        fxl_pump_init(&pump, &bands, &display.sink, pump_memory, sizeof pump_memory) == FXL_OK;
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
    fxl_pose eye = {};
    bool is_good;

    eye.position = {0, FXL_UNITS(2), FXL_UNITS(-8)};
    eye.pitch = FXL_DEGREES(-12);
    is_good = fxl_frame_begin(&renderer, &eye) == FXL_OK && fxl_pump_begin(&pump) == FXL_OK;
    while (is_good) {
        const fxl_band *band = fxl_pump_band(&pump);

        if (band == NULL) {
            break;
        }
        fxl_fill_band(band, 0);
        is_good = fxl_frame_draw(&renderer, band) == FXL_OK &&
                  fxl_draw_text(band, 8, 8, text, &style) == FXL_OK &&
                  fxl_pump_send(&pump) == FXL_OK;
    }
    return fxl_frame_end(&renderer) == FXL_OK && is_good; /* the cube may turn again */
}

void loop()
{
    is_open = is_open && turn() == FXL_OK && draw();
}

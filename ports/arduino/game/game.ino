/* SPDX-License-Identifier: MIT */
/* The game of examples/game on a display of 320 x 240, with five keys. */
#include <fixel.h>
#include <fixel/display.h>
#include <fixel/player.h>
#include <fixel/pump.h>

#include "fixel_arduino.h"
#include "game.h"
#include "game_scene.h" /* tools/scene.py export --c examples/game/game.toml -o game_scene.h */

#define WIDTH  320
#define HEIGHT 240
#define ROWS   8 /* of a band */

/* Each key joins its pin to GND. */
static const struct {
    uint8_t pin;
    uint32_t key;
} keys[] = {{2, FXL_KEY_LEFT}, {3, FXL_KEY_RIGHT}, {4, FXL_KEY_PITCH_UP}, {5, FXL_KEY_PITCH_DOWN}, {6, FXL_KEY_FORWARD}};

static game state;
static fxl_renderer renderer;
static uint64_t memory[GAME_MEMORY + 128]; /* the world has room for more than the scene's instances */
static fxl_display display;
static fxl_pump pump;
static uint64_t pump_memory[FXL_PUMP_MEMORY(WIDTH, ROWS, 16)];
static bool is_open;

void setup()
{
    fxl_pump_config bands = {&display.pixels, WIDTH, HEIGHT, ROWS, NULL};
    const fxl_display_config module = fxl_display_config_default(&fxl_ili9341, 1);

    for (const auto &each : keys) {
        pinMode(each.pin, INPUT_PULLUP);
    }
    fixel_arduino_open();
    is_open = game_begin(&state, &game_scene, &game_start) == FXL_OK &&
              fxl_renderer_init(&renderer, &state.world.scene, &game_config, memory, sizeof memory) == FXL_OK &&
              fxl_world_attach(&state.world, &renderer) == FXL_OK &&
              fxl_display_open(&display, &module, &fixel_arduino_port, game_palette[0]) == FXL_OK &&
              fxl_pump_init(&pump, &bands, &display.sink, pump_memory, sizeof pump_memory) == FXL_OK;
}

static uint32_t keys_held()
{
    uint32_t held = 0;

    for (const auto &each : keys) {
        held |= digitalRead(each.pin) == LOW ? each.key : 0;
    }
    /* when it is over, any key begins again */
    if (state.lives == 0 && held != 0) {
        held = FXL_KEY_BACK;
    }
    return held;
}

static bool draw()
{
    bool is_good = fxl_frame_begin(&renderer, &state.eye) == FXL_OK && fxl_pump_begin(&pump) == FXL_OK;

    while (is_good) {
        const fxl_band *band = fxl_pump_band(&pump);

        if (band == NULL) {
            break;
        }
        fxl_fill_band(band, game_config.background);
        is_good = fxl_frame_draw(&renderer, band) == FXL_OK &&
                  game_draw_over(&state, band, WIDTH, HEIGHT) == FXL_OK && fxl_pump_send(&pump) == FXL_OK;
    }
    return fxl_frame_end(&renderer) == FXL_OK && is_good; /* the world may change again */
}

void loop()
{
    is_open = is_open && game_step(&state, keys_held()) == FXL_OK && draw();
}

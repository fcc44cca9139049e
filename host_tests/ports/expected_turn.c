/* SPDX-License-Identifier: MIT */
/* The palette and the first frames of the cube that turns, as the library draws them in one piece,
 * entries of the palette or RGB565, on standard output. The number of the key's pin that is held is
 * in HELD_PIN. */
#include <fixel.h>
#include <fixel/orientation.h>
#include <fixel/overlay.h>
#include <stdio.h>
#include <stdlib.h>

#include "cube_scene.h"

static fxl_setup it;
static uint64_t memory[CUBE_SETUP_MEMORY(240)];
static uint16_t pixels[240][320];

static bool draw(fxl_orientation *orientation, uint32_t angle, const char *text)
{
    const fxl_band screen = {.pixels = (uint8_t *)pixels[0],
                             .width = 320,
                             .stride = 320,
                             .rows = 240,
                             .palette = it.renderer.palette};
    const fxl_text_style style = {.font = &fxl_font_5x7, .colour = 5};
    const fxl_point axis = {1, 2, 0};

    return fxl_orientation_from_axis(&axis, angle, orientation) == FXL_OK &&
           fxl_render(&it.renderer, fxl_setup_frame(&it, 0), pixels[0], 320) == FXL_OK &&
           fxl_draw_text(&screen, 8, 8, text, &style) == FXL_OK;
}

int main(void)
{
    static const struct {
        uint32_t angles[3];
        const char *texts[3];
    } expected[] = {{{FXL_DEGREES(1) * 3, FXL_DEGREES(1) * 6, FXL_DEGREES(1) * 9},
                     {"SPEED 03", "SPEED 03", "SPEED 03"}},
                    {{FXL_DEGREES(1) * 2, FXL_DEGREES(1) * 3, FXL_DEGREES(1) * 3},
                     {"SPEED 02", "SPEED 01", "SPEED 00"}},
                    {{FXL_DEGREES(1) * 4, FXL_DEGREES(1) * 9, FXL_DEGREES(1) * 15},
                     {"SPEED 04", "SPEED 05", "SPEED 06"}}};
    const char *held = getenv("HELD_PIN");
    const int which = held == NULL ? 0 : atoi(held) == 2 ? 1 : 2;
    fxl_placement placement = FXL_PLACEMENT_NONE;

    if (fxl_setup_init(&it, &cube_setup, 240, memory, sizeof memory) != FXL_OK) {
        return 1;
    }
    it.scene.placements = &placement;
    it.scene.placement_code = &fxl_turned_instances;
    (void)fwrite(cube_palette, 1, sizeof cube_palette, stdout);
    for (int frame = 0; frame < 3; frame++) {
        if (!draw(&placement.orientation, expected[which].angles[frame],
                  expected[which].texts[frame])) {
            return 1;
        }
        (void)fwrite(pixels, cube_config.target->pixel_bits / 8u, 320 * 240, stdout);
    }
    return 0;
}

/* SPDX-License-Identifier: MIT */
/* Cubes that one program puts up at run time: each in a colour of its own, by one lamp, in fog. */
#include <fixel.h>
#include <fixel/light.h>
#include <fixel/world.h>
#include "cube_scene.h" /* tools/scene.py export --c examples/cube/cube.obj -o cube_scene.h */

#define SIDE   12 /* cubes in a row */
#define HUES   8
#define SHADES 32 /* of each hue, from dark to full */
#define CUBES  (SIDE * SIDE + 1) /* and the scene's own */

static fxl_renderer renderer;
static fxl_world world;
static fxl_light light;
static fxl_world_colours recolouring;
static fxl_instance instances[CUBES];
static fxl_world_slot slots[CUBES];
static uint8_t colours[HUES * 256], ramp[FXL_LIGHT_RAMP_BYTES(SHADES)];
static uint64_t memory[8192];
static uint8_t pixels[240][320]; /* entries of the palette */
static uint8_t palette[256][3];  /* shade s of hue h is entry SHADES * h + s */

static void make_colours(void)
{
    static const uint8_t hues[HUES][3] = {{232, 96, 72},  {240, 168, 64}, {232, 216, 96},  {120, 200, 96},
                                          {80, 192, 192}, {96, 144, 240}, {168, 112, 232}, {232, 120, 184}};
    static const uint8_t dark[3] = {24, 20, 44};
    for (int i = 0; i < 256; i++) {
        const int hue = i / SHADES, shade = i % SHADES;
        for (int k = 0; k < 3; k++) {
            palette[i][k] = (uint8_t)(dark[k] + (hues[hue][k] - dark[k]) * shade / (SHADES - 1));
        }
        for (int table = 0; table < HUES; table++) { /* all of a cube in the brightest shade */
            colours[256 * table + i] = (uint8_t)(SHADES * table + SHADES - 1);
        }
        for (int level = 0; level < SHADES; level++) {
            ramp[256 * level + i] = (uint8_t)(SHADES * hue + level);
        }
    }
}

static int put_up_cubes(void)
{
    for (int i = 0; i < SIDE * SIDE; i++) {
        const int across = i % SIDE, along = i / SIDE;
        const fxl_instance cube = {
            {FXL_UNITS(5 * across - 27), FXL_RATIO((across * 7 + along * 3) % 5, 2), FXL_UNITS(5 * along)}, 0, 0, 0};
        fxl_handle handle;
        if (fxl_world_spawn(&world, &cube, NULL, &handle) != FXL_OK ||
            fxl_world_recolour(&world, handle, 1 + (uint32_t)(across + along) % HUES) != FXL_OK) {
            return 1;
        }
    }
    return fxl_world_remove(&world, fxl_world_handle(0)); /* the scene's own cube */
}

int main(void)
{
    const fxl_config config = fxl_config_default(320, 240);
    const fxl_pose eye = {{FXL_UNITS(4), FXL_UNITS(9), FXL_UNITS(-14)}, FXL_DEGREES(-6), FXL_DEGREES(-18), 0};
    const fxl_world_memory room = {instances, slots, NULL, CUBES, 0, colours, HUES, NULL};
    const fxl_light_settings lamp = {.ambient = FXL_Q2_30_ONE / 6,
                                     .points = {{{0, FXL_UNITS(12), FXL_UNITS(10)}, FXL_UNITS(45), FXL_Q2_30_ONE}},
                                     .point_count = 1,
                                     .fog_near = FXL_UNITS(20),
                                     .fog_far = FXL_UNITS(75),
                                     .ramp = ramp,
                                     .levels = SHADES};
    make_colours();
    if (fxl_world_init(&world, &cube_scene, &room) != FXL_OK ||
        fxl_renderer_init(&renderer, &world.scene, &config, memory, sizeof memory) != FXL_OK ||
        fxl_world_attach(&world, &renderer) != FXL_OK || put_up_cubes() != 0 ||
        fxl_world_set_colours(&world, &renderer, &recolouring) != FXL_OK ||
        fxl_attach_light(&renderer, &light, &lamp) != FXL_OK ||
        fxl_render(&renderer, &eye, pixels[0], 320) != FXL_OK) {
        return 1;
    }
    return fxl_frame_end(&renderer); /* the world may change again */
}

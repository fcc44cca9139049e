/* SPDX-License-Identifier: MIT */
/* The game on a display of the library, with no board of this project: it is drawn in bands of
 * eight rows, and a band is sent while the next one is drawn. */
#include "on_display.h"

#define WIDTH 320
#define ROWS  8
#define ORDER 200 /* entries: the game's faces and instances */
#define BITS  16  /* of a pixel, at most */

static game state;
static fxl_scene_image image;
static fxl_draw_entry order[ORDER];
static fxl_renderer renderer;
static fxl_display display;
static fxl_pump pump;
static uint64_t memory[FXL_PUMP_MEMORY(WIDTH, ROWS, BITS)];

static fxl_status open_game(const void *scene, size_t scene_size)
{
    const fxl_memory of = {.draw_list = order, .draw_list_capacity = ORDER};
    fxl_status status = fxl_scene_open(scene, scene_size, &image, NULL);

    if (status == FXL_OK) {
        status = game_begin(&state, &image.scene, &image.start.pose);
    }
    if (status == FXL_OK) {
        status = fxl_renderer_init_with(&renderer, &state.world.scene, &image.lens, &of);
    }
    return status == FXL_OK ? fxl_world_attach(&state.world, &renderer) : status;
}

static fxl_status open_display(const fxl_display_config *module, const fxl_display_port *port)
{
    const fxl_lens *lens = &image.lens;
    const fxl_pump_config bands = {&display.pixels, lens->width, lens->height, ROWS, NULL};
    fxl_status status = fxl_display_open(&display, module, port, image.palette);

    if (status == FXL_OK) {
        status = fxl_display_place(&display, lens->width, lens->height);
    }
    return status == FXL_OK ? fxl_pump_init(&pump, &bands, &display.sink, memory, sizeof memory)
                            : status;
}

static fxl_status draw_frame(void)
{
    fxl_status status = fxl_frame_begin(&renderer, &state.eye), ended;

    if (status == FXL_OK) {
        status = fxl_pump_begin(&pump);
    }
    for (const fxl_band *band; status == FXL_OK && (band = fxl_pump_band(&pump)) != NULL;) {
        fxl_frame_fill(&renderer, band, image.background);
        status = fxl_frame_draw(&renderer, band);
        if (status == FXL_OK) {
            status = game_draw_over(&state, band, image.lens.width, image.lens.height);
        }
        if (status == FXL_OK) {
            status = fxl_pump_send(&pump);
        }
    }
    ended = fxl_frame_end(&renderer); /* the world may change again */
    return status == FXL_OK ? ended : status;
}

fxl_status game_on_display(const void *scene, size_t scene_size, const fxl_display_config *module,
                           const fxl_display_port *port, bool (*next_keys)(uint32_t *keys))
{
    uint32_t keys;
    fxl_status status = open_game(scene, scene_size);

    if (status == FXL_OK) {
        status = open_display(module, port);
    }
    while (status == FXL_OK && next_keys(&keys)) {
        status = game_step(&state, keys);
        if (status == FXL_OK) {
            status = draw_frame();
        }
    }
    return status == FXL_OK ? fxl_pump_wait(&pump) : status;
}

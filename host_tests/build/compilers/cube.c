/* SPDX-License-Identifier: MIT */
/* A cube as letters, for any compiler: C11 and C++11 alike, and no header of a C library. */
#include <fixel.h>

#include "put_text.h"

#define WIDTH  64
#define HEIGHT 28
#define U      FXL_Q16_16_ONE
#define N      FXL_Q2_30_ONE

static const fxl_point vertices[] = {{-U, -U, -U}, {U, -U, -U}, {U, U, -U}, {-U, U, -U},
                                     {-U, -U, U},  {U, -U, U},  {U, U, U},  {-U, U, U}};
static const uint16_t indices[] = {0, 3, 2, 1, 5, 6, 7, 4, 4, 7, 3, 0,
                                   1, 2, 6, 5, 3, 7, 6, 2, 4, 0, 1, 5};
static const fxl_face faces[] = {
    {{0, 0, -N}, 4, '.', FXL_INDICES_AT(0, 0)}, {{0, 0, N}, 4, 'b', FXL_INDICES_AT(5, 4)},
    {{-N, 0, 0}, 4, 'l', FXL_INDICES_AT(4, 8)}, {{N, 0, 0}, 4, '#', FXL_INDICES_AT(1, 12)},
    {{0, N, 0}, 4, '-', FXL_INDICES_AT(3, 16)}, {{0, -N, 0}, 4, 'u', FXL_INDICES_AT(4, 20)}};
static const fxl_model models[] = {{0, 8, 0, 6, FXL_MODEL_CONVEX, 0, 0, 2 * U, 0}};
static const fxl_instance instances[] = {{{0, 0, 0}, 0, 0, 0}};

static fxl_scene scene;
static fxl_renderer renderer;
static fxl_draw_entry order[1];
static uint32_t list[6 * FXL_DISPLAY_LIST_WORDS(4)];
static fxl_cached_vertex cache[8];
static uint8_t pixels[HEIGHT][WIDTH];

static fxl_status draw(void)
{
    const fxl_memory memory = {order, 1, list, sizeof list / sizeof list[0], cache, 8};
    const fxl_band band = {
        .pixels = pixels[0], .width = WIDTH, .stride = WIDTH, .first_row = 0, .rows = HEIGHT};
    const fxl_pose pose = {{2 * U, 2 * U, -4 * U}, 0xEB000000u, 0xEE000000u, 0};
    fxl_lens lens;
    scene.vertices = vertices;
    scene.indices = indices;
    scene.faces = faces;
    scene.models = models;
    scene.instances = instances;
    scene.vertex_count = 8;
    scene.index_count = 24;
    scene.face_count = 6;
    scene.model_count = 1;
    scene.instance_count = 1;
    fxl_status status = fxl_scene_check(&scene, NULL);
    if (status == FXL_OK) {
        status = fxl_lens_from_fov(WIDTH, HEIGHT, FXL_ANGLE_QUARTER, U / 4, 99 * U, 4, &lens);
    }
    if (status == FXL_OK) {
        status = fxl_renderer_init_with(&renderer, &scene, &lens, &memory);
    }
    if (status == FXL_OK) {
        status = fxl_frame_begin(&renderer, &pose);
    }
    if (status == FXL_OK) {
        fxl_fill_band(&band, ' ');
        status = fxl_frame_draw(&renderer, &band);
    }
    return status;
}

int main(void)
{
    fxl_status status = draw();
    if (status != FXL_OK) {
        put_text(fxl_status_text(status));
        put_text("\n");
        return 1;
    }
    for (int y = 0; y < HEIGHT; y++) {
        char row[WIDTH + 2];
        for (int x = 0; x < WIDTH; x++) {
            row[x] = FXL_CAST(char, pixels[y][x]);
        }
        row[WIDTH] = '\n';
        row[WIDTH + 1] = '\0';
        put_text(row);
    }
    return 0;
}

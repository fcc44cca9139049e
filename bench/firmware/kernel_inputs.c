/* SPDX-License-Identifier: MIT */
#include "kernels.h"

static uint64_t state = 0x9E3779B97F4A7C15u;

/* Marsaglia's xorshift, 64 bits. */
static uint64_t any(void)
{
    state ^= state << 13;
    state ^= state >> 7;
    state ^= state << 17;
    return state;
}

static int32_t between(int32_t low, int32_t high)
{
    return low + (int32_t)((any() >> 16) % (uint32_t)(high - low + 1));
}

/* A point of the view z away, at part / 65536 of the half screen from its
 * middle, in units of 2^-46. */
static fxl_view_point view_point(int32_t part_x, int32_t part_y, fxl_q16_16 z)
{
    fxl_view_point point;
    point.z = (int64_t)z * FXL_Q2_30_ONE;
    point.x = point.z / 65536 * part_x;
    point.y = point.z / 65536 * part_y * 3 / 4;
    return point;
}

/* A quad about a point of the screen; its size is in parts of the half screen. */
static void view_quad(int32_t x, int32_t y, int32_t size, fxl_view_polygon *quad)
{
    static const int8_t corners[4][2] = {{-1, 1}, {1, 1}, {1, -1}, {-1, -1}};
    quad->colour = 1;
    quad->count = 4;
    for (uint32_t i = 0; i < 4; i++) {
        fxl_view_vertex *vertex = &quad->vertices[i];
        vertex->position = view_point(x + size * corners[i][0], y + size * corners[i][1],
                                      between(2 * 65536, 10 * 65536));
    }
}

/* A quad on the screen with one vertex each at the top, right, bottom and left. */
static void screen_quad(fxl_screen_polygon *quad)
{
    int32_t x = between(80 * 65536, 240 * 65536), y = between(80 * 65536, 160 * 65536);
    int32_t wide = between(8 * 65536, 60 * 65536), high = between(10 * 65536, 30 * 65536);
    quad->colour = 1;
    quad->count = 4;
    quad->points[0] = (fxl_screen_point){x + wide / 3, y - high};
    quad->points[1] = (fxl_screen_point){x + wide, y - high / 4};
    quad->points[2] = (fxl_screen_point){x - wide / 2, y + high};
    quad->points[3] = (fxl_screen_point){x - wide, y + high / 5};
}

void kernel_inputs_make(kernel_inputs *inputs)
{
    fxl_pose pose = {{-23592, -1966, 19660}, 0x23456789u, 0xF3456789u, 0};
    fxl_lens lens;
    fxl_lens_from_fov(320, 240, FXL_ANGLE_QUARTER, 4096, 64 * 65536, 4, &lens);
    fxl_view_set_lens(&inputs->view, &lens);
    fxl_view_set_pose(&inputs->view, &pose);
    const fxl_model model = {.vertex_count = KERNEL_COUNT};
    const fxl_instance instance = {.centre = {0, 0, 0}};
    const fxl_scene scene = {.vertices = inputs->points, .models = &model};
    fxl_vertex_cache_init(&inputs->cache, NULL, 0);
    fxl_model_view_of_instance(&inputs->placed, &scene, &instance, &inputs->view, &inputs->cache);
    for (uint32_t i = 0; i < KERNEL_COUNT; i++) {
        inputs->angles[i] = (fxl_angle)any();
        inputs->wide[i] = any();
        inputs->numerators[i] = (int64_t)any() >> 5;
        inputs->depths[i] = (int64_t)(((uint64_t)1 << 30) + (any() >> 34));
        inputs->heights[i] = (uint32_t)between(20000, 60 * 65536);
        inputs->dividends[i] = between(-60 * 65536, 60 * 65536);
        inputs->points[i] = (fxl_point){between(-524288, 524288), between(-524288, 524288),
                                        between(-524288, 524288)};
        inputs->seen[i] = view_point(between(-60000, 60000), between(-60000, 60000),
                                     between(2 * 65536, 10 * 65536));
        view_quad(between(-40000, 40000), between(-40000, 40000), between(2000, 20000),
                  &inputs->inside[i]);
        view_quad(-65536 + between(-4000, 4000), between(-40000, 40000), 12000, &inputs->across[i]);
        screen_quad(&inputs->quads[i]);
    }
    for (uint32_t x = 0; x < KERNEL_ROW; x++) {
        inputs->noise[x] = (uint8_t)(x * 37u);
        inputs->run[x] = 9;
    }
}
